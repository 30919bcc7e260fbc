// Rests in recordings that are made up here, so that their times and places are known.

#include "devices/calibration/rests.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <random>

namespace carom {
namespace {

/// Writes what a sensor does, at 60 Hz.
class Walk {
 public:
  explicit Walk(double sigma_m, std::uint64_t seed = 1) : noise_(0.0, sigma_m), random_(seed) {}

  Walk& stay(double seconds) {
    for (const double end_s = time_s_ + seconds; time_s_ < end_s; time_s_ += 1.0 / 60.0) add();
    return *this;
  }
  /// Goes there in a straight line.
  Walk& go(const glm::dvec3& to_m, double speed_m_s = 0.5) {
    const glm::dvec3 from_m = at_m_;
    const double length_m = glm::distance(from_m, to_m);
    for (double gone_m = 0.0; gone_m < length_m; gone_m += speed_m_s / 60.0) {
      at_m_ = from_m + (to_m - from_m) * (gone_m / length_m);
      add();
      time_s_ += 1.0 / 60.0;
    }
    at_m_ = to_m;
    return *this;
  }
  Walk& glitch(int samples) {
    for (int i = 0; i < samples; ++i) {
      add(glm::dvec3(0.4, 0.0, 0.0));
      time_s_ += 1.0 / 60.0;
    }
    return *this;
  }
  Walk& silence(double seconds) {
    time_s_ += seconds;
    return *this;
  }
  const std::vector<TrackerSample>& samples() const { return samples_; }

 private:
  void add(const glm::dvec3& off_m = glm::dvec3(0.0)) {
    const double x = noise_(random_), y = noise_(random_), z = noise_(random_);
    TrackerSample sample;
    sample.time_s = time_s_;
    sample.pose.position_m = at_m_ + off_m + glm::dvec3(x, y, z);
    samples_.push_back(sample);
  }

  std::normal_distribution<double> noise_;
  std::mt19937_64 random_;
  double time_s_ = 0.0;
  glm::dvec3 at_m_{0.0};
  std::vector<TrackerSample> samples_;
};

TEST(Rests, EachStayIsOneRestAtItsPlace) {
  Walk walk(0.001);
  walk.stay(1.5).go({1, 0, 0}).stay(1.0).go({1, 2, 0}).stay(0.4).go({0, 2, 0}).stay(2.0);
  const auto rests = restsOf(walk.samples(), glm::dvec3(0.0));
  ASSERT_EQ(rests.size(), 3u);  // 0.4 s are too short
  const glm::dvec3 expected_m[] = {{0, 0, 0}, {1, 0, 0}, {0, 2, 0}};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_LT(glm::distance(rests[i].at_m, expected_m[i]), 0.001) << "rest " << i;
    EXPECT_NEAR(rests[i].spread_m, 0.001 * std::sqrt(3.0), 0.0005) << "rest " << i;
  }
  EXPECT_NEAR(rests[1].end_s - rests[1].begin_s, 1.0, 0.1);
}

TEST(Rests, AGlitchDoesNotEndAStay) {
  Walk walk(0.0005);
  walk.stay(0.6).glitch(3).stay(0.6);
  const auto rests = restsOf(walk.samples(), glm::dvec3(0.0));
  ASSERT_EQ(rests.size(), 1u);
  EXPECT_LT(glm::length(rests[0].at_m), 0.0005);
}

TEST(Rests, ASilenceAndAWayEndAStay) {
  Walk silent(0.0005);
  silent.stay(1.0).silence(0.5).stay(1.0);
  EXPECT_EQ(restsOf(silent.samples(), glm::dvec3(0.0)).size(), 2u);
  Walk away(0.0005);
  away.stay(1.0).go({0.2, 0, 0}).go({0, 0, 0}).stay(1.0);
  EXPECT_EQ(restsOf(away.samples(), glm::dvec3(0.0)).size(), 2u);
  Walk slipped(0.0005);  // by 8 mm on the same corner
  slipped.stay(1.0).go({0.008, 0, 0}).stay(1.0);
  EXPECT_EQ(restsOf(slipped.samples(), glm::dvec3(0.0)).size(), 1u);
}

// A tool that turns about its tip rests at its tip.
TEST(Rests, ThePointCountsNotTheSensor) {
  std::vector<TrackerSample> samples;
  const glm::dvec3 tip_m(0.0, 0.0, -0.2);
  for (int i = 0; i < 120; ++i) {
    TrackerSample sample;
    sample.time_s = i / 60.0;
    sample.pose.orientation = glm::angleAxis(0.3 * std::sin(i / 10.0), glm::dvec3(1, 0, 0));
    sample.pose.position_m = -(sample.pose.orientation * tip_m);
    samples.push_back(sample);
  }
  EXPECT_EQ(restsOf(samples, tip_m).size(), 1u);
  EXPECT_EQ(restsOf(samples, glm::dvec3(0.0)).size(), 0u);
}

TEST(Rests, NoRestWhereNothingRests) {
  EXPECT_TRUE(restsOf({}, glm::dvec3(0.0)).empty());
  Walk walk(0.001);
  walk.go({3, 0, 0}, 0.2);
  EXPECT_TRUE(restsOf(walk.samples(), glm::dvec3(0.0)).empty());
}

TEST(Rests, TheNoiseIsThatOfTheTrackerWhetherItMovesOrNot) {
  for (const double sigma_m : {0.0003, 0.002, 0.05}) {
    Walk still(sigma_m), moving(sigma_m);
    still.stay(20.0);
    moving.go({5, 0, 0}, 0.3);
    EXPECT_NEAR(noiseOf_m(still.samples()) / sigma_m, 1.0, 0.1);
    EXPECT_NEAR(noiseOf_m(moving.samples()) / sigma_m, 1.0, 0.1);
  }
}

}  // namespace
}  // namespace carom
