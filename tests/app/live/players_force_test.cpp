// A session with a simulated force device: draws in rapidity, the force of the record, the blow in the frame
// in which it is seen, and what the session file gets to know.
#include "app/live/players.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <fstream>

#include <glm/geometric.hpp>

#include "app/scenario/starting_histories.h"
#include "app/temporary_folder.h"
#include "app/viewer/room_motion.h"
#include "cave/audio/heard.h"
#include "cave/texts/texts.h"
#include "log_lines.h"
#include "places.h"

namespace carom {
namespace {

using test::TemporaryFolder;

constexpr const char* kTable =
    "title = \"t\"\nlight_speed_m_s = 1.42\n[observer]\nposition_m = [0.0, -1.7, -0.75]\n[board]\nlength_m = "
    "2.84\n"
    "width_m = 1.42\n[[puck]]\nname = \"white\"\nradius_m = 0.0305\nheight_m = 0.02\nmass_kg = 0.2\n"
    "position_m = [0.0, -0.2]\nbeta = [0.0, 0.0]\n";

class PlayersWithForce : public testing::Test {
 protected:
  PlayersWithForce() {
    inputs_.play(scenario_);
    settings_.lightSpeed_m_s = scenario_.billiard.lightSpeed_m_s;
  }
  static Rig forceRig(bool hasForce = true) {
    Rig rig = readRig(CAROM_CONFIG_DIR "/rigs/desk.toml");
    for (TrackerSetup& tracker : rig.trackers) {
      tracker.kind = TrackerKind::simulated;
      tracker.person = SimulatedMotion::still;
    }
    if (hasForce) rig.viewers.front().force = ForceSetup{};
    return rig;
  }

  /// Lives one frame: hands, what is seen, the game, as LiveSource does.
  FrameRecord& live(const DeskInput& desk) {
    const double now_s = static_cast<double>(++number_) / 60.0;
    const FrameTimes times{number_, now_s, now_s, 1.0 / 60.0};
    const DriveWish wish = inputs_.take(desk, false, times);
    decision_.beginFrame();
    FrameRecord& record = decision_.frame.record = {};
    decision_.frame.knots.clear();
    decision_.frame.events.clear();
    record.number = number_;
    record.display_s = now_s;
    record.lightSpeed_m_s = settings_.lightSpeed_m_s;
    const ObserverViews views = room_.advance({times, 0.064, 1.0, wish});
    room_.viewers().putInto(record);
    record.viewers[0].observer = views[0];
    record.boardFromRoom = room_.viewers().boardFromRoom();
    Players::feel(world_, inputs_, record);
    players_.act({settings_, false, true}, room_.viewers(), inputs_, game_, announcements_, decision_);
    players_.see(world_, settings_, announcements_, decision_);
    game_.advance(latestObservation_s(record), decision_.frame);
    applyFrame(decision_.frame, world_);
    return record;
  }
  /// The desk's mouse over the puck as it was seen in the frame before, drawn back by `pull_m`.
  DeskInput aimed(bool held, double pull_m) {
    const FrameRecord& record = decision_.frame.record;
    const EyeView& eye = record.viewers[0].observer.middle;
    if (!held) {
      puck_m_ =
          aim_.seenInRoom_m(game_.pucks()[0], {record.viewers[0].observer, Eye::middle, record.switches});
    }
    DeskInput desk;
    desk.mouse = PointedWall{
        eye.positionInRoom_m + glm::normalize(puck_m_ + Vec3(0.0, 0.0, pull_m) - eye.positionInRoom_m),
        Eye::middle};
    desk.mouseHeld = held;
    return desk;
  }
  std::size_t notesOf(std::string_view what) const {
    return static_cast<std::size_t>(std::count_if(decision_.notes.begin(), decision_.notes.end(),
                                                  [&](const Note& note) { return note.what == what; }));
  }
  /// Draws slowly, and holds.
  FrameRecord& draw(double pull_m) {
    live({});
    live(aimed(false, 0.0));
    for (int frame = 0; frame < 3; ++frame) live(aimed(true, 0.0));
    FrameRecord* record = nullptr;
    for (int frame = 1; frame <= 90; ++frame)
      record = &live(aimed(true, pull_m * std::min(1.0, frame / 30.0)));
    return *record;
  }

