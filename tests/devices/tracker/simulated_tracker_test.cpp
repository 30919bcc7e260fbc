#include "devices/tracker/simulated_tracker.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

namespace carom {
namespace {

struct Recorded {
  std::vector<TrackerSample> samples;
  std::vector<TrueMotion> truth;
};

Recorded record(const SimulatedPerson& person, double seconds) {
  SimulatedTracker tracker(person);
  Recorded recorded;
  for (int i = 0; i <= seconds * person.rate_hz; ++i) {
    tracker.poll(i / person.rate_hz, recorded.samples);
    recorded.truth.push_back(tracker.truth());
  }
  return recorded;
}

TEST(SimulatedTracker, TheSameSeedGivesTheSameBits) {
  const SimulatedPerson person{.seed = 3};
  SimulatedTracker atOnce(person);
  std::vector<TrackerSample> samples;
  atOnce.poll(30.0, samples);
  const Recorded stepwise = record(person, 30.0);
  ASSERT_EQ(samples.size(), stepwise.samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    ASSERT_EQ(samples[i].time_s, stepwise.samples[i].time_s);
    ASSERT_EQ(samples[i].pose.position_m, stepwise.samples[i].pose.position_m);
    ASSERT_EQ(samples[i].pose.orientation, stepwise.samples[i].pose.orientation);
  }
  const Recorded other = record({.seed = 4}, 30.0);
  EXPECT_NE(other.samples.back().pose.position_m, samples.back().pose.position_m);
}

// The path does not depend on the rate: to the end of a step of a millisecond at even acceleration.
TEST(SimulatedTracker, IsTheSamePersonAtAnyRate) {
  const Recorded slow = record({.seed = 5, .rate_hz = 50.0}, 20.0);
  const Recorded fast = record({.seed = 5, .rate_hz = 250.0}, 20.0);
  for (std::size_t i = 0; i < slow.truth.size(); ++i) {
    ASSERT_TRUE(glm::distance(slow.truth[i].pose.position_m, fast.truth[5 * i].pose.position_m) < 1e-5) << i;
  }
}

TEST(SimulatedTracker, NoiseIsAsStrongAsToldAndWhite) {
  const SimulatedPerson person{.seed = 6, .noise_m = 0.0003, .noise_rad = 0.002};
  const Recorded recorded = record(person, 60.0);
  glm::dvec3 square(0.0), product(0.0), before(0.0);
  double turnSquare = 0.0;
  for (std::size_t i = 0; i < recorded.samples.size(); ++i) {
    const glm::dvec3 noise = recorded.samples[i].pose.position_m - recorded.truth[i].pose.position_m;
    square += noise * noise;
    product += noise * before;
    before = noise;
    const glm::dquat turn =
        recorded.samples[i].pose.orientation * glm::conjugate(recorded.truth[i].pose.orientation);
    turnSquare += 4.0 * (1.0 - turn.w * turn.w);
  }
  const double count = static_cast<double>(recorded.samples.size());
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(std::sqrt(square[axis] / count), 0.0003, 0.00001);  // 2 % of 3600 samples: 3 standard errors
    EXPECT_NEAR(product[axis] / square[axis], 0.0, 4.0 / std::sqrt(count));
  }
  EXPECT_NEAR(std::sqrt(turnSquare / (3.0 * count)), 0.002, 0.0001);
}

TEST(SimulatedTracker, TruthIsConsistent) {
  const Recorded recorded = record({.seed = 7, .rate_hz = 500.0}, 30.0);
  for (std::size_t i = 1; i + 1 < recorded.truth.size(); ++i) {
    const TrueMotion& before = recorded.truth[i - 1];
    const TrueMotion& after = recorded.truth[i + 1];
    const glm::dvec3 slope =
        (after.pose.position_m - before.pose.position_m) / (after.time_s - before.time_s);
    ASSERT_TRUE(glm::distance(slope, recorded.truth[i].velocity_m_s) < 0.003) << i;
  }
}

// What recorded heads show: acceleration of 0.2 to 0.5 m/s² rms along the floor, correlated over 0.1 to
// 0.3 s; speeds up to a moveUnseen.
TEST(SimulatedTracker, MovesLikeAPerson) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    const Recorded recorded = record({.seed = seed, .rate_hz = 100.0}, 130.0);
    const std::size_t from = 1000;  // walking about
    double square = 0.0, fastest_m_s = 0.0;
    std::vector<double> products(100, 0.0);
    for (std::size_t i = from; i + 100 < recorded.truth.size(); ++i) {
      const glm::dvec3 a = recorded.truth[i].acceleration_m_s2;
      square += a.x * a.x + a.z * a.z;
      for (std::size_t k = 0; k < products.size(); ++k) {
        const glm::dvec3 b = recorded.truth[i + k].acceleration_m_s2;
        products[k] += a.x * b.x + a.z * b.z;
      }
      fastest_m_s = std::max(fastest_m_s, glm::length(recorded.truth[i].velocity_m_s));
      const glm::dvec3 place = recorded.truth[i].pose.position_m;
      ASSERT_LT(std::abs(place.x), 0.8) << seed;
      ASSERT_LT(std::abs(place.z), 0.8) << seed;
      ASSERT_NEAR(place.y, 1.7, 0.1) << seed;
    }
    const double rms = std::sqrt(square / 2.0 / static_cast<double>(recorded.truth.size() - 100 - from));
    EXPECT_GT(rms, 0.2) << seed;
    EXPECT_LT(rms, 0.5) << seed;
    EXPECT_GT(fastest_m_s, 0.4) << seed;
    EXPECT_LT(fastest_m_s, 1.5) << seed;
    std::size_t correlated = 0;
    while (correlated < products.size() && products[correlated] > products[0] / std::exp(1.0)) ++correlated;
    EXPECT_GE(correlated, 10u) << seed;  // hundredths of a second
    EXPECT_LE(correlated, 30u) << seed;
  }
}

