#include <cmath>

#include <fmt/format.h>

#include "cave/mesh_files/mesh_lines.h"
#include "cave/mesh_files/pfm_file.h"
#include "cave/mesh_files/warp_grid.h"
#include "cave/warps/warp_formats.h"
#include "engine/text/outside_file.h"

namespace carom {
namespace {

/// Returns one eye's part of the grid as a mesh.
WarpMesh meshOf(const PfmGrid& grid, std::size_t firstColumn) {
  const std::size_t columns = grid.columns / 2, rows = grid.rows;
  WarpMesh mesh;
  mesh.points.reserve(columns * rows);
  mesh.triangles.reserve(2 * (columns - 1) * (rows - 1));
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t column = 0; column < columns; ++column) {
      const glm::vec2 inPicture((static_cast<float>(column) + 0.5F) / static_cast<float>(columns),
                                1.0F - (static_cast<float>(row) + 0.5F) / static_cast<float>(rows));
      const std::size_t at = firstColumn + column;
      const glm::vec2 inWindow(grid.point(at, row));
      for (int part = 0; part < 2; ++part) {
        if (std::abs(inWindow[part]) <= kFarthestInWindow) continue;  // NaN is not
        meshFault(1, 1,
                  fmt::format("point ({}, {}) has {} for its {} in the window, at byte {}, expected a number "
                              "from {} to {}",
                              at, row, inWindow[part], part == 0 ? "x" : "y",
                              grid.byteOf(at, row, static_cast<std::size_t>(part)), -kFarthestInWindow,
                              kFarthestInWindow));
      }
      mesh.points.push_back({.inWindow = inWindow, .inPicture = inPicture});
    }
  }
  addGridTriangles(columns, rows, mesh);
  return mesh;
}

}  // namespace

Warp parsePfmWarp(std::string_view content) {
  const PfmGrid grid = parsePfm(content, true, (limitOf(InputKind::warp).most_MiB << 20U) / 12);
  return {meshOf(grid, 0), meshOf(grid, grid.columns / 2)};
}

}  // namespace carom