  const TemporaryFolder folder_;
  const test::LogLines log_;
  const Rig rig_ = forceRig();
  const Scenario scenario_ = readScenario(folder_.file("table.toml", kTable));
  World world_{startingHistories(scenario_), {}, {}};
  PlayerInputs inputs_{rig_};
  RoomMotion room_{rig_, scenario_, inputs_.trackers(rig_, std::chrono::steady_clock::time_point()), {}};
  Game game_{scenario_};
  Announcements announcements_{rig_, scenario_, {}};
  Players players_{rig_, scenario_, {}};
  OperatorSettings settings_;
  Decision decision_;
  RayPicking aim_;
  Vec3 puck_m_{0.0};
  std::uint64_t number_ = 0;
};

// The hand wants to draw 12 cm; the force pulls it forward, and the stroke is that of the draw that is left.
TEST_F(PlayersWithForce, ADrawIsMeasuredInRapidityAndYieldsToItsForce) {
  const FrameRecord& record = draw(0.12);
  const ViewerState& own = record.viewers[0];
  ASSERT_EQ(own.hand.pulling, 1);
  ASSERT_EQ(own.force.shown, 1);
  const double drawn_m = 0.08 * std::asinh(own.hand.u), rest_j = 0.2 * 1.42 * 1.42;
  EXPECT_LT(drawn_m, 0.115);
  EXPECT_GT(drawn_m, 0.08);
  const CueForce cue{rest_j, 0.08, forceScale(rest_j, 0.08, limitsOf(ForceSetup{}))};
  EXPECT_EQ(own.force.scale, cue.scale);
  // At rest the force of the law is that with which the simulated hand pulls, 250 N/m times what it lacks.
  EXPECT_NEAR(glm::length(own.force.force_n), cue.force_n(drawn_m), 0.02);
  // It wants to draw farther by the ray that goes on from the puck's middle to the cloth.
  const double eye_m = own.observer.middle.positionInRoom_m.y - 0.75, puck_m = puck_m_.y - 0.75;
  const double wanted_m = 0.12 * eye_m / (eye_m - puck_m);
  EXPECT_NEAR(glm::length(own.force.force_n), 250.0 * (wanted_m - drawn_m), 0.05);
  EXPECT_NEAR(glm::dot(glm::normalize(own.force.force_n), own.hand.towards), 1.0, 1e-3) << "towards the puck";
}

TEST_F(PlayersWithForce, WithoutADeviceTheDrawIsAsBefore) {
  const Rig plain = forceRig(false);
  PlayerInputs inputs(plain);
  inputs.play(scenario_);
  EXPECT_EQ(inputs.force(0), nullptr);
  EXPECT_EQ(HandInput().d0_m, 0.0);
  const Lorentz still{1.42};
  EXPECT_NEAR(glm::length(strokeOf({0.0, 0.15, 0.0}, still).u), 1.0, 1e-12);
  EXPECT_NEAR(glm::length(strokeOf({0.0, 0.08, 0.0}, still, 0.08).u), std::sinh(1.0), 1e-12);
  EXPECT_EQ(glm::length(strokeOf({0.0, 0.5, 0.0}, still, 0.02).u), kStrongestU);
  EXPECT_EQ(glm::length(strokeOf({0.0, 0.002, 0.0}, still, 0.02).u), 0.0) << "hardly drawn: no stroke";
}

// Sounds are found by another program part; there is one puck, so each sound is a blow.
TEST_F(PlayersWithForce, ABlowIsFeltInTheFrameInWhichItIsSeen) {
  draw(0.12);
  std::size_t blows = 0, draws = notesOf("force draw");
  bool isStruck = false;
  std::vector<Heard> heard;
  for (int frame = 0; frame < 600; ++frame) {
    const ObserverView before = decision_.frame.record.viewers[0].observer;
    const std::vector<GameEvent> known = world_.events;
    FrameRecord& record = live(frame == 0 ? aimed(false, 0.12) : DeskInput{});
    isStruck = isStruck || !decision_.strokes.empty();
    draws += notesOf("force draw");
    heardBetween(before, record.viewers[0].observer, record.switches, known, heard);
    // A stroke sounds when the hand makes it, and is felt when it arrives.
    const auto contacts = static_cast<std::size_t>(std::count_if(
        heard.begin(), heard.end(), [](const Heard& sound) { return sound.kind != EventKind::stroke; }));
    bool arrives = false;
    for (const GameEvent& event : known) {
      if (event.kind != EventKind::stroke) continue;
      const Event& at = event.turns.front().event;
      const auto isSeen = [&](const ObserverView& view) {
        const Event& eye = view.middle.observation;
        return 1.42 * (eye.t_s - at.t_s) >= glm::distance(eye.r_m, at.r_m);
      };
      arrives = arrives || (isSeen(record.viewers[0].observer) && !isSeen(before));
    }
    EXPECT_EQ(notesOf("force pulse"), contacts + (arrives ? 1 : 0)) << "frame " << frame;
    blows += notesOf("force pulse");
    if (frame > 0) {
      EXPECT_EQ(glm::length(record.viewers[0].force.force_n) > 0.0 && frame > 3, false)
          << "no button, no force";
    }
  }
  EXPECT_TRUE(isStruck);
  EXPECT_GE(blows, 3u) << "its arrival and some cushions";
  EXPECT_GE(draws, 1u);
}

}  // namespace
}  // namespace carom
