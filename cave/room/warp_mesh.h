#pragma once
// How a projector's picture is warped onto its screen.

#include <array>
#include <cstdint>
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
  float light = 1.0F;  ///< share of it that passes; below 0: no triangle has this point
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

}  // namespace carom
