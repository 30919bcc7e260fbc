#pragma once
// What a mesh covers of the table that it stands on, seen from above.

#include <cstddef>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

namespace carom {

/// A footprint leaves what a mesh covers outwards by at most this share of its radius; it has more corners
/// than these only where fewer would leave it by more.
inline constexpr double kFootprintOutwards = 0.01;
inline constexpr std::size_t kEnoughCorners = 16;

/// How a mesh is placed and scaled for a body.
struct MeshPlace {
  glm::dvec2 centre{0.0};  ///< x and y of the body's centre in the mesh
  double scale = 1.0;      ///< metres of the body for one of the mesh
};

/// The outline of what a mesh covers, in the mesh's units and axes.
struct Footprint {
  std::vector<glm::dvec2>
      corners;               ///< from the centre, anticlockwise: an outline (engine/polygons/outline.h)
  glm::dvec2 centre{0.0};    ///< of mass of an even plate with this outline, in the mesh
  double radius = 0.0;       ///< of the farthest corner from the centre
  bool isInOnePiece = true;  ///< otherwise the outline is around the convex hull of several pieces
};

/// Returns the footprint of triangles, given by three corners each. Holes are covered. Throws
/// std::runtime_error if it has no area or needs too many corners.
Footprint footprintOf(std::span<const glm::dvec2> triangles);

}  // namespace carom
