#include "app/link/stroke_check.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace carom {

std::string strokeFault(const Stroke& stroke, std::span<const Puck> pucks, double c_m_s) {
  if (stroke.puck >= pucks.size()) return "a stroke on no puck";
  const Puck& puck = pucks[stroke.puck];
  constexpr double kRounding = 1e-9;
  const double most_kg_m_s = kStrongestU * puck.mass_kg * c_m_s * (1.0 + kRounding);
  if (!(glm::length(stroke.momentum_kg_m_s) <= most_kg_m_s)) return "a stroke harder than a hand can make";
  if (!(std::abs(stroke.offset_m) < puck.radius_m)) return "a stroke beside the puck";
  return {};
}

}  // namespace carom
