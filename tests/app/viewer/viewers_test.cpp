// Two people whose heads one tracker follows, when it fails one of them: both clocks go on.
#include "app/viewer/viewers.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <memory>
#include <utility>

#include "app/fed_tracker.h"
#include "app/rig/rig.h"
#include "app/scenario/scenario.h"
#include "places.h"

namespace carom {
namespace {

constexpr double kStep_s = 1.0 / 60.0, kEyes_m = 1.7;

/// Anna and Ben, sensors 0 and 1 of the first tracker of the desk for two.
class SharedTracker : public testing::Test {
 protected:
  static constexpr std::size_t kAnna = 0, kBen = 1;

  SharedTracker()
      : rig_(readRig(CAROM_CONFIG_DIR "/rigs/desk-two.toml")),
        scenario_(readScenario(CAROM_CONFIG_DIR "/scenarios/table.toml")) {
    rig_.trackers[0].roomFromTracker = {};
    rig_.viewers[kBen].head.sensor = {.tracker = 0, .sensor = 1};
    auto tracker = std::make_unique<test::FedTracker>();
    fed_ = tracker.get();
    feed(0.0, 0.5);
    SharedTrackers trackers(rig_, std::chrono::steady_clock::time_point());
    trackers.take(0, std::move(tracker));
    viewers_.emplace(rig_, scenario_, std::move(trackers));
  }

  /// Delivers Anna's head at x and Ben's at x, both at z = 0.
  void feed(double anna_m, double ben_m) {
    fed_->fed = {test::at(0, {anna_m, kEyes_m, 0.0}), test::at(1, {ben_m, kEyes_m, 0.0})};
  }
  void lose(int sensor) {
    std::erase_if(fed_->fed, [sensor](const TrackerSample& sample) { return sample.sensor == sensor; });
  }
  /// Plays one frame and notes what each one's clock has gained in it.
  void step() {
    const double begin_s = static_cast<double>(++number_) * kStep_s;
    const ObserverViews views = viewers_->at({number_, begin_s, begin_s + kStep_s, kStep_s}, 0.064);
    for (std::size_t i = 0; i < 2; ++i) {
      gained_s_[i] = views[i].properTime_s - clock_s_[i];
      clock_s_[i] = views[i].properTime_s;
    }
  }
  double place_m(std::size_t viewer) const { return viewers_->head(viewer).pose.position_m.x; }

