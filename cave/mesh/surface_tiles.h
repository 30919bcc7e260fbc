#pragma once
// Surfaces in tiles that are drawn as finely as an eye needs. Levels are counted from the finest: a level k
// divides each side of a tile's cells, as they were built, into 2^(kBuiltLevel − k) parts; beyond kBuiltLevel
// it joins cells.
//
// A level is chosen for each tile and for each edge. Tiles that meet at an edge know it by its number, so
// that both follow the same points of it: between tiles of different levels there is no crack. From the built
// level on, a tile's own vertices do. A tile that needs finer ones is drawn cell by cell, each at a level of
// its own and with edges of its own, from vertices that are made for the eye.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "cave/mesh/mesh_vertex.h"

namespace carom {

/// The cells along the side of a tile of a mesh as it was built, at most; finer cells divide these.
inline constexpr int kTileCells = 4;
/// The level of the cells as they were built.
inline constexpr int kBuiltLevel = 7;
/// Into how many parts the finest level divides the side of a cell as it was built.
inline constexpr int kMostParts = 1 << kBuiltLevel;

/// Returns the least number of cells, at least `cells`, that parts into tiles which can be halved down to one
/// cell: a power of two up to kTileCells, else a multiple of that.
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

/// Where two tiles meet.
struct TileEdge {
  TileDetail detail;
  std::array<Extent, kTileCells> cells;  ///< the edges of its tiles' cells, from one of its ends on
};

struct SurfaceTile {
  std::uint32_t firstVertex = 0;       ///< (cells[0] + 1) × (cells[1] + 1) of them, row by row
  std::array<int, 2> cells{1, 1};      ///< as it was built, along u and v
  std::array<std::uint32_t, 4> edges;  ///< at v = 0 and 1, at u = 0 and 1
  std::array<bool, 4> turned{};        ///< whether the edge's cells run against u or v
  TileDetail detail;
};

/// Returns into how many straight lines a level joins a side of this number of cells, each built as on level
/// 0.
constexpr int segmentsOf(int cells, int level) { return cells >> level > 0 ? cells >> level : 1; }

/// A grid of vertices, row by row: (cells[0] + 1) × (cells[1] + 1) of them.
struct VertexGrid {
  std::uint32_t firstVertex = 0;
  std::array<int, 2> cells{1, 1};
};

/// Appends the triangles of a grid, as indices, its cells joined 2^level by 2^level, with its four edges
/// joined at levels of their own, none finer.
void appendTriangles(const VertexGrid& grid, int level, const std::array<int, 4>& edgeLevels,
                     std::vector<std::uint32_t>& indices);

/// Appends the vertices that divide the cell with the corners a, b and, above them, c, d into parts × parts.
/// Cells that have two corners in common get the same places between them, as far as both have them.
void appendVertices(const std::array<const MeshVertex*, 4>& corners, int parts,
                    std::vector<MeshVertex>& vertices);

}  // namespace carom
