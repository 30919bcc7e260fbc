#pragma once
// Closed surfaces of triangles, and the simple ones that mark events and paths. Metres; seen from outside,
// the corners of a triangle go round anticlockwise.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/spacetime/event.h"

namespace carom {

struct SolidMesh {
  std::vector<Vec3> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// Some triangles of a surface, one after the other.
struct TriangleRange {
  std::size_t first = 0, count = 0;
};

/// Returns the volume inside by the divergence theorem, V = Σ a·(b × c)/6: negative where it is inside out.
double volume_m3(const SolidMesh& solid);

/// Returns a ball: an octahedron whose triangles are divided `kBallDivisions` times.
SolidMesh ball(const Vec3& middle_m, double radius_m);

/// Returns a box between two corners, each coordinate of `low_m` below that of `high_m`.
SolidMesh box(const Vec3& low_m, const Vec3& high_m);

/// Returns a rod of eight sides along a path of two points at least, each at another place than the last.
/// Where the path bends, the sides meet in the plane that halves the angle.
SolidMesh rod(std::span<const Vec3> path_m, double radius_m);

}  // namespace carom
