#include "cave/mesh_files/warp_grid.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace carom {

void addGridTriangles(std::size_t columns, std::size_t rows, WarpMesh& mesh) {
  for (std::size_t row = 0; row + 1 < rows; ++row) {
    for (std::size_t column = 0; column + 1 < columns; ++column) {
      const auto upper = static_cast<std::uint32_t>(row * columns + column);
      const auto lower = static_cast<std::uint32_t>(upper + columns);
      const std::array corners{upper, lower, upper + 1, lower + 1};
      if (std::any_of(corners.begin(), corners.end(),
                      [&](std::uint32_t corner) { return mesh.points[corner].light < 0.0F; }))
        continue;
      mesh.triangles.push_back({upper, lower, upper + 1});
      mesh.triangles.push_back({upper + 1, lower, lower + 1});
    }
  }
}

}  // namespace carom
