// Two people in one room play the same game: no stroke of either changes what either has seen.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "app/hand/ray_picking.h"
#include "app/live/live_source.h"
#include "app/play/hit_seen.h"
#include "app/rig/rig.h"
#include "app/scenario/scenario.h"
#include "app/scenario/starting_histories.h"
#include "app/session/game_settings.h"
#include "cave/frame/bodies.h"
#include "cave/frame/pacer.h"
#include "engine/light/point_emission.h"
#include "engine/random_world.h"
#include "log_lines.h"
#include "places.h"

namespace carom {
namespace {

constexpr double kHz = 20.0;

/// A game at the desk for two, in simulated time.
class GameForTwo {
 public:
  /// `change`: what is otherwise in the rig.
  explicit GameForTwo(const char* scenario, void (*change)(Rig&) = nullptr)
      : rig_(readRig(CAROM_CONFIG_DIR "/rigs/desk-two.toml")), scenario_(readScenario(scenario)) {
    rig_.display_hz = kHz;
    if (change) change(rig_);
    world_ = {startingHistories(scenario_), {}};
    source_ = std::make_unique<LiveSource>(rig_, scenario_, world_, LiveStart{});
    settings_ = settingsAtStart(rig_, scenario_);
  }

  const FrameRecord& record() const { return decision_.frame.record; }

 protected:
  /// Decides the next frame, and makes it part of the world.
  void decide(const DeskInput& desk) {
    decision_.beginFrame();
    source_->next(pacer_.next(), {{}, desk}, settings_, decision_);
  }
  void apply() {
    applyFrame(decision_.frame, world_);
    pacer_.awaitTick(0.0);
    pacer_.swapped();
  }

  Rig rig_;
  Scenario scenario_;
  World world_;
  SimulatedClock clock_;
  Pacer pacer_{clock_, kHz, 0.0, false, 0};
  std::unique_ptr<LiveSource> source_;
  OperatorSettings settings_;
  Decision decision_;
};

/// Two hands with a mouse each, in turn: aim at a puck as it is seen, hold it, draw back, let go.
class TwoHands : public GameForTwo {
 public:
  explicit TwoHands(std::uint64_t seed)
      : GameForTwo(CAROM_CONFIG_DIR "/scenarios/table.toml"), random_(seed) {}

  /// Plays one frame; `check` is called with the game before and after each frame that changes it backwards.
  template <typename Check>
  void step(Check check) {
    const FrameRecord before = record();
    decide(number_ == 0 ? DeskInput{} : hand(before));
    for (const HandStroke& stroke : decision_.strokes) ++strokes_.at(stroke.viewer);
    const bool changes = number_ > 0 && std::isfinite(decision_.frame.record.truncateFrom_s);
    const World known = changes ? world_ : World{};
    apply();
    if (changes) check(before, known, world_);
    ++number_;
  }

  const std::array<std::size_t, 2>& strokes() const { return strokes_; }
  std::size_t pucks() const { return scenario_.billiard.pucks.size(); }
  double radius_m() const { return scenario_.billiard.pucks.front().radius_m; }

 private:
  static constexpr long kOfStroke = 20, kHoldsFrom = 3, kDrawsFrom = 6, kLetsGoAt = 14;  // frames

  DeskInput hand(const FrameRecord& before) {
    const long frame = number_ % kOfStroke;
    if (frame == 1) {
      viewer_ = 1 - viewer_;
      puck_ = static_cast<std::size_t>(random_.in(0.0, 0.999 * static_cast<double>(pucks())));
      pull_m_ = random_.in(0.05, 0.5);
      turn_rad_ = random_.in(-std::numbers::pi, std::numbers::pi);
    }
    DeskInput desk;
    const ObserverView& observer = before.viewers[viewer_].observer;
    const EyeView& eye = observer.middle;
    if (frame <= kDrawsFrom) {
      aimed_m_ =
          aim_.seenInRoom_m(world_.histories[kFirstPuck + puck_], {observer, Eye::middle, before.switches});
    }
    Vec3 along = aimed_m_ - eye.positionInRoom_m;
    if (frame >= kDrawsFrom) along += pull_m_ * Vec3(std::cos(turn_rad_), 0.0, std::sin(turn_rad_));
    desk.mouse = PointedWall{eye.positionInRoom_m + glm::normalize(along), Eye::middle, viewer_};
    desk.mouseHeld = frame >= kHoldsFrom && frame < kLetsGoAt;
    return desk;
  }

