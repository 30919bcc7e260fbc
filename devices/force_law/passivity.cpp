#include "devices/force_law/passivity.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace carom {
namespace {

constexpr double kReset_s = 1.0, kLeastCounts = 2.0;
constexpr double kLightest_kg = 0.1;  // what a device and a hand weigh at least, together

}  // namespace

void PortPassivity::observe(const glm::dvec3& moved_m, const glm::dvec3& held_n, double stored_j) {
  moved_m_ = moved_m;
  energy_j_ -= glm::dot(held_n, moved_m);
  above_s_ = energy_j_ > 0.0 ? above_s_ + limits_.period_s : 0.0;
  if (above_s_ < kReset_s) return;
  above_s_ = 0.0;
  energy_j_ = std::min(energy_j_, std::max(stored_j, 0.0));
}

glm::dvec3 PortPassivity::limited(const glm::dvec3& wished_n) {
  const double moved = glm::length(moved_m_);
  acts_ = false;
  if (moved < kLeastCounts * limits_.count_m) return wished_n;
  const double late_s = (1.0 + limits_.delay_ticks) * limits_.period_s, slew_n_s = limits_.force_n / kSlew_s;
  const double speed_m_s = moved / limits_.period_s;
  const double most_n =
      energy_j_ < 0.0
          ? std::max(energy_j_ / moved, -kLightest_kg / (2.0 * late_s - limits_.period_s) * speed_m_s)
          : slew_n_s * (std::sqrt(late_s * late_s + 2.0 * energy_j_ / (slew_n_s * speed_m_s)) - late_s);
  const glm::dvec3 way = moved_m_ / moved;
  const double gives_n = glm::dot(wished_n, way);
  acts_ = gives_n > most_n;
  return acts_ ? wished_n + (most_n - gives_n) * way : wished_n;
}

}  // namespace carom
