#include "engine/game/billiard_setup.h"

#include <algorithm>

#include <glm/geometric.hpp>

#include "engine/collision/spinning_body.h"

namespace carom {

double radiusOf_m(const std::vector<Vec2>& outline_m) {
  double radius_m = 0.0;
  for (const Vec2& corner_m : outline_m) radius_m = std::max(radius_m, glm::length(corner_m));
  return radius_m;
}

double rimUOf(const Puck& puck, double spin_kg_m2_s, double c_m_s) {
  return spin_kg_m2_s / (puck.radius_m * c_m_s * puck.inertia * puck.mass_kg);
}

double spinOfRim_kg_m2_s(const Puck& puck, double rim_u, double c_m_s) {
  return rim_u * puck.inertia * puck.mass_kg * puck.radius_m * c_m_s;
}

double spinAt_kg_m2_s(const Puck& puck, double omega_rad_s, double c_m_s) {
  const SpinningBody body{puck.mass_kg, puck.inertia * puck.mass_kg};
  return spinOfRim(body, omega_rad_s * puck.radius_m / c_m_s) * puck.radius_m * c_m_s;
}

double restMass_kg(const Puck& puck, double spin_kg_m2_s, double c_m_s) {
  return restMass({puck.mass_kg, puck.inertia * puck.mass_kg}, spin_kg_m2_s / (puck.radius_m * c_m_s));
}

}  // namespace carom
