#include "cave/bodies/tiled_surfaces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <string_view>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "cave/bodies/flat_cells.h"

namespace carom {
namespace {

const MeshVertex& vertexAt(const ChunkedMeshes& meshes, const SurfaceTile& tile, const glm::ivec2& at) {
  return meshes
      .tileVertices[tile.firstVertex + static_cast<std::uint32_t>(at.y * (tile.cells[0] + 1) + at.x)];
}

/// Returns the box of these places.
template <typename... Vertices>
Extent around(const MeshVertex& first, const Vertices&... others) {
  Extent box{first.place_m, first.place_m};
  ((box.low_m = glm::min(box.low_m, glm::dvec3(others.place_m)),
    box.high_m = glm::max(box.high_m, glm::dvec3(others.place_m))),
   ...);
  return box;
}

}  // namespace

TiledSurfaces::TiledSurfaces(const SceneChunks& scene)
    : scene_(&scene),
      longest_m_(scene.meshes.edges.size() + scene.meshes.tiles.size()),
      levels_(longest_m_.size()) {
  constexpr std::size_t kFineVertices = 1U << 17U;  // more than all but the fastest and nearest eyes need
  std::size_t most = 0;
  for (const SurfaceTile& tile : scene.meshes.tiles)
    most += 6 * static_cast<std::size_t>(tile.cells[0] * tile.cells[1]);
  tiles_.indices.reserve(most);
  cells_.indices.reserve(6 * kFineVertices);
  fineVertices_.reserve(kFineVertices);
  for (Triangles* triangles : {&tiles_, &cells_}) triangles->firstOfPart.resize(scene.parts.size() + 1);
}

void TiledSurfaces::look(const glm::dvec3& eye_m, const glm::dvec3& u) {
  eye_m_ = eye_m;
  u_ = u;
  auto longest_m = longest_m_.begin();
  for (const TileEdge& edge : scene_->meshes.edges)
    *longest_m++ = longestFlat_m(edge.detail.extent, eye_m, u);
  for (const SurfaceTile& tile : scene_->meshes.tiles)
    *longest_m++ = longestFlat_m(tile.detail.extent, eye_m, u);
}

/// Returns the coarsest level whose cells are no longer than `longest_m`, over the root of the tolerance.
int TiledSurfaces::levelWithin(const TileDetail& detail, double longest_m) const {
  const double most_m = rootTolerance_ * longest_m;
  int level = 0;
  for (double cell_m = 2.0 * detail.cell_m; level < detail.coarsest && cell_m <= most_m; cell_m *= 2.0)
    ++level;
  return level;
}

/// Returns the level of a cell as it was built, or of an edge of it, in this box.
int TiledSurfaces::levelOfCell(const Extent& extent, double cell_m) const {
  return levelWithin({extent, cell_m, kBuiltLevel}, longestFlat_m(extent, eye_m_, u_));
}

/// Sets the levels of edges and tiles. Tiles that need finer cells than they were built with end at vertices
/// of all their cells; every tile is as fine as the finest of its edges.
void TiledSurfaces::chooseLevels() {
  const ChunkedMeshes& meshes = scene_->meshes;
  const std::size_t edges = meshes.edges.size();
  std::uint8_t* const levelOfTile = levels_.data() + edges;
  for (std::size_t i = 0; i < edges; ++i)
    levels_[i] = static_cast<std::uint8_t>(levelWithin(meshes.edges[i].detail, longest_m_[i]));
  const auto finestAt = [&](const SurfaceTile& tile, std::uint8_t level) {
    for (const std::uint32_t edge : tile.edges) level = std::min(level, levels_[edge]);
    return level;
  };
  for (std::size_t i = 0; i < meshes.tiles.size(); ++i) {
    const SurfaceTile& tile = meshes.tiles[i];
    levelOfTile[i] =
        finestAt(tile, static_cast<std::uint8_t>(levelWithin(tile.detail, longest_m_[edges + i])));
    if (levelOfTile[i] >= kBuiltLevel) continue;
    for (const std::uint32_t edge : tile.edges)
      levels_[edge] = std::min(levels_[edge], static_cast<std::uint8_t>(kBuiltLevel));
  }
  for (std::size_t i = 0; i < meshes.tiles.size(); ++i)
    levelOfTile[i] = finestAt(meshes.tiles[i], levelOfTile[i]);
}

void TiledSurfaces::appendTile(const SurfaceTile& tile, int level) {
  const auto joined = [&](std::size_t i) { return levels_[tile.edges[i]] - kBuiltLevel; };
  appendTriangles({tile.firstVertex, tile.cells}, level - kBuiltLevel,
                  {joined(0), joined(1), joined(2), joined(3)}, tiles_.indices);
}

/// Returns the level of the edge of a cell of a tile that goes from a vertex one step along u or v.
int TiledSurfaces::levelOfCellsEdge(const SurfaceTile& tile, const glm::ivec2& from,
                                    const glm::ivec2& step) const {
  const ChunkedMeshes& meshes = scene_->meshes;
  const int along = step.x > 0 ? from.x : from.y, across = step.x > 0 ? from.y : from.x;
  const int cellsAlong = step.x > 0 ? tile.cells[0] : tile.cells[1],
            cellsAcross = step.x > 0 ? tile.cells[1] : tile.cells[0];
  if (across > 0 && across < cellsAcross)
    return levelOfCell(around(vertexAt(meshes, tile, from), vertexAt(meshes, tile, from + step)),
                       tile.detail.cell_m);
  const std::size_t side = (step.x > 0 ? 0 : 2) + (across > 0 ? 1 : 0);
  if (levels_[tile.edges[side]] >= kBuiltLevel) return kBuiltLevel;
  const TileEdge& edge = meshes.edges[tile.edges[side]];
  const int place = tile.turned[side] ? cellsAlong - 1 - along : along;
  return levelOfCell(edge.cells[static_cast<std::size_t>(place)], edge.detail.cell_m);
}

void TiledSurfaces::appendCells(const SurfaceTile& tile) {
  for (int j = 0; j < tile.cells[1]; ++j) {
    for (int i = 0; i < tile.cells[0]; ++i) {
      const glm::ivec2 at(i, j), u(1, 0), v(0, 1);
      const std::array<const MeshVertex*, 4> corners{
          &vertexAt(scene_->meshes, tile, at), &vertexAt(scene_->meshes, tile, at + u),
          &vertexAt(scene_->meshes, tile, at + v), &vertexAt(scene_->meshes, tile, at + u + v)};
      std::array<int, 4> edges{levelOfCellsEdge(tile, at, u), levelOfCellsEdge(tile, at + v, u),
                               levelOfCellsEdge(tile, at, v), levelOfCellsEdge(tile, at + u, v)};
      int level = levelOfCell(around(*corners[0], *corners[1], *corners[2], *corners[3]), tile.detail.cell_m);
      for (const int edge : edges) level = std::min(level, edge);
      for (int& edge : edges) edge -= level;
      const int parts = 1 << (kBuiltLevel - level);
      const auto first = static_cast<std::uint32_t>(fineVertices_.size());
      appendVertices(corners, parts, fineVertices_);
      appendTriangles({first, {parts, parts}}, 0, edges, cells_.indices);
    }
  }
}

void TiledSurfaces::choose(const VisibleChunks& visible, double tolerance_rad) {
  const ChunkedMeshes& meshes = scene_->meshes;
  rootTolerance_ = std::sqrt(tolerance_rad);
  chooseLevels();
  tiles_.indices.clear();
  cells_.indices.clear();
  fineVertices_.clear();
  for (std::size_t part = 0; part < scene_->parts.size(); ++part) {
    const PartChunks& chunks = scene_->parts[part];
    tiles_.firstOfPart[part] = tiles_.indices.size();
    cells_.firstOfPart[part] = cells_.indices.size();
    if (!chunks.tiled) continue;
    for (const std::uint32_t place : visible.chosenOf(part)) {
      const std::size_t number = meshes.chunks[chunks.first + place - chunks.firstPlace].tile;
      const int level = levels_[meshes.edges.size() + number];
      level < kBuiltLevel ? appendCells(meshes.tiles[number]) : appendTile(meshes.tiles[number], level);
    }
  }
  tiles_.firstOfPart.back() = tiles_.indices.size();
  cells_.firstOfPart.back() = cells_.indices.size();
}

std::size_t TiledSurfaces::digest() const {
  const std::string_view bytes(reinterpret_cast<const char*>(levels_.data()), levels_.size());
  return std::hash<std::string_view>()(bytes);
}

}  // namespace carom
