#include "devices/force_law/cue_force.h"

#include <algorithm>
#include <cmath>

namespace carom {

double passiveStiffness_n_m(const ForceLimits& limits, double lawDamping_ns_m) {
  return 2.0 * (limits.damping_ns_m - lawDamping_ns_m) / limits.spring_s;
}

double settlingStiffness_n_m(const ForceLimits& limits) {
  constexpr double kHand_ns_m = 4.0;
  return (limits.damping_ns_m + kHand_ns_m) / ((0.5 + limits.delay_ticks) * limits.period_s);
}

double couplingDamping_ns_m(const ForceLimits& limits, double stiffness_n_m) {
  return std::max(0.0, limits.damping_ns_m - stiffness_n_m * (0.5 + limits.delay_ticks) * limits.period_s);
}

double forceScale(double restEnergy_j, double d0_m, const ForceLimits& limits) {
  const double cosh = 1.0 / std::sqrt((1.0 - kScaledBeta) * (1.0 + kScaledBeta)), sinh = kScaledBeta * cosh;
  return std::min({1.0, limits.force_n * d0_m / (restEnergy_j * sinh),
                   limits.stiffness_n_m * d0_m * d0_m / (restEnergy_j * cosh)});
}

double CueForce::force_n(double draw_m) const {
  return scale * restEnergy_j / d0_m * std::sinh(draw_m / d0_m);
}

// cosh eta - 1 = 2 sinh^2(eta/2), which loses no digits of a short draw.
double CueForce::energy_j(double draw_m) const {
  const double half = std::sinh(0.5 * draw_m / d0_m);
  return scale * restEnergy_j * 2.0 * half * half;
}

double CueForce::stiffness_n_m(double draw_m) const {
  return scale * restEnergy_j / (d0_m * d0_m) * std::cosh(draw_m / d0_m);
}

double CueForce::beta(double draw_m) const { return std::tanh(draw_m / d0_m); }

double uOfDraw(double draw_m, double d0_m) { return std::sinh(draw_m / d0_m); }

}  // namespace carom
