#pragma once
// Wavefront OBJ: points, places in a picture, and faces of both.

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace carom {

/// Indices of a face's corner.
struct ObjCorner {
  std::uint32_t point = 0, inPicture = 0;
};

struct ObjFile {
  std::vector<glm::dvec3> points;     ///< of `v`
  std::vector<glm::dvec2> inPicture;  ///< of `vt`
  std::vector<std::array<ObjCorner, 3>> triangles;
};

/// What a file may have.
struct ObjWishes {
  int coordinates = 3;              ///< of `v` that are read: 2 or 3; what follows them is not
  double farthest = 1e9;            ///< of `v`, in magnitude
  double farthestInPicture = 16.0;  ///< of `vt`
  bool isPaired = false;            ///< each corner has one number for `v` and `vt`; else it needs both
  std::size_t mostPoints = 0;       ///< `v`, and as many `vt`; twice as many triangles
};

/// Reads `v`, `vt` and `f`, a convex polygon; corners count from 1. Passes over what else OBJ has. Throws
/// std::runtime_error, "LINE:COLUMN: …", for anything else, for NaN, too many points, corners that do not
/// exist, and a file without a face.
ObjFile parseObj(std::string_view content, const ObjWishes& wishes);

}  // namespace carom
