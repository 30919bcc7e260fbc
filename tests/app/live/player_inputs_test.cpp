// The devices of two players: whose the desk is, and who steers.
#include "app/live/player_inputs.h"

#include <gtest/gtest.h>

#include "places.h"

namespace carom {
namespace {

class InputsOfTwo : public testing::Test {
 protected:
  InputsOfTwo() { inputs_.play(readScenario(CAROM_CONFIG_DIR "/scenarios/table.toml")); }

  DriveWish take(const DeskInput& desk, double step_s = 0.1) {
    return inputs_.take(desk, false, {number_++, 0.0, 0.0, step_s});
  }
  static DeskInput over(std::size_t viewer, double steer) {
    DeskInput desk;
    desk.mouse = PointedWall{{0.0, 1.0, -1.0}, Eye::middle, viewer};
    desk.steer = {steer, 0.0, 0.0};
    return desk;
  }

  const Rig rig_ = readRig(CAROM_CONFIG_DIR "/rigs/desk-two.toml");
  PlayerInputs inputs_{rig_};
  std::uint64_t number_ = 0;
};

TEST_F(InputsOfTwo, TheDeskBelongsToTheOneOverWhoseWallsTheMouseWasLast) {
  take(over(1, 1.0));
  EXPECT_EQ(inputs_.steering(), 1U);
  DeskInput keys;
  keys.steer = {1.0, 0.0, 0.0};
  take(keys);
  EXPECT_EQ(inputs_.steering(), 1U) << "the mouse has left the walls";
  take(over(0, 0.0));
  EXPECT_EQ(inputs_.steering(), 1U) << "who does not steer does not take over";
  EXPECT_FALSE(inputs_.asksToSteer());
  take(over(0, -1.0));
  EXPECT_EQ(inputs_.steering(), 0U);
  EXPECT_TRUE(inputs_.asksToSteer());
}

TEST_F(InputsOfTwo, TheThrustSetsInSoftlyAndEndsAtOnce) {
  double before = 0.0;
  for (int frame = 0; frame < 5; ++frame) {
    const double thrust = take(over(0, 1.0)).steer.x;
    EXPECT_NEAR(thrust - before, 0.2, 1e-12) << "half a second until it is whole";
    before = thrust;
  }
  EXPECT_EQ(take(over(0, 1.0)).steer.x, 1.0);
  EXPECT_EQ(take(over(0, 0.0)).steer.x, 0.0);
  EXPECT_NEAR(take(over(0, 1.0)).steer.x, 0.2, 1e-12);
}

TEST_F(InputsOfTwo, TheWayHomeIsAskedForOnce) {
  inputs_.letGo(0, true);
  EXPECT_TRUE(take(over(0, 0.0)).home);
  EXPECT_FALSE(take(over(0, 0.0)).home);
}

}  // namespace
}  // namespace carom
