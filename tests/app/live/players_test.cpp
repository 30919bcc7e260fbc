// What the players do: strokes change the match, a carom is counted when it is seen, the best shot is shown
// again.
#include "app/live/players.h"

#include <gtest/gtest.h>

#include <chrono>

#include "app/viewer/room_motion.h"
#include "cave/texts/texts.h"
#include "log_lines.h"
#include "places.h"

namespace carom {
namespace {

class PlayersAtRest : public testing::Test {
 protected:
  PlayersAtRest() {
    inputs_.play(scenario_);
    settings_.lightSpeed_m_s = scenario_.billiard.lightSpeed_m_s;
  }
  static Rig deskRig() {
    Rig rig = readRig(CAROM_CONFIG_DIR "/rigs/desk.toml");
    for (TrackerSetup& tracker : rig.trackers) tracker.person = SimulatedMotion::still;
    return rig;
  }

  /// Lets the hand act in one frame of the room at rest.
  FrameRecord& act(const DeskInput& desk, bool mayStrike = true) {
    const double now_s = static_cast<double>(++number_) / 60.0;
    const FrameTimes times{number_, now_s, now_s, 1.0 / 60.0};
    const DriveWish wish = inputs_.take(desk, false, times);
    decision_.beginFrame();
    FrameRecord& record = decision_.frame.record = {};
    record.display_s = now_s;
    record.lightSpeed_m_s = settings_.lightSpeed_m_s;
    const ObserverViews views = room_.advance({times, 0.064, 1.0, wish});
    room_.viewers().putInto(record);
    record.viewers[0].observer = views[0];
    players_.act({settings_, false, mayStrike}, room_.viewers(), inputs_, game_, announcements_, decision_);
    return record;
  }
  /// The desk's mouse over the first puck as it was seen in the frame before, drawn back by `pull_m`.
  DeskInput aimed(bool held, double pull_m) {
    const FrameRecord& record = decision_.frame.record;
    const EyeView& eye = record.viewers[0].observer.middle;
    const Vec3 puck_m =
        aim_.seenInRoom_m(game_.pucks()[0], {record.viewers[0].observer, Eye::middle, record.switches});
    DeskInput desk;
    desk.mouse = PointedWall{
        eye.positionInRoom_m + glm::normalize(puck_m + Vec3(0.0, 0.0, pull_m) - eye.positionInRoom_m),
        Eye::middle};
    desk.mouseHeld = held;
    return desk;
  }
  /// Draws the cue back and lets go.
  FrameRecord& strike(bool mayStrike = true) {
    act({}, mayStrike);
    act(aimed(false, 0.0), mayStrike);
    for (int frame = 0; frame < 3; ++frame) act(aimed(true, 0.0), mayStrike);
    for (int frame = 1; frame <= 5; ++frame) act(aimed(true, 0.05 * frame), mayStrike);
    return act(aimed(false, 0.25), mayStrike);
  }

  const test::LogLines log_;
  const Rig rig_ = deskRig();
  Scenario scenario_ = readScenario(CAROM_CONFIG_DIR "/scenarios/table.toml");
  PlayerInputs inputs_{rig_};
  RoomMotion room_{rig_, scenario_, inputs_.trackers(rig_, std::chrono::steady_clock::time_point()), {}};
  Game game_{scenario_};
  Announcements announcements_{rig_, scenario_, {}};
  Players players_{rig_, scenario_, {}};
  OperatorSettings settings_;
  Decision decision_;
  RayPicking aim_;
  std::uint64_t number_ = 0;
};

TEST_F(PlayersAtRest, AStrokeIsCountedAndNoted) {
  const FrameRecord& record = strike();
  ASSERT_EQ(decision_.strokes.size(), 1U);
  EXPECT_EQ(decision_.strokes[0].stroke.puck, 0U);
  EXPECT_EQ(record.viewers[0].score.strokes, 1U);
}

/// The desk's mouse, this far beside a place that lies in front of the eye.
DeskInput beside(const EyeView& eye, const Vec3& place_m, double aside_m, bool held) {
  const Vec3 way_m = place_m - eye.positionInRoom_m;
  const Vec3 right = glm::normalize(glm::cross(way_m, Vec3(0.0, 1.0, 0.0)));
  DeskInput desk;
  desk.mouse = PointedWall{eye.positionInRoom_m + glm::normalize(way_m + aside_m * right), Eye::middle};
  desk.mouseHeld = held;
  return desk;
}

// The ring around the puck that a newcomer is offered is 12 cm in radius, the puck 5 cm.
TEST_F(PlayersAtRest, APressWithinTheRingTakesTheRingedPuckAndOneBesideItDoesNot) {
  scenario_.choices = true;
  for (const auto& [aside_m, takes] : {std::pair{0.09, true}, {0.14, false}}) {
    SCOPED_TRACE(aside_m);
    act({});
    const auto press = [&](bool held) {
      const ViewerState& own = decision_.frame.record.viewers[0];
      const Vec3 puck_m =
          aim_.seenInRoom_m(game_.pucks()[0], {own.observer, Eye::middle, decision_.frame.record.switches});
      return act(beside(own.observer.middle, puck_m, aside_m, held)).viewers[0].hand;
    };
    press(false);
    press(true);
    EXPECT_EQ(press(true).pulling != 0, takes);
    press(false);
  }
}

TEST_F(PlayersAtRest, WhileTimeStandsNothingIsStruck) {
  const FrameRecord& record = strike(false);
  EXPECT_TRUE(decision_.strokes.empty());
  EXPECT_EQ(record.viewers[0].score.strokes, 0U);
}

TEST_F(PlayersAtRest, ThereIsNoBestShotBeforeACarom) {
  act({});
  const Command show = ShowBestShot{false};
  players_.showBestShot(std::span(&show, 1), false, announcements_, decision_);
  EXPECT_FALSE(decision_.showsShot);
  EXPECT_EQ(players_.shot(1.0), nullptr);
  ASSERT_EQ(decision_.notes.size(), 1U);
  EXPECT_EQ(decision_.notes[0].value, texts::message::kNoCarom.english());
  const Command keep = ShowBestShot{.isKept = true};
  players_.showBestShot(std::span(&keep, 1), false, announcements_, decision_);
  EXPECT_FALSE(decision_.keepsShot);
}

}  // namespace
}  // namespace carom
