#include "devices/filter/orientation_filter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace carom {
namespace {

constexpr double kStep_s = 1e-3;
constexpr glm::dvec3 kGravity_m_s2{0.0, 9.80665, 0.0};  // as felt: upwards

/// Angle of the turn between two orientations.
double between_rad(const glm::dquat& a, const glm::dquat& b) {
  const glm::dquat turn = glm::conjugate(a) * b;
  return 2.0 * std::atan2(std::hypot(turn.x, turn.y, turn.z), std::abs(turn.w));
}

double tilt_rad(const OrientationFilter& filter, const glm::dvec3& upInSensor) {
  return std::acos(std::min(1.0, (filter.orientation() * upInSensor).y));
}

TEST(OrientationFilter, LevelsItselfWithTheFirstSample) {
  const unsigned seed = 5;
  std::mt19937 random(seed);
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::normal_distribution<double> normal;
  for (int i = 0; i < 1000; ++i) {
    const glm::dvec3 up = glm::normalize(glm::dvec3(normal(random), normal(random), normal(random)));
    OrientationFilter filter;
    filter.update(kStep_s, glm::dvec3(0.0), 9.80665 * up);
    EXPECT_NEAR(glm::length(filter.orientation() * up - glm::dvec3(0, 1, 0)), 0.0, 1e-9);
  }
  OrientationFilter overhead;
  overhead.update(kStep_s, glm::dvec3(0.0), -kGravity_m_s2);
  EXPECT_NEAR(glm::length(overhead.orientation() * glm::dvec3(0, -1, 0) - glm::dvec3(0, 1, 0)), 0.0, 1e-9);
}

/// A head that looks about, its orientation given as angles; rates by differences of the orientation itself.
glm::dquat lookingAbout(double time_s) {
  const glm::dquat yaw = glm::angleAxis(1.2 * std::sin(1.1 * time_s), glm::dvec3(0, 1, 0));
  const glm::dquat pitch = glm::angleAxis(0.4 * std::sin(2.3 * time_s), glm::dvec3(1, 0, 0));
  const glm::dquat roll = glm::angleAxis(0.2 * std::sin(1.7 * time_s), glm::dvec3(0, 0, 1));
  return yaw * pitch * roll;
}

glm::dvec3 rate_rad_s(double time_s) {
  const double h = 1e-5;
  const glm::dquat turn = glm::conjugate(lookingAbout(time_s - h)) * lookingAbout(time_s + h);
  return glm::dvec3(turn.x, turn.y, turn.z) / h;  // twice the imaginary part over twice the step
}

TEST(OrientationFilter, FollowsAHeadThatLooksAbout) {
  OrientationFilter filter;
  filter.update(kStep_s, rate_rad_s(0.0), glm::conjugate(lookingAbout(0.0)) * kGravity_m_s2);
  for (int i = 1; i <= 60000; ++i) {  // a minute
    const double time_s = i * kStep_s;
    // A step's rate is that of its middle; what is felt, of its end.
    filter.update(kStep_s, rate_rad_s(time_s - kStep_s / 2),
                  glm::conjugate(lookingAbout(time_s)) * kGravity_m_s2);
    // A step is wrong to third order: turning at 3 rad/s by some 1e-10 rad, which for the heading may add up.
    ASSERT_LT(between_rad(filter.orientation(), lookingAbout(time_s)), 3e-5) << time_s;
  }
}

// Each step turns by the rate's whole angle, however long it is: ten turns about the vertical in steps of
// half a radian.
TEST(OrientationFilter, LongStepsTurnByTheirWholeAngle) {
  OrientationFilter filter;
  filter.update(kStep_s, glm::dvec3(0.0), kGravity_m_s2);
  constexpr int kSteps = 120;
  const double step_s = 0.1, rate = 20.0 * M_PI / (kSteps * step_s);
  for (int i = 0; i < kSteps; ++i) filter.update(step_s, {0.0, rate, 0.0}, kGravity_m_s2);
  EXPECT_NEAR(glm::length(filter.orientation() * glm::dvec3(1, 0, 0) - glm::dvec3(1, 0, 0)), 0.0, 1e-12);
}

/// With gyroscope and accelerometer still, a small tilt error decays as θ'' + kP θ' + kI θ = 0: here solved
/// by its roots, with the constants of the filter's source (0.3 and 0.02).
TEST(OrientationFilter, TiltSettlesAsTheTheorySays) {
  OrientationFilter filter;
  filter.update(kStep_s, glm::dvec3(0.0), 9.80665 * glm::dvec3(std::sin(0.05), std::cos(0.05), 0.0));
  // θ(0) = 0.05, θ' = −kP θ at first (no bias is known).
  const double p = 0.3, i = 0.02, r = std::sqrt(p * p / 4 - i), a = -p / 2 + r, b = -p / 2 - r;
  const double ca = 0.05 * (-p - b) / (a - b), cb = 0.05 - ca;
  for (int step = 1; step <= 20000; ++step) {
    filter.update(kStep_s, glm::dvec3(0.0), kGravity_m_s2);
    const double t = step * kStep_s;
    const double expected = ca * std::exp(a * t) + cb * std::exp(b * t);
    // Linear theory: sin θ is θ to 4e-4 of it; the step of a millisecond adds 1.5e-4 of it.
    ASSERT_NEAR(tilt_rad(filter, {0, 1, 0}), std::abs(expected), 4e-5) << t;
  }
}

TEST(OrientationFilter, LearnsTheBiasAboutLevelAxesAndDriftsInHeading) {
  OrientationFilter filter;
  const glm::dvec3 bias(0.02, 0.01, -0.03);
  for (int i = 0; i < 120000; ++i) filter.update(kStep_s, bias, kGravity_m_s2);  // two minutes
  EXPECT_LT(tilt_rad(filter, {0, 1, 0}), 1e-4);
  EXPECT_NEAR(filter.bias_rad_s().x, 0.02, 1e-4);
  EXPECT_NEAR(filter.bias_rad_s().z, -0.03, 1e-4);
  EXPECT_NEAR(filter.bias_rad_s().y, 0.0, 1e-3);  // nothing tells it
  const glm::dvec3 ahead = filter.orientation() * glm::dvec3(0, 0, -1);
  EXPECT_NEAR(std::remainder(std::atan2(-ahead.x, -ahead.z) - 1.2, 2 * std::numbers::pi), 0.0,
              0.1);  // 120 s × 0.01
}

TEST(OrientationFilter, PushesHardlyTiltIt) {
  OrientationFilter filter;
  double most = 0.0;
  for (int i = 0; i < 30000; ++i) {  // walking: 1 m/s² to and fro, twice a second
    const double push = std::sin(2.0 * std::numbers::pi * 2.0 * i * kStep_s);
    filter.update(kStep_s, glm::dvec3(0.0), kGravity_m_s2 + glm::dvec3(push, 0.0, 0.0));
    most = std::max(most, tilt_rad(filter, {0, 1, 0}));
  }
  // The push tilts what is felt by 0.1 rad; of that a first-order filter at 0.3/s lets 0.3 / (2π 2) through
  // each way: 2.4e-3, and twice that from a push that begins at zero.
  EXPECT_LT(most, 6e-3);
  OrientationFilter struck;
  struck.update(kStep_s, glm::dvec3(0.0), kGravity_m_s2);
  for (int i = 0; i < 1000; ++i) struck.update(kStep_s, glm::dvec3(0.0), glm::dvec3(50.0, 0.0, 0.0));
  EXPECT_EQ(tilt_rad(struck, {0, 1, 0}), 0.0);  // no gravity at all: not believed
}

TEST(OrientationFilter, StaysAnOrientationWhateverIsFed) {
  const unsigned seed = 8;
  std::mt19937 random(seed);
  SCOPED_TRACE("seed " + std::to_string(seed));
  const double nan = std::numeric_limits<double>::quiet_NaN(),
               infinite = std::numeric_limits<double>::infinity();
  const std::array<double, 9> odd{0.0, -0.0, 1e-300, 1.0, -9.8, 104.8, 1e10, nan, infinite};
  const auto any = [&] { return odd[random() % odd.size()]; };
  OrientationFilter filter;
  for (int i = 0; i < 100000; ++i) {
    filter.update(any(), {any(), any(), any()}, {any(), any(), any()});
    const glm::dquat q = filter.orientation();
    ASSERT_NEAR(glm::length(q), 1.0, 1e-9) << i;
  }
}

}  // namespace
}  // namespace carom