TEST(SimulatedTracker, StandsForFiveSeconds) {
  const Recorded recorded = record({.seed = 9}, 5.0);
  double furthest_m = 0.0, square = 0.0;
  for (const TrueMotion& truth : recorded.truth) {
    furthest_m = std::max(furthest_m, glm::distance(truth.pose.position_m, glm::dvec3(0.0, 1.7, 0.0)));
    square += glm::dot(truth.velocity_m_s, truth.velocity_m_s) / 3.0;
    EXPECT_GT(truth.pose.orientation.w, 1.0 - 1e-9);  // facing the front
  }
  EXPECT_GT(furthest_m, 0.001);
  EXPECT_LT(furthest_m, 0.02);
  EXPECT_LT(std::sqrt(square / static_cast<double>(recorded.truth.size())), 0.015);
}

TEST(SimulatedTracker, ServesOtherAxes) {
  const SimulatedPerson yUp{.seed = 8, .noise_m = 0.0, .noise_rad = 0.0};
  SimulatedPerson zUp = yUp;
  zUp.axes = {{1, 0, 0}, {0, 0, 1}, {0, 1, 0}};
  const Recorded a = record(yUp, 20.0), b = record(zUp, 20.0);
  for (std::size_t i = 0; i < a.samples.size(); ++i) {
    const auto turned = [](const glm::dvec3& v) { return glm::dvec3(v.x, -v.z, v.y); };
    ASSERT_TRUE(glm::distance(turned(a.samples[i].pose.position_m), b.samples[i].pose.position_m) < 1e-12);
    const glm::dvec3 looksA = a.samples[i].pose.orientation * yUp.axes.forward;
    const glm::dvec3 looksB = b.samples[i].pose.orientation * zUp.axes.forward;
    ASSERT_TRUE(glm::distance(turned(looksA), looksB) < 1e-12);
  }
}

}  // namespace
}  // namespace carom
