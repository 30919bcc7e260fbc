#pragma once
// Grids of points as warp meshes.

#include <cstddef>
#include <string_view>

#include "cave/room/warp_mesh.h"

namespace carom {

/// Numbers of warps beyond this, in windows or pictures, are in another unit, or none.
inline constexpr double kFarthestInWindow = 16.0;

/// Adds two triangles for each cell of a grid of points, row by row, but for cells with a point that is not
/// drawn: one whose light is below 0.
void addGridTriangles(std::size_t columns, std::size_t rows, WarpMesh& mesh);

}  // namespace carom
