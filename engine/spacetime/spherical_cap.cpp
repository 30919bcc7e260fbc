#include "engine/spacetime/spherical_cap.h"

#include <cmath>

namespace carom {

SphericalCap capOfSphere(const Vec3& middleFromEye_m, double radius_m) {
  const double distance_m = glm::length(middleFromEye_m);
  if (!(radius_m < distance_m)) return {};
  const double sine = radius_m / distance_m;
  return {middleFromEye_m / distance_m, std::sqrt((1.0 - sine) * (1.0 + sine)), sine, distance_m - radius_m};
}

SphericalCap carried(const SphericalCap& cap, const glm::dmat4& otherFromThis) {
  if (cap.isWholeSky()) return cap;
  const glm::dvec4 s = otherFromThis * glm::dvec4(-cap.cosine, cap.axis);
  const Vec3 axis(s.y, s.z, s.w);
  const double length = glm::length(axis);
  // Lengths of light rays shrink at most to e^−η = γ − |u| of them, which is 1/(γ + |u|). The first column of
  // the matrix is (γ, u).
  const Vec3 u(otherFromThis[0].y, otherFromThis[0].z, otherFromThis[0].w);
  return {axis / length, -s.x / length, cap.sine / length,
          cap.nearest_m / (otherFromThis[0].x + glm::length(u))};
}

}  // namespace carom
