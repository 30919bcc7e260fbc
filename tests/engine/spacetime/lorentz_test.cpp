#include "engine/spacetime/lorentz.h"

#include <gtest/gtest.h>

#include "engine/light_speed.h"
#include "engine/random_world.h"

namespace carom {
namespace {

using test::kC_m_s;
constexpr double kRounding = 1e-13;  // a few hundred double ulps

double difference(const Displacement& a, const Displacement& b) {
  return std::abs(kC_m_s * (a.dt_s - b.dt_s)) + glm::length(a.dr_m - b.dr_m);
}

TEST(Lorentz, IntervalIsInvariantAndInverseUndoes) {
  test::Random random(1);
  for (int i = 0; i < 1000; ++i) {
    CASE(random, i);
    const Vec3 u = random.u(0.99);
    const Displacement d{random.in(-3, 3), random.inBox(3.0)};
    const Lorentz aFromB = Lorentz::boost(u, kC_m_s);
    const double scale = gammaFromU(u) * gammaFromU(u) * 20.0;
    SCOPED_TRACE(testing::Message() << "u " << u.x << " " << u.y << " " << u.z << " dt " << d.dt_s);
    ASSERT_LT(difference(aFromB.inverse() * (aFromB * d), d), kRounding * scale);
    ASSERT_LT(std::abs(interval_m2(aFromB * d, kC_m_s) - interval_m2(d, kC_m_s)), 10 * kRounding * scale);
  }
}

TEST(Lorentz, BoostByULeavesBehindRodContractedAndClockSlow) {
  const Lorentz boardFromBody = Lorentz::boost(uFromBeta({0.6, 0.0, 0.0}), kC_m_s);
  const Displacement tick = boardFromBody * Displacement{1.0, Vec3(0.0)};
  EXPECT_NEAR(tick.dt_s, 1.25, kRounding);
  EXPECT_NEAR(tick.dr_m.x, 0.6 * kC_m_s * 1.25, kRounding);
  // The far end of a rod of length 1, at the board time of its near end.
  const double simultaneous_s = -0.6 * 1.0 / kC_m_s;
  const Displacement rod = boardFromBody * Displacement{simultaneous_s, {1.0, 0.0, 0.0}};
  EXPECT_NEAR(rod.dt_s, 0.0, kRounding);
  EXPECT_NEAR(rod.dr_m.x, 0.8, kRounding);
}

TEST(Lorentz, CollinearRapiditiesAdd) {
  const auto along = [](double eta) { return Lorentz::boost({std::sinh(eta), 0.0, 0.0}, kC_m_s); };
  const Vec3 u = (along(0.7) * along(1.1)).u();
  EXPECT_NEAR(u.x, std::sinh(1.8), 1e-12);
  const Vec3 oblique = Lorentz::fromRapidity({0.9, 0.0, 1.2}, kC_m_s).u();  // of size 1.5
  EXPECT_NEAR(oblique.x, 0.6 * std::sinh(1.5), 1e-12);
  EXPECT_NEAR(oblique.z, 0.8 * std::sinh(1.5), 1e-12);
}

// Perpendicular boosts leave a turn of the axes: tan(ε/2) = sin θ/(cos θ + D), D² =
// (γ1+1)(γ2+1)/((γ1−1)(γ2−1)), here θ = 90° (Thomas–Wigner; e.g. Ungar, Found. Phys. 19 (1989) 1385).
TEST(Lorentz, PerpendicularBoostsTurnByTheWignerAngle) {
  const Vec3 ux = uFromBeta({0.8, 0.0, 0.0});
  const Vec3 uy = uFromBeta({0.0, 0.6, 0.0});
  const Lorentz both = Lorentz::boost(ux, kC_m_s) * Lorentz::boost(uy, kC_m_s);
  const Lorentz turn = Lorentz::boost(-both.u(), kC_m_s) * both;
  const double g1 = gammaFromU(ux);
  const double g2 = gammaFromU(uy);
  const double angle_rad = 2.0 * std::atan(std::sqrt((g1 - 1) * (g2 - 1) / ((g1 + 1) * (g2 + 1))));
  const Displacement x = turn * Displacement{0.0, {1.0, 0.0, 0.0}};
  EXPECT_NEAR(x.dt_s, 0.0, 1e-12);
  EXPECT_NEAR(std::abs(std::atan2(x.dr_m.y, x.dr_m.x)), angle_rad, 1e-12);
}

TEST(Lorentz, OrthonormalisedRemovesDriftOfManyProducts) {
  test::Random random(2);
  Lorentz drifting(kC_m_s);
  for (int i = 0; i < 20000; ++i) {
    CASE(random, i);
    drifting = drifting * Lorentz::boost(random.direction() * 1e-3, kC_m_s);
    drifting = drifting.orthonormalised();
  }
  const Displacement d{1.0, {1.0, -2.0, 0.5}};
  EXPECT_LT(difference(drifting.inverse() * (drifting * d), d), 1e-12);
}

TEST(Lorentz, UOfBetaAndBack) {
  const Vec3 beta{0.3, -0.4, 0.5};
  EXPECT_LT(glm::length(betaFromU(uFromBeta(beta)) - beta), 1e-15);
}

}  // namespace
}  // namespace carom
