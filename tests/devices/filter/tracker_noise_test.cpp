#include "devices/filter/tracker_noise.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
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
  for (const double rate_hz : {5.0, 20.0, 30.0, 60.0, 240.0}) {
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

// A head in motion, of components up to 2 Hz as walking has them, seeded: noise is told from it at any rate.
// At 20 Hz, three samples in a tenth of a second, a little of the motion counts as noise, and never much.
TEST(TrackerNoise, IsFoundWhileTheSensorMoves) {
  for (const double rate_hz : {20.0, 30.0, 60.0, 72.0, 120.0, 240.0}) {
    for (const double sigma_m : {0.00005, 0.0003, 0.001, 0.003}) {
      for (const std::uint64_t seed : {1u, 2u, 3u}) {
        Noise noise(sigma_m);
        noise.random.seed(seed);
        std::array<glm::dvec3, 8> amplitudes_m;
        std::array<double, 8> phases;
        for (std::size_t i = 0; i < amplitudes_m.size(); ++i) {
          amplitudes_m[i] = noise() / sigma_m * (i == 0 ? 0.3 : 0.02 / static_cast<double>(i));
          phases[i] = 6.0 * noise().x / sigma_m;
        }
        TrackerNoise estimate(0.0003);
        for (int i = 0; i < 15 * rate_hz; ++i) {
          glm::dvec3 position_m = noise();
          for (std::size_t k = 0; k < amplitudes_m.size(); ++k) {
            const double turns = 0.25 * static_cast<double>(k + 1) * i / rate_hz;
            position_m += amplitudes_m[k] * std::sin(2.0 * std::numbers::pi * turns + phases[k]);
          }
          estimate.add(i / rate_hz, position_m);
        }
        const double motion_m = rate_hz < 30.0 ? 0.0003 : rate_hz < 60.0 ? 0.00003 : 0.0;
        EXPECT_TRUE(estimate.sigma_m() > 0.75 * sigma_m && estimate.sigma_m() < 1.25 * sigma_m + motion_m)
            << estimate.sigma_m() << " for " << sigma_m << " m at " << rate_hz << " Hz, seed " << seed;
      }
    }
  }
}

// A tracker that smooths: each error e_i + 0.25 e_(i−1). At half the rate its power is 0.75² of that of white
// noise e, which is what fifth differences see; at the low end, which disturbs celerities, it is 1.25².
TEST(TrackerNoise, CountsWhatNoiseThatLastsDoes) {
  for (const double rate_hz : {72.0, 90.0, 240.0, 300.0}) {
    for (const double sigma_m : {0.0001, 0.0003, 0.001}) {
      double sum_m = 0.0;
      for (const std::uint64_t seed : {1u, 2u, 3u, 4u, 5u}) {
        Noise noise(sigma_m);
        noise.random.seed(seed);
        TrackerNoise estimate(0.0003);
        glm::dvec3 last_m = noise();
        for (int i = 0; i < 10 * rate_hz; ++i) {
          const glm::dvec3 now_m = noise();
          const glm::dvec3 path_m(0.3 * std::sin(2.0 * i / rate_hz), 0.02 * std::sin(9.0 * i / rate_hz), 0.0);
          estimate.add(i / rate_hz, path_m + now_m + 0.25 * last_m);
          last_m = now_m;
        }
        sum_m += estimate.sigma_m() / 5.0;
      }
      EXPECT_TRUE(sum_m > 0.9 * sigma_m && sum_m < 1.6 * sigma_m)
          << sum_m << " for " << sigma_m << " m at " << rate_hz << " Hz";
    }
  }
}

// The transmitter of a magnetic tracker is left and approached: within four seconds the estimate follows.
TEST(TrackerNoise, FollowsANoiseThatChanges) {
  for (const double rate_hz : {30.0, 60.0, 240.0}) {
    for (const double factor : {0.2, 5.0}) {
      TrackerNoise estimate(0.0003);
      Noise noise(1.0);
      for (int i = 0; i < 14 * rate_hz; ++i) {
        const double time_s = i / rate_hz;
        const double sigma_m = time_s < 10.0 ? 0.001 : 0.001 * factor;
        estimate.add(time_s, glm::dvec3(0.5 * std::sin(2.0 * time_s), 0.0, 0.0) + sigma_m * noise());
      }
      // Of a larger one a seventh is left after four seconds of a memory of two, in the variance.
      const double low = 0.8 * factor, high = std::hypot(1.25 * factor, std::exp(-1.0));
      EXPECT_TRUE(estimate.sigma_m() > 0.001 * low && estimate.sigma_m() < 0.001 * high)
          << estimate.sigma_m() << ", " << factor << " times as large at " << rate_hz << " Hz";
    }
  }
}

// An outlier in two seconds hardly counts.
TEST(TrackerNoise, IsNotFooledByAnOutlier) {
  TrackerNoise estimate(0.0003);
  Noise noise(0.0003);
  for (int i = 0; i < 600; ++i) {
    estimate.add(i / 60.0, noise() + glm::dvec3(i == 590 ? 0.05 : 0.0, 0.0, 0.0));
  }
  EXPECT_NEAR(estimate.sigma_m() / 0.0003, 1.0, 0.3);
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

TEST(TrackerNoise, IsNoneOfExactlyConstantPositions) {
  for (const double rate_hz : {5.0, 60.0, 240.0}) {
    TrackerNoise estimate;
    const int constant = std::max(6, static_cast<int>(0.2 * rate_hz));
    for (int i = 0; i < constant; ++i) estimate.add(i / rate_hz, glm::dvec3(1, 2, 3));
    EXPECT_LT(estimate.sigma_m(), 1e-12);  // rounding
    EXPECT_TRUE(estimate.isStill());
    // And it can grow again.
    Noise noise(0.0003);
    for (int i = constant; i < 20 * rate_hz; ++i) estimate.add(i / rate_hz, glm::dvec3(1, 2, 3) + noise());
    EXPECT_NEAR(estimate.sigma_m() / 0.0003, 1.0, 2.0 * kRelative) << rate_hz;
  }
}

}  // namespace
}  // namespace carom
