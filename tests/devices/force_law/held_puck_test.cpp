// The held puck's proxy against a slow reference, and its inertia against the closed form.

#include "devices/force_law/held_puck.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/random_world.h"

namespace carom {
namespace {

double gammaOf(double beta) { return 1.0 / std::sqrt(1.0 - beta * beta); }

// A steady push of the hand's frame at a tiny acceleration a: the force is γ³m a along and γm a across, which
// a proxy stiffly coupled shows once it follows.
TEST(HeldPuck, IsAsHeavyAsRelativitySays) {
  for (const double beta : {0.0, 0.3, 0.5, 0.8, 0.9, 0.99}) {
    for (const bool isAcross : {false, true}) {
      const double m = 0.2, c = 1.42, T = 1e-4;
      const HeldPuckLaw law{m, c, {beta * c, 0.0, 0.0}, 6e4, 200.0};
      HeldPuck puck(law, glm::dvec3(0.0));
      const double a_m_s2 = 1e-3 * c * (1.0 - beta), gamma = gammaOf(beta);
      const glm::dvec3 way = isAcross ? glm::dvec3(0.0, 0.0, 1.0) : glm::dvec3(1.0, 0.0, 0.0);
      glm::dvec3 force_n(0.0);
      for (int i = 1; i <= 20000; ++i) {
        const double t = i * T;
        force_n = puck.step(0.5 * a_m_s2 * t * t * way, a_m_s2 * t * way, T);
      }
      const double mass_kg = isAcross ? gamma * m : gamma * gamma * gamma * m;
      EXPECT_NEAR(-glm::dot(force_n, way) / a_m_s2 / mass_kg, 1.0, 0.02) << beta << ' ' << isAcross;
    }
  }
}

// The step solves its equation: dp/T = K (x' − y') + B (x'' − w) with the new y' and w, by putting them in.
TEST(HeldPuck, EachStepSolvesItsEquation) {
  test::Random random(4303);
  for (int i = 0; i < 2000; ++i) {
    if (!random.begin(static_cast<std::uint64_t>(i))) continue;
    const double c = random.in(0.3, 30.0), T = random.in(5e-4, 8e-3), beta = random.in(0.0, 0.99);
    HeldPuckLaw law{random.in(0.05, 1.0), c, beta * c * random.direction(), random.in(50.0, 3000.0),
                    random.in(0.0, 2.0)};
    SCOPED_TRACE(testing::PrintToString(random));
    HeldPuck puck(law, glm::dvec3(0.0));
    glm::dvec3 y_m(0.0);
    for (int step = 0; step < 20; ++step) {
      const glm::dvec3 x_m = random.inBox(0.02), v_m_s = random.inBox(0.3);
      const glm::dvec3 force_n = puck.step(x_m, v_m_s, T);
      const glm::dvec3 w = puck.velocity_m_s() - law.carried_m_s;
      y_m += T * w;
      const glm::dvec3 expected_n = -(law.stiffness_n_m * (x_m - y_m) + law.damping_ns_m * (v_m_s - w));
      const double scale_n = 1.0 + glm::length(expected_n);
      ASSERT_NEAR(glm::distance(force_n, expected_n) / scale_n, 0.0, 1e-7) << step;
      ASSERT_LT(glm::length(puck.velocity_m_s()), c);
      ASSERT_GE(puck.stored_j(), -1e-9 * law.mass_kg * c * c * gammaOf(beta));
    }
  }
}

// An explicit step of the same law explodes where this one settles.
TEST(HeldPuck, SettlesWhereAnExplicitStepExplodes) {
  const double m = 0.2, T = 1e-3, K = 3e6;
  HeldPuck puck({m, 1.42, glm::dvec3(0.0), K, 20.0}, glm::dvec3(0.0));
  double explicitY = 0.0, explicitP = 0.0, first_n = 0.0, last_n = 0.0;
  for (int i = 0; i < 2000; ++i) {
    last_n = glm::length(puck.step({0.01, 0.0, 0.0}, glm::dvec3(0.0), T));
    if (i == 0) first_n = last_n;
    explicitP += T * K * (0.01 - explicitY);
    explicitY += T * explicitP / std::hypot(m, explicitP / 1.42);
  }
  EXPECT_LT(last_n, 1e-2 * first_n);
  EXPECT_GT(std::abs(explicitP), 1.0) << "the reference does explode";
}

}  // namespace
}  // namespace carom
