#include "cave/mesh/mesh_tiles.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkPointData.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace carom {
namespace {

/// The detail that coarser levels may leave out: a bulge, and light of three steps of 255 on a bright wall.
constexpr double kBulge_m = 0.0026;
constexpr double kLightStep = 0.03;
/// The same for what the painting interpolates, where it does not go along the surface.
constexpr double kSurfaceStep = 0.025;

constexpr int kTileHalvings = 2;
static_assert(1 << kTileHalvings == kTileCells);

vtkIntArray* patchesOf(vtkPolyData& mesh) {
  return vtkIntArray::SafeDownCast(mesh.GetFieldData()->GetAbstractArray("patches"));
}

template <typename T>
T mixed(const T& a, const T& b, const T& c, const T& d, float u, float v) {
  return (a * (1.0F - u) + b * u) * (1.0F - v) + (c * (1.0F - u) + d * u) * v;
}

/// Widens the box to hold the place.
void widen(Extent& extent, const glm::dvec3& place_m) {
  extent.low_m = glm::min(extent.low_m, place_m);
  extent.high_m = glm::max(extent.high_m, place_m);
}

constexpr double kMax = std::numeric_limits<double>::max();
const Extent kNothing{glm::dvec3(kMax), glm::dvec3(-kMax)};

std::array<long long, 3> micrometres(const glm::vec3& place_m) {
  return {std::llround(1e6 * place_m.x), std::llround(1e6 * place_m.y), std::llround(1e6 * place_m.z)};
}

int tilesAlong(int cells) { return std::max(1, cells / kTileCells); }

}  // namespace

bool hasPatches(vtkPolyData& mesh) { return patchesOf(mesh) != nullptr; }

/// A patch's points as vertices, row by row, and the light on them.
struct MeshTiles::Patch {
  glm::ivec2 cells{0};
  std::vector<MeshVertex> vertices;
  std::vector<double> light;

  std::size_t number(const glm::ivec2& at) const {
    return static_cast<std::size_t>(at.y * (cells.x + 1) + at.x);
  }
  const MeshVertex& at(const glm::ivec2& place) const { return vertices[number(place)]; }
};

/// The number of an edge, and whether its ends are in the other order than the tile has them.
struct MeshTiles::EdgeOfTile {
  std::uint32_t number;
  bool turned;
};

MeshTiles::MeshTiles(ChunkedMeshes& to, Light light) : to_(to), light_(std::move(light)) {}

/// Returns the level beyond which this part of a patch would be drawn with other light or another shape: on
/// each coarser one, points that it leaves out are held against the straight lines that it draws instead.
int MeshTiles::coarsestOf(const Patch& patch, const glm::ivec2& corner, const glm::ivec2& cells) const {
  const auto agrees = [&](const glm::ivec2& cell, const glm::ivec2& at) {
    const glm::ivec2 low = at / cell * cell;
    const glm::ivec2 high = glm::min(low + cell, cells);
    const glm::vec2 share = glm::vec2(at - low) / glm::vec2(glm::max(high - low, glm::ivec2(1)));
    const std::array<glm::ivec2, 4> corners{corner + low, corner + glm::ivec2(high.x, low.y),
                                            corner + glm::ivec2(low.x, high.y), corner + high};
    const MeshVertex& left = patch.at(corner + at);
    const auto mixedOf = [&](const auto& value) {
      return mixed(value(corners[0]), value(corners[1]), value(corners[2]), value(corners[3]), share.x,
                   share.y);
    };
    const glm::vec3 drawn_m = mixedOf([&](const glm::ivec2& i) { return patch.at(i).place_m; });
    const float light =
        mixedOf([&](const glm::ivec2& i) { return static_cast<float>(patch.light[patch.number(i)]); });
    const float surface = mixedOf([&](const glm::ivec2& i) { return patch.at(i).surface.z; });
    return std::abs(glm::dot(drawn_m - left.place_m, left.normal)) <= kBulge_m &&
           std::abs(light - static_cast<float>(patch.light[patch.number(corner + at)])) <= kLightStep &&
           std::abs(surface - left.surface.z) <= kSurfaceStep;
  };
  for (int coarser = 1; coarser <= kTileHalvings; ++coarser) {
    const glm::ivec2 cell = glm::max(glm::min(glm::ivec2(1 << coarser), cells), glm::ivec2(1));
    for (int j = 0; j <= cells.y; ++j) {
      for (int i = 0; i <= cells.x; ++i) {
        if (!agrees(cell, {i, j})) return kBuiltLevel + coarser - 1;
      }
    }
  }
  return kBuiltLevel + kTileHalvings;
}

