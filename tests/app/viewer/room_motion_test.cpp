// The room on its way: viewers and platform start together, and move together.
#include "app/viewer/room_motion.h"

#include <gtest/gtest.h>

#include <chrono>

#include "places.h"

namespace carom {
namespace {

constexpr double kHz = 60.0;

class MovingRoom : public testing::Test {
 protected:
  static Rig deskRig() {
    Rig rig = readRig(CAROM_CONFIG_DIR "/rigs/desk.toml");
    for (TrackerSetup& tracker : rig.trackers) tracker.person = SimulatedMotion::still;
    return rig;
  }
  /// Plays frames while the platform is steered to the right or not at all.
  ObserverView frames(int count, double steer = 0.0) {
    ObserverView view;
    DriveWish wish;
    wish.steer = {steer, 0.0, 0.0};
    for (int frame = 0; frame < count; ++frame) {
      const double display_s = static_cast<double>(++number_) / kHz;
      const FrameTimes times{number_, display_s, display_s, 1.0 / kHz};
      view = room_.advance({times, 0.064, 1.0, wish})[0];
    }
    return view;
  }
  double speed_u() const { return glm::length(room_.viewers().boardFromRoom().u()); }

  Rig rig_ = deskRig();
  const Scenario scenario_ = readScenario(CAROM_CONFIG_DIR "/scenarios/table.toml");
  RoomMotion room_{rig_, scenario_, SharedTrackers(rig_, std::chrono::steady_clock::time_point()), {}};
  std::uint64_t number_ = 0;
};

TEST_F(MovingRoom, StartsAnewWithThePlatformAtRestAndNoTimeLived) {
  frames(60, 1.0);
  EXPECT_GT(speed_u(), 0.01);
  EXPECT_GT(glm::length(room_.drive().thrust), 0.5);
  room_.start();
  EXPECT_EQ(speed_u(), 0.0);
  EXPECT_EQ(room_.drive().thrust, Vec3(0.0));
  EXPECT_NEAR(frames(1).properTime_s, 1.0 / kHz, 1e-12);
}

TEST_F(MovingRoom, StartsOnTheWayThatItIsGivenAtThatTime) {
  ObserverStart start = scenario_.observer;
  start.beta = {0.6, 0.0, 0.0};
  room_.startAt(start, 2.0);
  EXPECT_NEAR(room_.viewers().board_s(), 2.0, 1e-9);
  EXPECT_NEAR(speed_u(), 0.75, 1e-12) << "γβ at 0.6 c";
  frames(60);
  EXPECT_NEAR(room_.viewers().board_s(), 2.0 + 1.25, 1e-3)
      << "γ seconds of the board in one of one's own; the tracker's noise moves the head a little";
}

TEST_F(MovingRoom, RunsToATimeOfTheBoardAndThenStands) {
  room_.runTo(1.5);
  EXPECT_NEAR(room_.viewers().board_s(), 1.5, 1e-8);
  const FrameTimes times{1, 0.1, 0.1, 1.0 / kHz};
  for (int frame = 0; frame < 10; ++frame)
    EXPECT_NEAR(room_.stand({times, 0.064})[0].middle.observation.t_s, 1.5, 1e-8);
}

}  // namespace
}  // namespace carom
