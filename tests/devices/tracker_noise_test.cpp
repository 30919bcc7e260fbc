#include "devices/tracker_noise.h"

#include <gtest/gtest.h>

#include <random>

namespace carom {
namespace {

struct Noise {
  explicit Noise(double standardDeviation_m) : normal(0.0, standardDeviation_m) {}
  glm::dvec3 operator()() {
    const double x = normal(random), y = normal(random), z = normal(random);
    return {x, y, z};
  }
  std::mt19937_64 random{11};
  std::normal_distribution<double> normal;
};

constexpr double kRelative = 0.15;  // two seconds of samples tell a standard deviation that well

TEST(TrackerNoise, IsFoundFromAStillSensorAtAnyRate) {
  for (const double rate_hz : {30.0, 60.0, 240.0}) {
    for (const double sigma_m : {0.00005, 0.0003, 0.003}) {
      TrackerNoise estimate(0.0003);
      Noise noise(sigma_m);
      for (int i = 0; i < 15 * rate_hz; ++i) estimate.add(i / rate_hz, glm::dvec3(1, 2, 3) + noise());
      EXPECT_NEAR(estimate.sigma_m() / sigma_m, 1.0, kRelative) << rate_hz << " Hz, " << sigma_m << " m";
    }
  }
}

TEST(TrackerNoise, IsFoundWithUnevenTimes) {
  TrackerNoise estimate(0.001);
  Noise noise(0.0003);
  std::uniform_real_distribution<double> uniform(0.004, 0.030);
  double time_s = 0.0;
  for (int i = 0; i < 900; ++i) estimate.add(time_s += uniform(noise.random), noise());
  EXPECT_NEAR(estimate.sigma_m() / 0.0003, 1.0, kRelative);
}

TEST(TrackerNoise, StaysAsItIsWhileTheSensorMoves) {
  TrackerNoise estimate(0.0003);
  Noise noise(0.003);
  for (int i = 0; i < 600; ++i) estimate.add(i / 60.0, glm::dvec3(i / 60.0 * 2.0, 0, 0) + noise());
  EXPECT_EQ(estimate.sigma_m(), 0.0003);
}

TEST(TrackerNoise, SaysWhetherTheSensorIsStill) {
  TrackerNoise estimate(0.0003);
  Noise noise(0.0003);
  EXPECT_FALSE(estimate.isStill());  // nothing is known yet
  for (int i = 0; i < 300; ++i) estimate.add(i / 60.0, noise());
  EXPECT_TRUE(estimate.isStill());
  for (int i = 0; i < 30; ++i) estimate.add(5.0 + i / 60.0, glm::dvec3(i / 60.0 * 0.1, 0, 0) + noise());
  EXPECT_FALSE(estimate.isStill());
}

TEST(TrackerNoise, HasALeastValue) {
  TrackerNoise estimate(0.0003);
  for (int i = 0; i < 6000; ++i) estimate.add(i / 60.0, glm::dvec3(1, 2, 3));
  EXPECT_EQ(estimate.sigma_m(), 0.00001);
}

}  // namespace
}  // namespace carom