  test::Random random_;
  RayPicking aim_;
  long number_ = 0;
  std::size_t viewer_ = 1, puck_ = 0;
  double pull_m_ = 0.0, turn_rad_ = 0.0;
  Vec3 aimed_m_{0.0};
  std::array<std::size_t, 2> strokes_{};
};

/// Expects that an eye has seen the same of a puck's point in both games, bit for bit.
void expectSeenTheSame(const WorldLine& before, const WorldLine& after, const Vec3& offset_m,
                       const EyeView& eye, const Lorentz& headFromBoard) {
  const auto had = PointEmission(before, offset_m).seenAt(eye.observation, headFromBoard);
  const auto has = PointEmission(after, offset_m).seenAt(eye.observation, headFromBoard);
  ASSERT_EQ(had.has_value(), has.has_value());
  if (!had) return;
  EXPECT_EQ(had->event.t_s, has->event.t_s);
  EXPECT_EQ(had->event.r_m, has->event.r_m);
  EXPECT_EQ(had->doppler, has->doppler);
  EXPECT_EQ(had->properTime_s, has->properTime_s);
}

TEST(TwoHands, NinetyStrokesChangeNothingThatEitherHadSeen) {
  const test::LogLines log;
  TwoHands room(19);
  std::size_t changes = 0, looks = 0;
  const auto check = [&](const FrameRecord& before, const World& known, const World& world) {
    ++changes;
    for (std::size_t viewer = 0; viewer < before.viewerCount; ++viewer) {
      const ObserverView& observer = before.viewers[viewer].observer;
      for (const EyeView& eye : observer.all()) {
        for (std::size_t puck = kFirstPuck; puck < kFirstPuck + room.pucks(); ++puck) {
          for (const double side : {-1.0, 0.0, 1.0}) {
            expectSeenTheSame(known.histories[puck], world.histories[puck],
                              {side * room.radius_m(), 0.0, 0.0}, eye, observer.headFromBoard);
            ++looks;
          }
        }
      }
    }
  };
  for (int frame = 0; frame < 4000 && room.strokes()[0] + room.strokes()[1] < 90; ++frame) room.step(check);
  EXPECT_GE(room.strokes()[0] + room.strokes()[1], 90U);
  EXPECT_GT(room.strokes()[0], 30U);
  EXPECT_GT(room.strokes()[1], 30U);
  EXPECT_GE(changes, 30U) << "strokes that change what was known but not seen";
  EXPECT_EQ(looks, changes * 2 * 3 * 3 * 3);
  const FrameRecord& record = room.record();
  ASSERT_EQ(record.viewerCount, 2U);
  EXPECT_EQ(record.viewers[0].score.strokes, room.strokes()[0]);
  EXPECT_EQ(record.viewers[1].score.strokes, room.strokes()[1]);
  EXPECT_EQ(record.viewers[0].hasTurn + record.viewers[1].hasTurn, 1);
}

// Two heads at rest 1 m and 2 m from a hit see it 1 m of light apart.
TEST(TwoHands, WhoIsNearerSeesAHitFirst) {
  constexpr double c_m_s = 1.42, kStep_s = 0.05;
  HitSeen hit;
  hit.struck(0, 1.0);
  GameEvent event;
  event.kind = EventKind::puckPuck;
  event.at = {2.0, Vec3(0.0)};
  event.turns.push_back(Turn());
  FrameRecord record;
  record.viewerCount = 2;
  record.boardFromRoom = Lorentz(c_m_s);
  std::optional<std::span<const HitSeen::Seen>> told;
  for (int frame = 0; frame < 100 && !told; ++frame) {
    record.room_s = frame * kStep_s;
    record.viewers[0].observer.middle.observation = {record.room_s, Vec3(2.0, 0.0, 0.0)};
    record.viewers[1].observer.middle.observation = {record.room_s, Vec3(0.0, 1.0, 0.0)};
    told = hit.look({&event, 1}, record);
  }
  ASSERT_TRUE(told);
  ASSERT_EQ(told->size(), 2U);
  EXPECT_EQ((*told)[0].viewer, 1U);
  EXPECT_EQ((*told)[1].viewer, 0U);
  EXPECT_NEAR((*told)[0].room_s, 2.0 + 1.0 / c_m_s, 1e-9);
  EXPECT_NEAR((*told)[1].room_s, 2.0 + 2.0 / c_m_s, 1e-9);
  EXPECT_FALSE(hit.look({&event, 1}, record)) << "told once";
}

/// Two people at rest at the desk for two, in this game.
class TwoAtRest : public GameForTwo {
 public:
  explicit TwoAtRest(const char* scenario, bool secondHasWand = false)
      : GameForTwo(scenario, secondHasWand ? oneWithWand : personsAtRest) {}

