// The filter as the eye judges it: how far noise swings the sky, and what a loss of tracking does to the
// person's world line. Through the whole observer.

#include "aberration_error.h"
#include "engine/spacetime/observers.h"

#include <gtest/gtest.h>

namespace carom {
namespace {

using test::kLightSpeed_m_s;
using test::kNoise_m;
using test::kRate_hz;
using test::rms_deg;
using test::SwingSample;

// A still person, light at 1.42 m/s, noise of 0.3 mm at 60 Hz: the sky keeps still to 0.05°, less than the
// width of a pixel (3 m wall of 1920 pixels seen from 1.5 m: 0.06°).
TEST(AberrationError, IsNoneForAStillUser) {
  for (const std::uint64_t seed : {1u, 2u, 3u, 4u}) {
    const auto samples = test::aberrationError(test::kWalkBegin_s, seed);
    const double filtered_deg = rms_deg(samples, &SwingSample::filtered_rad, test::isStanding);
    EXPECT_TRUE(filtered_deg <= 0.05) << filtered_deg << "°, seed " << seed;
    // Both components across the line of sight, each √2 σ/T/c: what the filter is up against.
    const double expected_deg = glm::degrees(2.0 * kNoise_m * kRate_hz / kLightSpeed_m_s);
    EXPECT_NEAR(rms_deg(samples, &SwingSample::unfiltered_rad, test::isStanding) / expected_deg, 1.0, 0.1);
  }
}

TEST(AberrationError, IsSmallerThanUnfilteredWhileWalkingThroughSevenTenthsOfLight) {
  double filtered_deg = 0.0, unfiltered_deg = 0.0, stated_deg = 0.0, whole_deg = 0.0,
         wholeUnfiltered_deg = 0.0;
  constexpr int kSeeds = 8;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const auto samples = test::aberrationError(test::kWalkEnd_s + 1.0, seed);
    filtered_deg += rms_deg(samples, &SwingSample::filtered_rad, test::isFast) / kSeeds;
    unfiltered_deg += rms_deg(samples, &SwingSample::unfiltered_rad, test::isFast) / kSeeds;
    stated_deg += rms_deg(samples, &SwingSample::stated_rad, test::isFast) / kSeeds;
    whole_deg += rms_deg(samples, &SwingSample::filtered_rad, test::isOnTheWay) / kSeeds;
    wholeUnfiltered_deg += rms_deg(samples, &SwingSample::unfiltered_rad, test::isOnTheWay) / kSeeds;
  }
  EXPECT_TRUE(filtered_deg < 0.7 * unfiltered_deg) << filtered_deg << " " << unfiltered_deg;
  EXPECT_TRUE(whole_deg < 0.7 * wholeUnfiltered_deg) << whole_deg << " " << wholeUnfiltered_deg;
  // The worst landmark may swing by more than this one, and the filter cannot know how its models fit.
  EXPECT_TRUE(stated_deg > 0.5 * filtered_deg && stated_deg < 3.0 * filtered_deg)
      << stated_deg << " " << filtered_deg;
}

// The formula against boosts as they are: directions seen with a celerity and with an error more, of the
// landmark that swings most.
TEST(AberrationError, IsThatOfBoosts) {
  std::mt19937_64 random(41);
  std::normal_distribution<double> normal;
  const auto vector = [&] {
    const double x = normal(random), y = normal(random), z = normal(random);
    return Vec3(x, y, z);
  };
  constexpr double kError = 1e-5;  // of celerity over c; second order is below 1e-4 of it
  for (const double eta : {0.01, 0.3, 1.0, 2.5}) {
    const Vec3 along = glm::normalize(vector());
    const Vec3 across = glm::normalize(glm::cross(along, vector()));
    for (const bool isAlong : {true, false}) {
      const Vec3 u = std::sinh(eta) * along, error = kError * (isAlong ? along : across);
      const Lorentz exact = Lorentz::boost(u, 1.0).inverse(),
                    wrong = Lorentz::boost(u + error, 1.0).inverse();
      double largest_rad = 0.0;
      for (int i = 0; i < 4000; ++i) {
        const Vec3 direction = glm::normalize(vector());
        const Displacement light{-1.0, direction};
        largest_rad = std::max(largest_rad, test::angle_rad((exact * light).dr_m, (wrong * light).dr_m));
      }
      const double stated_rad =
          aberrationError_rad(u,
                              glm::outerProduct(error, error) +
                                  (isAlong ? 0.0 : 1.0) * kError * kError *
                                      glm::outerProduct(glm::cross(along, across), glm::cross(along, across)),
                              1.0);
      // Four thousand landmarks miss the worst by a per cent or so.
      EXPECT_NEAR(largest_rad / stated_rad, 1.0, 0.02) << "η = " << eta << (isAlong ? ", along" : ", across");
    }
  }
}

/// Samples of someone who stands, whose tracking is lost from 5 s to 6 s and comes back a metre away.
HeadEstimate headAt(HeadFilter& filter, double time_s, std::mt19937_64& random) {
  std::normal_distribution<double> normal(0.0, kNoise_m);
  const double x = normal(random), y = normal(random), z = normal(random);
  if (time_s < 5.0 || time_s >= 6.0) {
    filter.add(time_s, {Vec3(time_s < 5.0 ? x : 1.0 + x, 1.7 + y, z), glm::dquat(1.0, 0.0, 0.0, 0.0)});
  }
  return filter.at(time_s);
}

// The person's place slews, and slewing is the only thing that happens: board time runs on with no jump, each
// step is timelike, and the sky keeps still, at any light speed.
TEST(AberrationError, AReturnAMetreAwayIsNoJump) {
  for (const double c_m_s : {0.3, 1.42, 30.0}) {
    std::mt19937_64 random(51);
    HeadFilter filter;
    HeadEstimate head = headAt(filter, 0.0, random);
    Observers observer(Lorentz(c_m_s), {0.0, Vec3(0.0)}, {head.pose, head.celerity_m_s});
    double slew_s = 0.0;
    for (int i = 1; i < 60 * 12; ++i) {
      const double time_s = i / kRate_hz, step_s = 1.0 / kRate_hz;
      const Event before = observer.headEvent();
      head = headAt(filter, time_s, random);
      observer.step(step_s, {head.pose, head.celerity_m_s});
      const Displacement moved = observer.headEvent() - before;
      constexpr double kRounding_s = 1e-12;  // of a difference of board times
      // 1 m/s of slewing and the pose's own unrest.
      const double fastest = std::hypot(1.0, (1.0 + 0.05) / c_m_s);
      ASSERT_TRUE(moved.dt_s >= step_s - kRounding_s && moved.dt_s <= fastest * step_s)
          << time_s << " s, c = " << c_m_s;
      ASSERT_TRUE(interval_m2(moved, c_m_s) > 0.0) << time_s << " s, c = " << c_m_s;
      if (time_s > 5.0) {
        ASSERT_TRUE(glm::length(head.celerity_m_s) < 0.02) << time_s << " s";
      }
      slew_s += moved.dt_s - step_s;
    }
    EXPECT_NEAR(observer.headEvent().r_m.x, 1.0, 0.001);
    // A metre in a second of the person's own: sqrt(1 + (1 m/s)²/c²) − 1 seconds more than stood still. Noise
    // adds the little that a standing head moves.
    const double expected_s = std::hypot(1.0, 1.0 / c_m_s) - 1.0;
    EXPECT_NEAR(slew_s, expected_s, 0.02 * expected_s + 0.005 / c_m_s) << "c = " << c_m_s;
  }
}

}  // namespace
}  // namespace carom
