#include "engine/spacetime/simultaneity.h"

#include <cmath>

namespace carom {
namespace {

constexpr double kRounding = 1e-12;

}  // namespace

const char* toString(Separation separation) {
  switch (separation) {
    case Separation::timelike:
      return "timelike";
    case Separation::lightlike:
      return "lightlike";
    case Separation::spacelike:
      break;
  }
  return "spacelike";
}

Relation relationOf(const Displacement& d, double c_m_s) {
  const double ct_m = c_m_s * d.dt_s;
  const double r2_m2 = glm::dot(d.dr_m, d.dr_m);
  const double s2_m2 = interval_m2(d, c_m_s);
  if (!(std::abs(s2_m2) > kRounding * (ct_m * ct_m + r2_m2))) return {};
  if (s2_m2 > 0.0) return {Separation::timelike, std::sqrt(s2_m2), d.dr_m / ct_m};
  return {Separation::spacelike, std::sqrt(-s2_m2), d.dr_m * (ct_m / r2_m2)};
}

}  // namespace carom
