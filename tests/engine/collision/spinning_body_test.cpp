#include "engine/collision/spinning_body.h"

#include <gtest/gtest.h>

#include "engine/random_world.h"

namespace carom {
namespace {

// The first law: a spin that grows by dj takes the energy f dj. Besides, the two ways between spin and rim
// undo each other, and the rim's rapidity is asinh(j/(k m)).
TEST(SpinningBody, ObeysTheFirstLaw) {
  test::Random random(1);
  for (int i = 0; i < 2000; ++i) {
    CASE(random, i);
    const double mass = random.in(0.01, 5.0);
    const SpinningBody body{mass, mass * random.in(0.01, 1.0)};
    const double j = body.rim * std::sinh(random.in(-5.0, 5.0)), step = 1e-4 * rimEnergy(body, j);
    const double slope = (restMass(body, j + step) - restMass(body, j - step)) / (2.0 * step);
    EXPECT_NEAR(slope, rimBeta(body, j), 1e-7) << j;
    EXPECT_NEAR(std::atanh(rimBeta(body, j)), std::asinh(j / body.rim), 1e-10) << j;
    EXPECT_NEAR(spinOfRim(body, rimBeta(body, j)), j, 1e-10 * std::abs(j)) << j;
  }
}

TEST(SpinningBody, WithoutSpinHasItsMassToTheBit) {
  test::Random random(2);
  for (int i = 0; i < 1000; ++i) {
    CASE(random, i);
    const double mass = random.in(0.01, 5.0);
    EXPECT_EQ(restMass({mass, mass * random.in(0.01, 1.0)}, 0.0), mass);
  }
}

// A hoop: M² = m² + j². A slow rim: the energy J²/(2 k m R²) of Newton's moment of inertia.
TEST(SpinningBody, HasItsLimits) {
  EXPECT_NEAR(restMass({3.0, 3.0}, 4.0), 5.0, 1e-15);
  EXPECT_NEAR(restMass({3.0, 3.0}, -4.0), 5.0, 1e-15);
  EXPECT_NEAR(rimBeta({3.0, 3.0}, -4.0), -0.8, 1e-15);
  EXPECT_NEAR(restMass({2.0, 1.0}, 1e-4) - 2.0, 0.5e-8, 1e-15);
  EXPECT_LT(rimBeta({1.0, 0.5}, 1e6), 1.0);
}

}  // namespace
}  // namespace carom
