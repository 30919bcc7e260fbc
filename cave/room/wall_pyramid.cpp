#include "cave/room/wall_pyramid.h"

#include <algorithm>

#include <glm/matrix.hpp>

namespace carom {
namespace {

constexpr double kRounding = 1e-4;  // of directions in single precision, at most (radians)
constexpr double kNearer = 0.99;    // decals are drawn this little nearer than they are, at most

}  // namespace

WallPyramid::WallPyramid(const glm::dmat4& clipFromDrawn) {
  const glm::dmat4 rows = glm::transpose(clipFromDrawn);
  for (std::size_t i = 0; i < 4; ++i) {
    const glm::dvec4 plane = rows[3] + (i % 2 == 0 ? 1.0 : -1.0) * rows[i < 2 ? 0 : 1];
    const double length = glm::length(Vec3(plane));
    planes_[i] = {Vec3(plane) / length, plane.w / length};
  }
}

// The cap's direction furthest inwards is at the angle θ − α from the normal, with θ that of the axis, so
// that its cosine is cos θ cos α + sin θ sin α; it is negative if θ > α + 90°, cos θ < −sin α. A whole cap
// beyond a plane is less than half the sky, and so is convex: faces between its points lie in it, too.
bool WallPyramid::mayShow(const SphericalCap& cap) const {
  if (cap.cosine <= 0.0) return true;
  return std::all_of(planes_.begin(), planes_.end(), [&](const Plane& plane) {
    const double cosine = glm::dot(plane.inwards, cap.axis);
    if (cosine >= -(cap.sine + kRounding)) return true;
    if (plane.eyeInside_m == 0.0) return false;
    const double furthest = cosine * cap.cosine + std::sqrt(std::max(1.0 - cosine * cosine, 0.0)) * cap.sine;
    return kNearer * cap.nearest_m * furthest + plane.eyeInside_m >= 0.0;
  });
}

}  // namespace carom
