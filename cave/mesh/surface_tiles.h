#pragma once
// Surfaces in tiles that are drawn as finely as an eye needs: each tile has the vertices of its finest level, and of a
// level k every 2^k-th of them in each direction.
//
// A level is chosen for each tile and for each edge. Tiles that meet at an edge know it by its number, so that both
// follow the same points of it: between tiles of different levels there is no crack.

#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

namespace carom {

/// The cells along the side of a tile of a mesh as it was built, at most; finer cells divide these.
inline constexpr int kTileCells = 4;

/// Returns the least number of cells, at least `cells`, that parts into tiles which can be halved down to one cell:
/// a power of two up to kTileCells, else a multiple of that.
int tiledCells(int cells);

/// A box in the body's rest frame.
struct Extent {
  glm::dvec3 low_m{0.0}, high_m{0.0};
};

/// What decides how coarsely something may be drawn.
struct TileDetail {
  Extent extent;
  double cell_m =
      0.0;  ///< the longest diagonal of the cells of its finest level; of an edge, of its tiles' cells
  int coarsest = 0;  ///< the level beyond which its shape or its light would differ
};

struct SurfaceTile {
  std::uint32_t firstVertex = 0;       ///< (cells[0] + 1) × (cells[1] + 1) of them, row by row
  std::array<int, 2> cells{1, 1};      ///< of the finest level, along u and v
  std::array<std::uint32_t, 4> edges;  ///< at v = 0 and 1, at u = 0 and 1
  TileDetail detail;
};

/// Returns into how many straight lines a level divides a side.
constexpr int segmentsOf(int cells, int level) { return cells >> level > 0 ? cells >> level : 1; }

/// Appends the triangles of a tile, as indices, at a level with its four edges at levels of their own, none finer.
void appendTriangles(const SurfaceTile& tile, int level, const std::array<int, 4>& edgeLevels,
                     std::vector<std::uint32_t>& indices);

}  // namespace carom
