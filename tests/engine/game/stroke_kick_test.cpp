#include "engine/game/stroke_kick.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/random_world.h"

namespace carom {
namespace {

constexpr double kRadius_m = 0.03;

PuckStroke strokeOf(double px, double py, double offset) {
  PuckStroke stroke;
  stroke.px = px;
  stroke.py = py;
  stroke.offset = offset;
  return stroke;
}

// J' = b |Δp|, in units of R c.
TEST(StrokeKick, APuckAtRestGetsTheSpinOfTheLever) {
  const SpinningBody body{0.2, 0.1};
  for (const double offset : {-0.02, -0.001, 0.01, 0.03}) {
    const StruckPuck struck = struckPuck(body, kRadius_m, strokeOf(0.03, 0.04, offset), {1.0, 0.0, 0.0}, 0.0);
    EXPECT_NEAR(struck.j, offset * 0.05 / kRadius_m, 1e-15) << offset;
    EXPECT_NEAR(struck.u.x * restMass(body, struck.j), 0.03, 1e-15);
    EXPECT_NEAR(struck.u.y * restMass(body, struck.j), 0.04, 1e-15);
  }
}

// The momentum that was given is the difference; the spin is where the iteration J ← J + det(u, d, (E' − E,
// Δp))/R comes to rest, E' with the mass of the last J.
TEST(StrokeKick, MomentumAndSpinAreThoseOfASlowIteration) {
  test::Random random(33);
  for (int i = 0; i < 500; ++i) {
    CASE(random, i);
    const SpinningBody body{random.in(0.1, 1.0), random.in(0.02, 0.1)};
    const Vec21 u = fourVelocity(random.in(-1.5, 1.5), random.in(-1.5, 1.5));
    const double j = random.in(-0.1, 0.1);
    const PuckStroke stroke = strokeOf(random.in(-1.0, 1.0), random.in(-1.0, 1.0), random.in(-0.01, 0.01));
    const StruckPuck struck = struckPuck(body, kRadius_m, stroke, u, j);
    const double mass = restMass(body, j), after = restMass(body, struck.j);
    EXPECT_NEAR(struck.u.x * after, u.x * mass + stroke.px, 1e-13);
    EXPECT_NEAR(struck.u.y * after, u.y * mass + stroke.py, 1e-13);

    // d, to the right of the momentum in the puck's rest frame, as the board has it.
    const double size = std::hypot(stroke.px, stroke.py);
    const double rx = stroke.offset * stroke.py / size, ry = -stroke.offset * stroke.px / size;
    const double ur = u.x * rx + u.y * ry;
    const Vec21 d{ur, rx + u.x * ur / (1.0 + u.t), ry + u.y * ur / (1.0 + u.t)};
    const double px = u.x * mass + stroke.px, py = u.y * mass + stroke.py;
    double slow = j;
    for (int step = 0; step < 2000; ++step) {
      const double energy = std::hypot(restMass(body, slow), std::hypot(px, py)) - u.t * mass;
      const Vec21 given{energy, stroke.px, stroke.py};
      // det(u, d, given), row by row.
      const double det = u.t * (d.x * given.y - d.y * given.x) - u.x * (d.t * given.y - d.y * given.t) +
                         u.y * (d.t * given.x - d.x * given.t);
      slow = 0.5 * (slow + j + det / kRadius_m);
    }
    EXPECT_NEAR(struck.j, slow, 1e-12);
  }
}

TEST(StrokeKick, MirrorImagesAreMirroredToTheBit) {
  test::Random random(34);
  for (int i = 0; i < 500; ++i) {
    CASE(random, i);
    const SpinningBody body{0.2, random.in(0.02, 0.1)};
    const Vec21 u = fourVelocity(random.in(-1.5, 1.5), random.in(-1.5, 1.5));
    const double j = random.in(-0.1, 0.1), px = random.in(-1.0, 1.0), py = random.in(-1.0, 1.0);
    const double offset = random.in(-2.0 * kRadius_m, 2.0 * kRadius_m);
    const StruckPuck one = struckPuck(body, kRadius_m, strokeOf(px, py, offset), u, j);
    const StruckPuck image = struckPuck(body, kRadius_m, strokeOf(px, -py, -offset), {u.t, u.x, -u.y}, -j);
    EXPECT_EQ(one.u.x, image.u.x);
    EXPECT_EQ(one.u.y, -image.u.y);
    EXPECT_EQ(one.j, -image.j);
  }
}

TEST(StrokeKick, AStrokeThroughTheCentreKeepsTheSpin) {
  const SpinningBody body{0.2, 0.05};
  const StruckPuck struck = struckPuck(body, kRadius_m, strokeOf(0.3, 0.0, 0.0), {1.0, 0.0, 0.0}, 0.04);
  EXPECT_EQ(struck.j, 0.04);
  EXPECT_NEAR(struck.u.x, 0.3 / restMass(body, 0.04), 1e-15);
}

}  // namespace
}  // namespace carom
