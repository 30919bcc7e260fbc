#include "devices/celerity_filter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <random>

#include "devices/simulated_tracker.h"

namespace carom {
namespace {

constexpr double kSigma_m = 0.0003;

glm::dvec3 noise(std::mt19937_64& random, double sigma_m = kSigma_m) {
  std::normal_distribution<double> normal(0.0, sigma_m);
  const double x = normal(random), y = normal(random), z = normal(random);
  return {x, y, z};
}

// Feeds positions at an even rate.
CelerityFilter fed(double rate_hz, double seconds, const std::function<glm::dvec3(double)>& position_m,
                   const std::function<void(double, const CelerityFilter&)>& each = {}) {
  CelerityFilter filter(kSigma_m);
  filter.start(0.0, position_m(0.0));
  for (int i = 1; i <= seconds * rate_hz; ++i) {
    filter.update(i / rate_hz, position_m(i / rate_hz));
    if (each) each(i / rate_hz, filter);
  }
  return filter;
}

// Even motion is a steady state of every model but that of standing still, which keeps a trace of belief.
constexpr double kBias_m_s = 0.0007;  // a fifth of the noise

TEST(CelerityFilter, EvenMotionHasNoBias) {
  for (const double speed_m_s : {0.05, 0.3, 1.5, 5.0}) {
    const glm::dvec3 celerity_m_s = speed_m_s * glm::normalize(glm::dvec3(1.3, -0.1, 0.7));
    for (const double rate_hz : {60.0, 240.0}) {
      const CelerityFilter exact = fed(rate_hz, 5.0, [&](double t) { return t * celerity_m_s; });
      EXPECT_TRUE(glm::distance(exact.celerity_m_s(), celerity_m_s) < 0.5 * kBias_m_s)
          << speed_m_s << " m/s at " << rate_hz << " Hz";
      EXPECT_TRUE(glm::distance(exact.position_m(), 5.0 * celerity_m_s) < 0.00005) << rate_hz;

      std::mt19937_64 random(1);
      glm::dvec3 sum(0.0);
      int count = 0;
      fed(
          rate_hz, 60.0, [&](double t) { return t * celerity_m_s + noise(random); },
          [&](double t, const CelerityFilter& filter) {
            if (t < 2.0) return;
            sum += filter.celerity_m_s() - celerity_m_s;
            ++count;
          });
      EXPECT_TRUE(glm::length(sum / static_cast<double>(count)) < kBias_m_s)
          << speed_m_s << " m/s at " << rate_hz << " Hz";
    }
  }
}

TEST(CelerityFilter, AnAtRestUserIsStill) {
  for (const double rate_hz : {60.0, 120.0, 240.0}) {
    std::mt19937_64 random(2);
    double square = 0.0;
    int count = 0;
    fed(
        rate_hz, 60.0, [&](double) { return glm::dvec3(1, 2, 3) + noise(random); },
        [&](double t, const CelerityFilter& filter) {
          if (t < 5.0) return;
          square += glm::dot(filter.celerity_m_s(), filter.celerity_m_s()) / 3.0;
          ++count;
        });
    EXPECT_LT(std::sqrt(square / count), 0.0006) << rate_hz;  // m/s
  }
}

// Constant acceleration, closed form: the celerity is late by the stated lag.
TEST(CelerityFilter, StatesItsLag) {
  for (const double rate_hz : {60.0, 120.0, 240.0}) {
    for (const double acceleration_m_s2 : {0.3, 1.0, 2.0}) {
      double error_s = 0.0, stated_s = 0.0;
      std::mt19937_64 random(3);
      fed(
          rate_hz, 4.0,
          [&](double t) { return glm::dvec3(0.5 * acceleration_m_s2 * t * t, 0.0, 0.0) + noise(random); },
          [&](double t, const CelerityFilter& filter) {
            if (t < 1.0) return;
            error_s += (t * acceleration_m_s2 - filter.celerity_m_s().x) / acceleration_m_s2 / rate_hz / 3.0;
            stated_s += filter.lag_s() / rate_hz / 3.0;
          });
      EXPECT_NEAR(error_s / stated_s, 1.0, 0.15) << rate_hz << " Hz, " << acceleration_m_s2 << " m/s²";
      EXPECT_GT(stated_s, 0.001);
      EXPECT_LT(stated_s, 0.04);
    }
  }
}

// Noise and motion are isotropic: turning the axes turns the estimate.
TEST(CelerityFilter, IsTheSameInTurnedAxes) {
  const glm::dquat turn = glm::normalize(glm::dquat(0.3, -0.5, 0.7, 0.2));
  SimulatedTracker person({.seed = 12});
  std::vector<TrackerSample> samples;
  person.poll(30.0, samples);
  CelerityFilter plain(kSigma_m), turned(kSigma_m);
  plain.start(0.0, samples[0].pose.position_m);
  turned.start(0.0, turn * samples[0].pose.position_m);
  for (std::size_t i = 1; i < samples.size(); ++i) {
    plain.update(samples[i].time_s, samples[i].pose.position_m);
    turned.update(samples[i].time_s, turn * samples[i].pose.position_m);
    ASSERT_TRUE(glm::distance(turn * plain.celerity_m_s(), turned.celerity_m_s()) < 1e-9) << i;
  }
}

// The stated covariance against what the errors are: never much too small.
TEST(CelerityFilter, StatesItsError) {
  for (const double rate_hz : {60.0, 240.0}) {
    SimulatedPerson person{.seed = 13, .rate_hz = rate_hz};
    SimulatedTracker tracker(person);
    CelerityFilter filter(kSigma_m);
    std::vector<TrackerSample> samples;
    double relative = 0.0;
    int count = 0, beyondThree = 0;
    for (int i = 0; i < 120 * rate_hz; ++i) {
      samples.clear();
      tracker.poll(i / rate_hz, samples);
      if (i == 0) {
        filter.start(0.0, samples[0].pose.position_m);
        continue;
      }
      filter.update(samples[0].time_s, samples[0].pose.position_m);
      const glm::dvec3 error_m_s = filter.celerity_m_s() - tracker.truth().velocity_m_s;
      const glm::dmat3 covariance = filter.celerityCovariance_m2_s2();
      for (int axis = 0; axis < 3; ++axis) {
        const double square = error_m_s[axis] * error_m_s[axis] / covariance[axis][axis];
        relative += square;
        beyondThree += !(square <= 9.0);
        ++count;
      }
    }
    EXPECT_GT(relative / count, 0.2) << rate_hz;
    EXPECT_LT(relative / count, 1.1) << rate_hz;
    EXPECT_LT(beyondThree, 0.015 * count) << rate_hz;
  }
}

// Uneven times and missing samples cost little beside the same mean rate.
TEST(CelerityFilter, TakesUnevenTimes) {
  SimulatedTracker tracker({.seed = 14, .rate_hz = 480.0, .noise_m = 0.0});
  std::mt19937_64 random(15);
  std::vector<TrackerSample> samples;
  std::vector<TrueMotion> truth;
  for (int i = 0; i < 480 * 90; ++i) {
    tracker.poll(i / 480.0, samples);
    truth.push_back(tracker.truth());
  }
  const auto error_m_s = [&](const std::function<std::size_t()>& stride) {
    CelerityFilter filter(kSigma_m);
    filter.start(0.0, samples[0].pose.position_m);
    double square = 0.0;
    int count = 0;
    for (std::size_t i = stride(); i < samples.size(); i += stride(), ++count) {
      filter.update(samples[i].time_s, samples[i].pose.position_m + noise(random));
      const glm::dvec3 error = filter.celerity_m_s() - truth[i].velocity_m_s;
      square += glm::dot(error, error) / 3.0;
    }
    return std::sqrt(square / count);
  };
  const double even_m_s = error_m_s([] { return std::size_t{8}; });
  const double uneven_m_s = error_m_s([&] { return random() % 10 == 0 ? 16 : 4 + random() % 8; });
  EXPECT_LT(even_m_s, 0.009);
  EXPECT_LT(uneven_m_s, 1.15 * even_m_s);
}

TEST(CelerityFilter, ClosedFormOfPrediction) {
  const CelerityFilter filter = fed(120.0, 3.0, [](double t) { return glm::dvec3(0.8 * t, 0, 0); });
  EXPECT_NEAR(filter.predictedPosition_m(0.05).x, 0.8 * 3.05, 0.0001);
  EXPECT_EQ(filter.celerityChange_m2_s2(0.0), 0.0);
  EXPECT_GT(filter.celerityChange_m2_s2(0.05), 0.0);
}

}  // namespace
}  // namespace carom
