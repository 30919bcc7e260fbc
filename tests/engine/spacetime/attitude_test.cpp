#include "engine/spacetime/attitude.h"

#include <gtest/gtest.h>

#include <glm/gtc/quaternion.hpp>

#include "engine/random_world.h"

namespace carom {
namespace {

TEST(Attitude, IsTheRotationBeforeTheBoost) {
  test::Random random(64);
  for (int i = 0; i < 300; ++i) {
    CASE(random, i);
    const double c_m_s = random.in(0.3, 30.0);
    const glm::dquat turned = glm::angleAxis(random.in(-3.0, 3.0), random.direction());
    const Lorentz room = Lorentz::boost(random.u(0.99), c_m_s) * Lorentz::rotation(turned, c_m_s);
    EXPECT_NEAR(std::abs(glm::dot(attitudeOf(room), turned)), 1.0, 1e-12);
  }
}

// Two boosts that are not parallel turn a room: by Wigner's angle, tan(θ/2) = sin φ/(D + cos φ) with
// D = sqrt((γ1 + 1)(γ2 + 1)/((γ1 − 1)(γ2 − 1))) and φ between the boosts.
TEST(Attitude, TwoBoostsTurnARoomByWignersAngle) {
  test::Random random(65);
  for (int i = 0; i < 100; ++i) {
    CASE(random, i);
    const double u1 = random.in(0.1, 3.0), u2 = random.in(0.1, 3.0), phi = random.in(0.1, 3.0);
    const Vec3 way{std::cos(phi), std::sin(phi), 0.0};
    const Lorentz room = Lorentz::boost({u1, 0.0, 0.0}, 1.0) * Lorentz::boost(u2 * way, 1.0);
    const double g1 = std::sqrt(1.0 + u1 * u1), g2 = std::sqrt(1.0 + u2 * u2);
    const double D = std::sqrt((g1 + 1.0) * (g2 + 1.0) / ((g1 - 1.0) * (g2 - 1.0)));
    const double expected = 2.0 * std::atan2(std::sin(phi), D + std::cos(phi));
    EXPECT_NEAR(std::abs(glm::angle(attitudeOf(room))), std::abs(expected), 1e-9);
  }
}

}  // namespace
}  // namespace carom
