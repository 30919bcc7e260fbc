#include "engine/collision/turning.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/random_world.h"

namespace carom {
namespace {

// Beside small steps of own time: the angle grows by the rim's speed over the radius, and the cloth takes the
// rim's celerity evenly.
TEST(Turning, IsWhatSmallStepsGive) {
  test::Random random(85);
  for (int i = 0; i < 100; ++i) {
    CASE(random, i);
    const SpinningBody body{0.2, random.in(0.02, 0.1)};
    const double radius = random.in(0.02, 0.1),
                 slowing = random.in(0.0, 1.0) < 0.5 ? 0.0 : random.in(0.1, 2.0);
    const Turning start{random.in(-0.2, 0.2), random.in(-1.0, 1.0)};
    const double until = random.in(0.01, 0.5);
    constexpr int kSteps = 20000;
    double u = start.j / body.rim, angle = start.angle;
    for (int step = 0; step < kSteps; ++step) {
      const double ds = until / kSteps;
      const double next = std::copysign(std::max(0.0, std::abs(u) - slowing * ds), u),
                   middle = 0.5 * (u + next);
      angle += ds * middle / std::sqrt(1.0 + middle * middle) / radius;
      u = next;
    }
    const Turning end = turningAfter(start, body, radius, slowing, until);
    EXPECT_NEAR(end.j, u * body.rim, 1e-6);
    EXPECT_NEAR(std::remainder(end.angle - angle, 2.0 * M_PI), 0.0, 1e-4);
  }
}

TEST(Turning, WhatDoesNotSpinKeepsItsAngle) {
  const Turning still{0.0, 0.7};
  EXPECT_EQ(turningAfter(still, {0.2, 0.1}, 0.05, 1.0, 3.0).angle, 0.7);
}

}  // namespace
}  // namespace carom
