// Poses as lines of a rig, and in words.
#include "app/calibration/rig_lines.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <random>
#include <string>

#include "app/simulated_calibration.h"

namespace carom {
namespace {

using test::calibratedRig;
using test::turnBetween_deg;

// What is printed for a rig, read as a rig, is what was found: whatever the turn and the unit.
TEST(Calibration, ItsLinesMeanWhatItFound) {
  std::mt19937_64 random(9);
  std::normal_distribution<double> one;
  for (int i = 0; i < 300; ++i) {
    const double w = one(random), x = one(random), y = one(random), z = one(random);
    glm::dquat q = glm::normalize(glm::dquat(w, x, y, z));
    // Some with their x along z, where two of the turns are one.
    if (i % 3 == 0)
      q = glm::angleAxis(one(random), glm::dvec3(1, 0, 0)) *
          glm::angleAxis(glm::radians(i % 2 == 0 ? 90.0 : -90.0), glm::dvec3(0, 1, 0));
    const Pose pose{{3.0 * one(random), 3.0 * one(random), 3.0 * one(random)}, q};
    const std::string unit = i % 2 == 0 ? "m" : "mm";
    const std::string line = poseLine("room_from_tracker", pose, i % 2 == 0 ? 1.0 : 1e-3);
    const Rig rig = readRig("rig.toml", calibratedRig(line, "", unit));
    const Pose& read = rig.trackers[0].roomFromTracker;
    EXPECT_LT(glm::distance(read.position_m, pose.position_m), 1e-5) << line;  // 0.005 mm a coordinate
    EXPECT_LT(turnBetween_deg(read.orientation, pose.orientation), 0.002) << line;
  }
}

TEST(Calibration, SaysWhereTheAxesPoint) {
  const RoomAxes axes;
  EXPECT_EQ(directionWords({1, 0, 0, 0}, axes),
            "x to the right (0.0 degrees off), y up (0.0 degrees off), z back (0.0 degrees off)");
  const glm::dquat zUp = glm::angleAxis(glm::radians(-88.0), glm::dvec3(1, 0, 0));
  EXPECT_EQ(directionWords(zUp, axes),
            "x to the right (0.0 degrees off), y ahead (2.0 degrees off), z up (2.0 degrees off)");
}

// A hundredth of a millimetre in every unit, without zeros at the end.
TEST(Calibration, LengthsHaveAHundredthOfAMillimetre) {
  EXPECT_EQ(lengthText(1.23456789, 1.0), "1.23457");
  EXPECT_EQ(lengthText(1.23456789, 1e-2), "123.457");
  EXPECT_EQ(lengthText(1.23456789, 1e-3), "1234.57");
  EXPECT_EQ(lengthText(1.5, 1.0), "1.5");
  EXPECT_EQ(lengthText(-2.0, 1e-3), "-2000.0");
  EXPECT_EQ(lengthText(-1e-9, 1.0), "0.0") << "there is no length below nothing";
}

}  // namespace
}  // namespace carom