  Rig rig_;
  Scenario scenario_;
  test::FedTracker* fed_ = nullptr;
  std::optional<Viewers> viewers_;
  std::uint64_t number_ = 0;
  std::array<double, 2> clock_s_{}, gained_s_{};
};

constexpr double kRounding_s = 1e-12;

// Anna walks at 0.6 m/s, Ben stands. While Ben's sensor is lost his head is held where it was, and his clock
// goes on as that of somebody who stands: ahead of hers by γ.
TEST_F(SharedTracker, WhoStandsIsHeldWhenLostAndHisClockGoesOn) {
  constexpr double kWalk_m_s = 0.6;
  for (int frame = 0; frame < 240; ++frame) {
    feed(kWalk_m_s * frame * kStep_s, 0.5);
    if (frame >= 60) lose(1);
    step();
    ASSERT_NEAR(std::min(gained_s_[kAnna], gained_s_[kBen]), kStep_s, kRounding_s) << "frame " << frame;
    ASSERT_NEAR(place_m(kBen), 0.5, 1e-6) << "frame " << frame;
  }
  EXPECT_EQ(viewers_->head(kBen).known, Known::lost);
  EXPECT_EQ(viewers_->head(kAnna).known, Known::predicted);
  const double gamma = std::hypot(1.0, kWalk_m_s / scenario_.billiard.lightSpeed_m_s);
  EXPECT_NEAR(gained_s_[kAnna], kStep_s, kRounding_s);
  EXPECT_NEAR(gained_s_[kBen], gamma * kStep_s, 1e-3 * kStep_s);
}

// Heads that are kept still stay where they were, and their clocks go as those of people who stand, whatever
// the tracker says; let go, they are where the tracker has them.
TEST_F(SharedTracker, HeadsAreKeptStill) {
  for (int frame = 0; frame < 60; ++frame) step();
  const Vec3 before_m = viewers_->head(kAnna).pose.position_m;
  viewers_->hold(true);
  for (int frame = 0; frame < 120; ++frame) {
    feed(0.6 * frame * kStep_s, 0.5);
    step();
    ASSERT_EQ(viewers_->head(kAnna).pose.position_m, before_m) << "frame " << frame;
    ASSERT_EQ(viewers_->head(kAnna).celerity_m_s, Vec3(0.0)) << "frame " << frame;
    ASSERT_NEAR(gained_s_[kAnna], gained_s_[kBen], kRounding_s) << "frame " << frame;
  }
  viewers_->hold(false);
  step();
  EXPECT_NEAR(place_m(kAnna), 0.6 * 119 * kStep_s, 0.05);
}

// Lost while she walks, Anna is held and stands for the clocks: both age alike.
TEST_F(SharedTracker, WhoWalksIsHeldWhenLostAndBothClocksGoOnAlike) {
  constexpr double kWalk_m_s = 0.6;
  constexpr int kHidden = 60, kRests = kHidden + static_cast<int>(kTrackLost_s / kStep_s) + 2;  // frames
  double held_m = 0.0;
  for (int frame = 0; frame < 240; ++frame) {
    feed(kWalk_m_s * frame * kStep_s, 0.5);
    if (frame >= kHidden) lose(0);
    step();
    if (frame == kRests) held_m = place_m(kAnna);
    if (frame <= kRests) continue;
    ASSERT_EQ(place_m(kAnna), held_m) << "frame " << frame;
    ASSERT_NEAR(gained_s_[kAnna], kStep_s, kRounding_s) << "frame " << frame;
    ASSERT_NEAR(gained_s_[kBen], kStep_s, kRounding_s) << "frame " << frame;
  }
  EXPECT_EQ(viewers_->head(kAnna).known, Known::lost);
  EXPECT_EQ(viewers_->head(kBen).known, Known::predicted);
  EXPECT_GT(clock_s_[kBen], clock_s_[kAnna] + 0.05) << "she walked for a second before";
}

// A sample 2 m away, alone, is no walk: nobody's clock gains by it.
TEST_F(SharedTracker, AGlitchDrivesNobodysClock) {
  for (int frame = 0; frame < 120; ++frame) {
    feed(frame == 60 ? 2.0 : 0.0, 0.5);
    step();
    for (const double gained_s : gained_s_) ASSERT_NEAR(gained_s, kStep_s, kRounding_s) << "frame " << frame;
  }
}

// A tracker that is set up anew puts a head 2 m away at once. The shown head slides there at 1 m/s, which is
// the most that it drives the other's clock by; the step itself, at 120 m/s, is no motion.
TEST_F(SharedTracker, AStepIsNoFasterForTheClocksThanItsSlide) {
  constexpr double kStepped_m = 2.0, kSlide_m_s = 1.0;
  const double most = std::hypot(1.0, kSlide_m_s / scenario_.billiard.lightSpeed_m_s);
  for (int frame = 0; frame < 300; ++frame) {
    feed(frame >= 60 ? kStepped_m : 0.0, 0.5);
    step();
    ASSERT_NEAR(gained_s_[kAnna], kStep_s, kRounding_s) << "frame " << frame;
    ASSERT_GE(gained_s_[kBen], kStep_s - kRounding_s) << "frame " << frame;
    ASSERT_LE(gained_s_[kBen], most * kStep_s * (1.0 + 1e-6)) << "frame " << frame;
  }
  EXPECT_NEAR(place_m(kAnna), kStepped_m, 1e-6);
  EXPECT_LE(clock_s_[kBen] - clock_s_[kAnna], (most - 1.0) * (kStepped_m / kSlide_m_s) * (1.0 + 1e-6));
}

TEST(SimulatedPeople, WalkEachInAWayOfTheirOwn) {
  Rig rig = readRig(CAROM_CONFIG_DIR "/rigs/desk-two.toml");
  EXPECT_EQ(rig.trackers[0].seed, 1U);
  EXPECT_EQ(rig.trackers[1].seed, 2U);
  rig.trackers[1].person = rig.trackers[0].person;
  rig.trackers[1].roomFromTracker = rig.trackers[0].roomFromTracker;
  Viewers viewers(rig, readScenario(CAROM_CONFIG_DIR "/scenarios/table.toml"), {});
  double farthest_m = 0.0;
  for (std::uint64_t frame = 1; frame <= 240; ++frame) {
    const double begin_s = static_cast<double>(frame) * kStep_s;
    viewers.at({frame, begin_s, begin_s + kStep_s, kStep_s}, 0.064);
    farthest_m =
        std::max(farthest_m, glm::distance(viewers.head(0).pose.position_m, viewers.head(1).pose.position_m));
  }
  EXPECT_GT(farthest_m, 0.2);
}

}  // namespace
}  // namespace carom
