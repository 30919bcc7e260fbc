#include "app/scenario/scenario_spin.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>

namespace carom {

namespace {

/// Whether the rim of a puck with that celerity, γβ, is slower than light, rounding included.
bool slowerThanLight(double u) { return std::abs(u / std::hypot(1.0, u)) < 1.0; }

/// Returns what of a puck is farthest from its axis.
std::string rimOf(const Puck& puck) {
  if (puck.outline_m.empty()) return "the rim";
  const auto isNearer = [](const Vec2& a, const Vec2& b) { return glm::dot(a, a) < glm::dot(b, b); };
  const auto farthest = std::max_element(puck.outline_m.begin(), puck.outline_m.end(), isNearer);
  return fmt::format("corner {} at ({:.6g}, {:.6g}) m", farthest - puck.outline_m.begin() + 1, farthest->x,
                     farthest->y);
}

double spinOfRate(const TomlTable& table, const Puck& puck, double c_m_s) {
  const double omega_rad_s = table.number("spin_rad_s"), rim = omega_rad_s * puck.radius_m / c_m_s;
  const double most_rad_s = c_m_s / puck.radius_m;
  if (puck.radius_m == 0.0) return 0.0;  // why it is unknown has been said
  if (std::abs(rim) < 1.0) {
    const double spin_kg_m2_s = spinAt_kg_m2_s(puck, omega_rad_s, c_m_s);
    if (slowerThanLight(rimUOf(puck, spin_kg_m2_s, c_m_s))) return spin_kg_m2_s;
  }
  table.fault("spin_rad_s", fmt::format("spin_rad_s is {}, so {} would move at {:.6g} c, expected less "
                                        "than {:.6g} rad/s for this radius",
                                        omega_rad_s, rimOf(puck), std::abs(rim), most_rad_s));
  return 0.0;
}

double angularMomentum(const TomlTable& table, const Puck& puck, double c_m_s) {
  const double spin_kg_m2_s = table.number("spin_kg_m2_s");
  if (puck.radius_m == 0.0) return 0.0;
  if (slowerThanLight(rimUOf(puck, spin_kg_m2_s, c_m_s))) return spin_kg_m2_s;
  constexpr double kMost_u = 1e7;  // a rim with that celerity differs from light by 5e-15
  table.fault(
      "spin_kg_m2_s",
      fmt::format("spin_kg_m2_s is {}, so {} would be as fast as light in all digits, expected "
                  "less than {:.6g} for this radius, mass and inertia",
                  spin_kg_m2_s, rimOf(puck), kMost_u * puck.inertia * puck.mass_kg * puck.radius_m * c_m_s));
  return 0.0;
}

}  // namespace

double readSpin(const TomlTable& table, const Puck& puck, double c_m_s) {
  const bool byRate = table.has("spin_rad_s"), byMomentum = table.has("spin_kg_m2_s");
  if (byRate && byMomentum) {
    table.fault("spin_kg_m2_s", "spin_kg_m2_s stands beside spin_rad_s, expected one of them");
  }
  if (byMomentum) return angularMomentum(table, puck, c_m_s);
  return byRate ? spinOfRate(table, puck, c_m_s) : 0.0;
}

void checkOffset(const TomlTable& table, const Stroke& stroke, const Puck& puck) {
  if (std::abs(stroke.offset_m) <= puck.radius_m) return;
  table.fault("offset_m", fmt::format("offset_m is {}, so the stroke passes beside puck '{}', expected at "
                                      "most its radius, {} m, to either side",
                                      stroke.offset_m, puck.name, puck.radius_m));
}

std::vector<Finding> oddSpin(const TomlTable& table, const Puck& puck, bool hasMesh, double c_m_s) {
  constexpr double kSharpRim = 0.99;     // up to which four steps of the kernel's search do
  constexpr double kSolidInertia = 0.5;  // of a uniform disc
  std::vector<Finding> odd;
  const double u = std::abs(rimUOf(puck, puck.spin_kg_m2_s, c_m_s)), rim = u / std::sqrt(1.0 + u * u);
  if (rim > kSharpRim) {
    const char* key = table.has("spin_rad_s") ? "spin_rad_s" : "spin_kg_m2_s";
    odd.push_back({.at = table.place(key),
                   .text = fmt::format("{} of puck '{}' moves at {:.6g} c, expected at most {} c",
                                       rimOf(puck), puck.name, rim, kSharpRim)});
  }
  if (table.has("inertia") && puck.inertia > kSolidInertia && hasMesh) {
    odd.push_back({.at = table.place("inertia"),
                   .text = fmt::format("inertia is {}, more than a solid disc has, expected at most {}",
                                       puck.inertia, kSolidInertia)});
  }
  return odd;
}

std::vector<Finding> oddFriction(const TomlTable& physics, const PhysicsRules& rules) {
  if (rules.tangentialRestitution == 0.0 || rules.puckFriction > 0.0 || rules.cushionFriction > 0.0)
    return {};
  return {{.at = physics.place("tangential_restitution"),
           .text = "tangential_restitution does nothing without friction, expected puck_friction or "
                   "cushion_friction above 0"}};
}

}  // namespace carom