MeshTiles::EdgeOfTile MeshTiles::edgeOf(const Patch& patch, const glm::ivec2& from, const glm::ivec2& step,
                                        int cells) {
  const glm::ivec2 to = from + cells * step;
  auto a = micrometres(patch.at(from).place_m), b = micrometres(patch.at(to).place_m);
  const bool turned = b < a;
  if (turned) std::swap(a, b);
  const auto middle = micrometres(patch.at(from + cells / 2 * step).place_m);
  const auto [found, isNew] =
      edges_.try_emplace(Key{a[0], a[1], a[2], b[0], b[1], b[2], middle[0], middle[1], middle[2]},
                         static_cast<std::uint32_t>(to_.edges.size()));
  if (isNew) {
    to_.edges.push_back({{kNothing, 0.0, kBuiltLevel + kTileHalvings}, {}});
    to_.edges.back().cells.fill(kNothing);
  }
  TileEdge& edge = to_.edges[found->second];
  edge.detail.coarsest = std::min(edge.detail.coarsest, coarsestOf(patch, from, cells * step));
  for (int i = 0; i <= cells; ++i) widen(edge.detail.extent, patch.at(from + i * step).place_m);
  for (int i = 0; i < cells; ++i) {
    Extent& cell = edge.cells[static_cast<std::size_t>(turned ? cells - 1 - i : i)];
    widen(cell, patch.at(from + i * step).place_m);
    widen(cell, patch.at(from + (i + 1) * step).place_m);
  }
  return {found->second, turned};
}

void MeshTiles::appendTile(const Patch& patch, const glm::ivec2& corner, const glm::ivec2& cells,
                           double largestCell_m) {
  SurfaceTile tile;
  tile.firstVertex = static_cast<std::uint32_t>(to_.tileVertices.size());
  tile.cells = {cells.x, cells.y};
  const glm::ivec2 u(1, 0), v(0, 1);
  const std::array<EdgeOfTile, 4> edges{
      edgeOf(patch, corner, u, cells.x), edgeOf(patch, corner + cells * v, u, cells.x),
      edgeOf(patch, corner, v, cells.y), edgeOf(patch, corner + cells * u, v, cells.y)};
  for (std::size_t i = 0; i < edges.size(); ++i) {
    tile.edges[i] = edges[i].number;
    tile.turned[i] = edges[i].turned;
  }
  tile.detail = {kNothing, 0.0, coarsestOf(patch, corner, cells)};
  for (int j = 0; j <= cells.y; ++j) {
    for (int i = 0; i <= cells.x; ++i) {
      const glm::ivec2 at = corner + glm::ivec2(i, j);
      to_.tileVertices.push_back(patch.at(at));
      widen(tile.detail.extent, patch.at(at).place_m);
      if (i == 0 || j == 0) continue;
      const auto across_m = [&](const glm::ivec2& p, const glm::ivec2& q) {
        return static_cast<double>(glm::distance(patch.at(p).place_m, patch.at(q).place_m)) / kMostParts;
      };
      tile.detail.cell_m = std::max({tile.detail.cell_m, across_m(at, at - 1), across_m(at - u, at - v)});
    }
  }
  while (tile.detail.coarsest > 0 && tile.detail.cell_m * (1 << tile.detail.coarsest) > largestCell_m)
    --tile.detail.coarsest;
  for (const std::uint32_t edge : tile.edges)
    to_.edges[edge].detail.cell_m = std::max(to_.edges[edge].detail.cell_m, tile.detail.cell_m);
  const Extent& box = tile.detail.extent;
  to_.chunks.push_back({0, 0, static_cast<std::uint32_t>(to_.tiles.size()), 0.5 * (box.low_m + box.high_m),
                        0.5 * glm::distance(box.low_m, box.high_m)});
  to_.tiles.push_back(tile);
}

void MeshTiles::append(vtkPolyData& mesh, double largestCell_m) {
  vtkIntArray* const patches = patchesOf(mesh);
  for (vtkIdType i = 0; i < patches->GetNumberOfTuples(); ++i) {
    std::array<int, 3> numbers{};
    patches->GetTypedTuple(i, numbers.data());
    Patch patch;
    patch.cells = {numbers[1], numbers[2]};
    const vtkIdType points = static_cast<vtkIdType>(patch.cells.x + 1) * (patch.cells.y + 1);
    for (vtkIdType k = 0; k < points; ++k) {
      patch.vertices.push_back(vertexOf(mesh, numbers[0] + k));
      patch.light.push_back(light_(patch.vertices.back()));
    }
    const glm::ivec2 tiles(tilesAlong(patch.cells.x), tilesAlong(patch.cells.y));
    const glm::ivec2 size = patch.cells / tiles;
    for (int y = 0; y < tiles.y; ++y) {
      for (int x = 0; x < tiles.x; ++x) appendTile(patch, glm::ivec2(x, y) * size, size, largestCell_m);
    }
  }
}

}  // namespace carom
