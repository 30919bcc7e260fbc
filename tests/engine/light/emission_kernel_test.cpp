#include "engine/light/emission_kernel.h"

#include <cmath>

#include <gtest/gtest.h>

#include "engine/light/light_cone.h"
#include "engine/light_speed.h"
#include "engine/random_world.h"

namespace carom {
namespace {

using test::kC_m_s;

struct Seen {
  double t_m = 0.0;  // c (t − t_o) on the board
  Vec3 fromEye_m{0.0};
};

/// What the kernel makes of one leg, taken back to the board.
template <class Leg, class Solve, class Vector>
Seen solved(const Leg& leg, const Solve& solve, const Vector& offset) {
  const auto found = solve(&leg, 1, offset);
  const auto row = [&](const auto& r) {
    return r.x * found.event.x + r.y * found.event.y + r.z * found.event.z + r.w * found.event.w;
  };
  return {leg.boardTime + row(leg.toBoardTime),
          Vec3(leg.seenCentre) + Vec3(row(leg.toSeenX), row(leg.toSeenY), row(leg.toSeenZ))};
}

// A body that has always moved evenly: its points' world lines are straight on the board, and the emission is
// found there by bisection of c (t_o − t) = |r_o − r(t)|, which falls strictly. The kernel solves in the
// body's frame. The head is at rest on the board.
TEST(EmissionKernel, AnEvenlyMovingPointIsSeenWhereBisectionFindsIt) {
  test::Random random(1);
  for (int i = 0; i < 2000; ++i) {
    CASE(random, i);
    const Vec3 u = random.u(0.95), start_m = random.inBox(1.0), offset_m = random.inBall(0.2);
    const WorldLine line({{0.0, start_m}, u, 0.0, {0.0, start_m}, 0.0}, kC_m_s, 0.2);
    const Event eye{random.in(-2.0, 2.0), random.inBox(2.0)};
    BodyView view;
    viewBody(line, eye, Lorentz(kC_m_s), view);
    ASSERT_EQ(view.legs.size(), 1u);
    const Seen found = solved(
        view.legs[0],
        [](const auto* leg, int legs, const Vec3& d) { return kernel::solveEmission(leg, legs, d); },
        offset_m);

    const Lorentz boardFromBody = Lorentz::boost(u, kC_m_s);
    const Displacement atBodyZero = boardFromBody * Displacement{0.0, offset_m};
    const Vec3 velocity_m_s = betaFromU(u) * kC_m_s;
    const auto placeAt = [&](double t_s) {
      return start_m + atBodyZero.dr_m + velocity_m_s * (t_s - atBodyZero.dt_s);
    };
    double early_s = eye.t_s - 200.0, late_s = eye.t_s;
    for (int step = 0; step < 100; ++step) {
      const double t_s = 0.5 * (early_s + late_s);
      (kC_m_s * (eye.t_s - t_s) > glm::length(eye.r_m - placeAt(t_s)) ? early_s : late_s) = t_s;
    }
    const double gamma = gammaFromU(u), distance_m = kC_m_s * (eye.t_s - early_s);
    const double rounding_m = 1e-13 * gamma * gamma * (1.0 + distance_m);
    EXPECT_NEAR(found.t_m, -distance_m, rounding_m);
    EXPECT_NEAR(glm::length(found.fromEye_m - (placeAt(early_s) - eye.r_m)), 0.0, 2.0 * rounding_m);

    // The same text in float, as the GPU computes it.
    const kernel_float::LegView leg = toFloat(view.legs[0]);
    const Seen inFloat = solved(
        leg,
        [](const auto* l, int legs, const glm::vec3& d) { return kernel_float::solveEmission(l, legs, d); },
        glm::vec3(offset_m));
    EXPECT_NEAR(glm::length(inFloat.fromEye_m - found.fromEye_m), 0.0,
                4e-6 * gamma * gamma * (1.0 + distance_m));
  }
}

// (|e − d| − |e|) of numbers far apart: the kernel's way does not lose what the plain difference loses.
TEST(EmissionKernel, TheExtraDistanceOfAFarBodyIsExact) {
  test::Random random(2);
  for (int i = 0; i < 1000; ++i) {
    CASE(random, i);
    kernel_float::LegView leg{};
    const Vec3 eye = random.direction() * random.in(10.0, 1000.0);
    leg.eye = eye;
    leg.distance = glm::length(leg.eye);
    const glm::vec3 d = random.inBall(0.05);
    const double exact = glm::length(Vec3(leg.eye) - Vec3(d)) - glm::length(Vec3(leg.eye));
    EXPECT_NEAR(kernel_float::extraDistance(leg, d), exact, 1e-8);
  }
}

TEST(EmissionKernel, NewsReachesWhatItsConeHolds) {
  const glm::dvec4 signal{1.0, 0.0, 0.0, 0.0};
  EXPECT_TRUE(kernel::reachedBy(signal, {1.5, 0.3, 0.4, 0.0}));
  EXPECT_FALSE(kernel::reachedBy(signal, {1.49, 0.3, 0.4, 0.0}));
  EXPECT_FALSE(kernel::reachedBy(signal, {0.0, 0.0, 0.0, 0.0}));
  EXPECT_TRUE(kernel::reachedBy(signal, signal));
}

}  // namespace
}  // namespace carom
