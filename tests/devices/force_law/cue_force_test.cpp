// The cue's law against closed forms, its own derivatives and integrals.

#include "devices/force_law/cue_force.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/random_world.h"

namespace carom {
namespace {

constexpr double kMass_kg = 0.2, kLight_m_s = 1.42, kRest_j = kMass_kg * kLight_m_s * kLight_m_s;

// The figures of the law for 8 cm, 0.2 kg and 1.42 m/s, written down once by hand: draws and forces.
TEST(CueForce, HasTheFiguresOfItsTable) {
  const CueForce cue{kRest_j, 0.08, 1.0};
  for (const auto& [beta, draw_m, force_n] : {std::array{0.5, 0.044, 2.9},
                                              {0.87, 0.107, 8.9},
                                              {0.9, 0.118, 10.4},
                                              {0.95, 0.147, 15.3},
                                              {0.99, 0.212, 35.0}}) {
    const double there_m = 0.08 * std::atanh(beta);
    EXPECT_NEAR(there_m, draw_m, 6e-4) << beta;
    EXPECT_NEAR(cue.force_n(there_m), force_n, 0.4) << beta;
    EXPECT_NEAR(cue.beta(there_m), beta, 1e-15);
  }
}

// W = s (E − m c²) of p = m c sinh η, by the energy of the puck; F = dW/dd and k = dF/dd by differences.
TEST(CueForce, StoresTheKineticEnergyOfTheStroke) {
  test::Random random(4301);
  for (int i = 0; i < 1000; ++i) {
    if (!random.begin(static_cast<std::uint64_t>(i))) continue;
    const double d0_m = random.in(0.02, 0.5), scale = random.in(0.01, 1.0);
    const double draw_m = d0_m * random.in(0.01, 3.0);
    const CueForce cue{kRest_j, d0_m, scale};
    SCOPED_TRACE(testing::PrintToString(random));
    const double u = uOfDraw(draw_m, d0_m), kinetic_j = kRest_j * (u * u / (1.0 + std::sqrt(1.0 + u * u)));
    EXPECT_NEAR(cue.energy_j(draw_m) / (scale * kinetic_j), 1.0, 1e-14);
    const double h_m = 1e-4 * d0_m;
    const double slope_n = (cue.energy_j(draw_m + h_m) - cue.energy_j(draw_m - h_m)) / (2.0 * h_m);
    EXPECT_NEAR(slope_n / cue.force_n(draw_m), 1.0, 1e-8);
    const double k_n_m = (cue.force_n(draw_m + h_m) - cue.force_n(draw_m - h_m)) / (2.0 * h_m);
    EXPECT_NEAR(k_n_m / cue.stiffness_n_m(draw_m), 1.0, 1e-8);
  }
}

TEST(CueForce, TheScaleReachesTheLimitsAndNeverPassesThem) {
  test::Random random(4302);
  for (int i = 0; i < 1000; ++i) {
    if (!random.begin(static_cast<std::uint64_t>(i))) continue;
    ForceLimits limits;
    limits.force_n = random.in(0.1, 50.0);
    limits.stiffness_n_m = random.in(20.0, 3000.0);
    const double rest_j = random.in(1e-3, 10.0), d0_m = random.in(0.02, 0.5);
    SCOPED_TRACE(testing::PrintToString(random));
    const CueForce cue{rest_j, d0_m, forceScale(rest_j, d0_m, limits)};
    const double most_m = d0_m * std::atanh(kScaledBeta);
    const double force = cue.force_n(most_m) / limits.force_n,
                 stiffness = cue.stiffness_n_m(most_m) / limits.stiffness_n_m;
    EXPECT_LE(force, 1.0 + 1e-12);
    EXPECT_LE(stiffness, 1.0 + 1e-12);
    EXPECT_LE(cue.scale, 1.0);
    EXPECT_NEAR(std::max({force, stiffness, cue.scale}), 1.0, 1e-12) << "one of them is reached";
  }
}

TEST(CueForce, TheStiffestPassiveSpringIsTwiceTheDampingOverThePeriod) {
  EXPECT_EQ(passiveStiffness_n_m({}), 600.0);
  EXPECT_DOUBLE_EQ(passiveStiffness_n_m({}, 0.1), 400.0);
  EXPECT_DOUBLE_EQ(couplingDamping_ns_m({}, 100.0), 0.15)
      << "what is left for a damper, with a tick of delay";
  EXPECT_EQ(couplingDamping_ns_m({}, 900.0), 0.0);
}

}  // namespace
}  // namespace carom
