#include "app/viewer/thrust_way.h"

#include <algorithm>

#include <glm/geometric.hpp>

namespace carom {
namespace {

/// Returns the share of a planned thrust that the platform has.
double shareOf(const Thrust& planned, double strongest_m_s2) {
  const double planned_m_s2 = glm::length(planned.thrust_m_s2);
  return planned_m_s2 > strongest_m_s2 * (1.0 + 1e-9) ? strongest_m_s2 / planned_m_s2 : 1.0;
}

}  // namespace

void ThrustWay::take(std::span<const Thrust> way) {
  thrusts_.assign(way.begin(), way.end());
  at_ = 0;
  passed_s_ = 0.0;
}

Vec3 ThrustWay::gain_m_s(double for_s, double strongest_m_s2) const {
  std::size_t at = at_;
  double passed_s = passed_s_;
  return along(for_s, strongest_m_s2, at, passed_s);
}

/// Returns what the way adds in so much time after `passed_s` of the thrust `at`, and advances both.
Vec3 ThrustWay::along(double for_s, double strongest_m_s2, std::size_t& at, double& passed_s) const {
  Vec3 gain_m_s(0.0);
  while (at < thrusts_.size()) {
    const double share = shareOf(thrusts_[at], strongest_m_s2),
                 rest_s = (thrusts_[at].for_s - passed_s) / share;
    const double here_s = std::min(rest_s, for_s);
    gain_m_s += thrusts_[at].thrust_m_s2 * (share * here_s);
    for_s -= here_s;
    if (here_s < rest_s) {
      passed_s += here_s * share;
      break;
    }
    ++at;
    passed_s = 0.0;
  }
  return gain_m_s;
}

}  // namespace carom