  const FrameRecord& frame(const DeskInput& desk = {}) {
    decide(desk);
    apply();
    return record();
  }

 private:
  static void personsAtRest(Rig& rig) {
    for (TrackerSetup& tracker : rig.trackers) tracker.person = SimulatedMotion::still;
  }
  static void oneWithWand(Rig& rig) {
    personsAtRest(rig);
    rig.viewers[1].hand = HandSetup{};
  }
};

// The thrust to the right is felt by whoever steers; the other's clock goes at the rate 1 + g·r/c² (r: to the
// right).
TEST(TwoHands, TheThrustIsThatOfWhoeverSteers) {
  for (const std::size_t steers : {0U, 1U}) {
    TwoAtRest two(CAROM_CONFIG_DIR "/scenarios/table.toml");
    FrameRecord record = two.frame();
    DeskInput desk;
    desk.mouse = PointedWall{record.viewers[steers].observer.middle.positionInRoom_m + Vec3(0, 0, -1),
                             Eye::middle, steers};
    desk.steer = Vec3(1, 0, 0);
    for (int i = 0; i < 20; ++i) record = two.frame(desk);
    EXPECT_EQ(record.viewers[steers].lapse, 1.0) << steers;
    EXPECT_GT((record.viewers[1 - steers].lapse - 1.0) * (steers == 0 ? 1.0 : -1.0), 1e-3) << steers;
  }
}

TEST(TwoHands, EverybodyReadsTheCaptions) {
  TwoAtRest two(CAROM_CONFIG_DIR "/scenarios/welcome.toml");
  std::size_t captions = 0;
  for (int i = 0; i < 400; ++i) {
    const FrameRecord& record = two.frame();
    EXPECT_EQ(record.viewers[1].notice.words(), record.viewers[0].notice.words()) << i;
    captions += record.viewers[0].notice.words().empty() ? 0 : 1;
  }
  EXPECT_GT(captions, 0U);
}

TEST(TwoHands, WhoeverHasAWandReadsWhatAWandDoes) {
  TwoAtRest two(CAROM_CONFIG_DIR "/scenarios/welcome.toml", true);
  two.frame();
  const FrameRecord& record = two.frame();
  EXPECT_EQ(record.viewers[0].notice.words().find("trigger"), std::string::npos);
  EXPECT_NE(record.viewers[1].notice.words().find("trigger"), std::string::npos);
}

}  // namespace
}  // namespace carom
