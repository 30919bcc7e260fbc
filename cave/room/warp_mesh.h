#pragma once
// How a projector's picture is warped onto its screen, by meshes from files, which are not trusted. The two
// formats are read as SGCT reads its warping meshes (sgct/src/correction/obj.cpp and pfm.cpp, SGCT 4).

#include <array>
#include <cstdint>
#include <filesystem>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>

#include "cave/room/skewed_screen.h"

namespace carom {

/// A point of the picture and its place in the window. Both are counted from the lower left, 0 to 1.
struct WarpPoint {
  glm::vec2 inWindow{0.0F};
  glm::vec2 inPicture{0.0F};
  /// Places in the picture are interpolated as inPicture · weight and weight, each linearly, and then
  /// divided: with equal weights the place is linear, with those of a homography it is this homography.
  float weight = 1.0F;
};

/// Triangles in the window; places in the picture are interpolated within them, as WarpPoint says. Where
/// triangles overlap, the later one is visible.
struct WarpMesh {
  std::vector<WarpPoint> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< indices of points
};

/// A mesh for each eye. A wall with one picture uses the mesh of the eye that it shows; a mono wall uses the
/// left one.
struct Warp {
  WarpMesh left;
  WarpMesh right;
};

/// Returns the warp with which the picture fills the window.
Warp straightWarp();

/// Returns the warp with which the part of the picture that the screen shows fills the window.
Warp skewWarp(const SkewedScreen& screen);

/// Wavefront OBJ, the same for both eyes: `v x y` is a place in the window, from -1, -1 in its lower left to
/// 1, 1; `vt s t` with the same number is its place in the picture, 0 to 1; `f` is a convex polygon of such
/// numbers.
/// PFM, "PF": a grid with three floats per point, row by row from the picture's top; its left half belongs to
/// the left eye, its right half to the right eye. Point (column, row) of an eye's columns × rows is at
/// (column + 0.5) / columns, 1 - (row + 0.5) / rows in the picture; its floats are the place in the window, x
/// to the right and y upwards, 0 to 1, and one that is not used. A negative scale in the header means that
/// floats are little-endian.
/// Every number must be finite and within 16 of the window's middle, in its own units, and there must be at
/// least one triangle. Both throw std::runtime_error, "LINE:COLUMN: …" (for bytes of a PFM's grid "1:1: …, at
/// byte N").
Warp parseObjWarp(std::string_view content);
Warp parsePfmWarp(std::string_view content);

/// Returns the mesh in a file (InputKind::warp) that ends in .obj or .pfm. Throws std::runtime_error,
/// "FILE:LINE:COLUMN: what is wrong, what was expected".
Warp readWarp(const std::filesystem::path& file);

}  // namespace carom
