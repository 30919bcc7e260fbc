#pragma once
// The blow of a contact: a half-sine of 40 ms along the change of momentum, whose impulse is a share of it.
//
//   F(t) = F_peak sin(pi t/T), 0 <= t <= T     J = integral of F = (2/pi) F_peak T
//
// The change m c gives 60 % of the strongest force, and a larger one gives no more than the device can do.
// Theory: app/doc/physics.md, Force in the hand.

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace carom {

inline constexpr double kBlow_s = 0.040, kBlowShare = 0.6;

struct Blow {
  double start_s = 0.0;    ///< on the loop's clock
  glm::dvec3 peak_n{0.0};  ///< force in the middle of it

  /// Returns its force at a time.
  glm::dvec3 at(double time_s) const {
    const double share = (time_s - start_s) / kBlow_s;
    return share > 0.0 && share < 1.0 ? std::sin(std::numbers::pi * share) * peak_n : glm::dvec3(0.0);
  }
  double impulse_ns() const { return 2.0 / std::numbers::pi * glm::length(peak_n) * kBlow_s; }
};

/// Returns the blow of a change of momentum, in units of m c, that begins at `start_s`.
inline Blow blowOf(const glm::dvec3& change, double start_s, double forceMax_n) {
  const double size = glm::length(change);
  if (!(size > 0.0)) return {start_s, glm::dvec3(0.0)};
  return {start_s, std::min(kBlowShare, 1.0 / size) * forceMax_n * change};
}

/// Returns how strongly a motor without a direction rumbles with a change of momentum, 0 to 1: the logarithm
/// log(1 + |dp|/(0.1 m c)), which is 1 from 3 m c on.
inline double rumbleOf(double change) {
  return std::clamp(std::log1p(change / 0.1) / std::log1p(3.0 / 0.1), 0.0, 1.0);
}

}  // namespace carom
