#include "engine/game/billiard_setup.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/light_speed.h"
#include "engine/random_world.h"

namespace carom {
namespace {

using test::kC_m_s;

Puck randomPuck(test::Random& random) {
  Puck puck;
  puck.radius_m = random.in(0.02, 0.1);
  puck.mass_kg = random.in(0.05, 1.0);
  puck.inertia = random.in(0.1, 0.9);
  return puck;
}

TEST(BilliardSetup, TheRadiusIsThatOfTheFarthestCorner) {
  EXPECT_EQ(radiusOf_m({{0.03, 0.04}, {-0.01, 0.0}, {0.0, -0.02}}), 0.05);
  EXPECT_EQ(radiusOf_m({}), 0.0);
}

// The rim at ω R has the celerity γ ω R/c, and J is the rim's mass times that times R c.
TEST(BilliardSetup, SpinsAreThoseOfTheRim) {
  test::Random random(92);
  for (int i = 0; i < 300; ++i) {
    CASE(random, i);
    const Puck puck = randomPuck(random);
    const double beta = random.in(-0.99, 0.99), gamma = 1.0 / std::sqrt(1.0 - beta * beta);
    const double spin = spinAt_kg_m2_s(puck, beta * kC_m_s / puck.radius_m, kC_m_s);
    const double rim_kg = puck.inertia * puck.mass_kg;
    EXPECT_NEAR(spin, rim_kg * gamma * beta * kC_m_s * puck.radius_m, 1e-12);
    EXPECT_NEAR(rimUOf(puck, spin, kC_m_s), gamma * beta, 1e-10 * gamma);
    EXPECT_NEAR(spinOfRim_kg_m2_s(puck, gamma * beta, kC_m_s), spin, 1e-12);
    // The core rests and the rim moves.
    EXPECT_NEAR(restMass_kg(puck, spin, kC_m_s), puck.mass_kg - rim_kg + gamma * rim_kg, 1e-12 * gamma);
  }
}

TEST(BilliardSetup, SlowSpinsAreThoseOfARigidRing) {
  Puck puck;
  puck.radius_m = 0.05;
  puck.mass_kg = 0.2;
  puck.inertia = 0.5;
  const double omega_rad_s = 1e-3;
  EXPECT_NEAR(spinAt_kg_m2_s(puck, omega_rad_s, kC_m_s), 0.5 * 0.2 * 0.05 * 0.05 * omega_rad_s, 1e-15);
  EXPECT_EQ(restMass_kg(puck, 0.0, kC_m_s), 0.2);
}

TEST(BilliardSetup, EveryKindOfEventAndCushionHasItsName) {
  for (int kind = 0; kind <= static_cast<int>(kLastEventKind); ++kind) {
    EXPECT_FALSE(nameOf(static_cast<EventKind>(kind)).empty());
    for (int other = 0; other < kind; ++other)
      EXPECT_NE(nameOf(static_cast<EventKind>(kind)), nameOf(static_cast<EventKind>(other)));
  }
  EXPECT_EQ(nameOf(Cushion::minusY), "-y");
}

}  // namespace
}  // namespace carom
