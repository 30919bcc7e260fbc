#include "engine/light/light_path.h"

#include <algorithm>
#include <cmath>

namespace carom {

double lengthOf(std::span<const Vec3> path_m) {
  double length_m = 0.0;
  for (std::size_t i = 0; i + 1 < path_m.size(); ++i) length_m += glm::distance(path_m[i], path_m[i + 1]);
  return length_m;
}

Vec3 placeAlong(std::span<const Vec3> path_m, double along_m) {
  for (std::size_t i = 0; i + 1 < path_m.size(); ++i) {
    const double leg_m = glm::distance(path_m[i], path_m[i + 1]);
    if (along_m < leg_m) return glm::mix(path_m[i], path_m[i + 1], std::max(along_m, 0.0) / leg_m);
    along_m -= leg_m;
  }
  return path_m.back();
}

// On a leg r(s) = a + n s, |n| = 1, s metres after it began at t_a, with d = r_o − a and T = c (t_o − t_a):
//   T − s = |d − n s|  (light from there reaches the eye now)  ⟹  s = (T² − d²)/(2 (T − d·n))
// (both squared; s² falls out, since the pulse is as fast as its light). T − s − |d − n s| never grows with
// s: there is one root, and none on this leg before its beginning is seen, at T = |d|. Numerator as a
// product: nothing cancels when the pulse has only just begun.
double seenAlong_m(double start_s, std::span<const Vec3> path_m, const Event& observation, double c_m_s) {
  double begun_m = 0.0;  // of the path, where this leg begins
  for (std::size_t i = 0; i + 1 < path_m.size(); ++i) {
    const Vec3 d = observation.r_m - path_m[i];
    const double T = c_m_s * (observation.t_s - start_s) - begun_m;
    const double distance_m = glm::length(d);
    if (T < distance_m) return begun_m;
    const double leg_m = glm::distance(path_m[i], path_m[i + 1]);
    const double product = (T - distance_m) * (T + distance_m);
    const double below = 2.0 * (leg_m * T - glm::dot(d, path_m[i + 1] - path_m[i]));  // 2 leg (T − d·n)
    // s < leg: not so, either, where it ran straight at the eye and both are 0.
    if (product * leg_m < leg_m * below) return begun_m + product * leg_m / below;
    begun_m += leg_m;
  }
  return begun_m;
}

double reached_m(double start_s, std::span<const Vec3> path_m, double t_s, double c_m_s) {
  return std::clamp(c_m_s * (t_s - start_s), 0.0, lengthOf(path_m));
}

// |d + c β s| = c (τ + s) with d = r − r_e, τ = t − t_e: (1 − β²) (c s)² + 2 (c τ − d·β) c s − (d² − c² τ²) =
// 0 has one root s ≥ 0 where light is short of the point, c τ < |d|. It is written so that nothing cancels.
Event lightMeets(const Event& from, const Event& at, const Vec3& beta, double c_m_s) {
  const Vec3 away_m = at.r_m - from.r_m;
  const double gone_m = c_m_s * (at.t_s - from.t_s), left_m2 = glm::dot(away_m, away_m) - gone_m * gone_m;
  if (gone_m > 0.0 && !(left_m2 > 0.0)) return at;
  const double a = 1.0 - glm::dot(beta, beta), b_m = gone_m - glm::dot(away_m, beta);
  const double root_m = std::sqrt(b_m * b_m + a * left_m2);
  const double still_m = b_m > 0.0 ? left_m2 / (b_m + root_m) : (root_m - b_m) / a;
  return {at.t_s + still_m / c_m_s, at.r_m + still_m * beta};
}

}  // namespace carom
