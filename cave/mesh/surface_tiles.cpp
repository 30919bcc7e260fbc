#include "cave/mesh/surface_tiles.h"

#include <cmath>

#include <glm/vec4.hpp>

namespace carom {
namespace {

/// Points along a line of a grid: point i is the vertex first + i·stride, at the place from + i·step along
/// the line.
struct Row {
  std::uint32_t first;
  int stride;
  int points;
  int from;
  int step;

  std::uint32_t at(int i) const { return first + static_cast<std::uint32_t>(i * stride); }
  int place(int i) const { return from + i * step; }
};

/// Appends the triangles between two rows that run the same way, the first to the right of the second, or
/// with `mirrored` to its left.
void zip(const Row& right, const Row& left, bool mirrored, std::vector<std::uint32_t>& indices) {
  int i = 0, j = 0;
  while (i + 1 < right.points || j + 1 < left.points) {
    const bool alongRight =
        j + 1 >= left.points || (i + 1 < right.points && right.place(i + 1) <= left.place(j + 1));
    const std::uint32_t a = right.at(i), b = left.at(j);
    const std::uint32_t next = alongRight ? right.at(++i) : left.at(++j);
    indices.push_back(a);
    indices.push_back(mirrored ? b : next);
    indices.push_back(mirrored ? next : b);
  }
}

/// A vertex between others, all in floats.
struct Mixed {
  glm::vec3 place_m, normal, surface;
  glm::vec4 lit;
};

Mixed mixedOf(const MeshVertex& vertex) {
  const auto& lit = vertex.lit;
  return {vertex.place_m, vertex.normal, vertex.surface, glm::vec4(lit[0], lit[1], lit[2], lit[3])};
}

Mixed mixed(const Mixed& a, const Mixed& b, float share) {
  const float rest = 1.0F - share;
  return {a.place_m * rest + b.place_m * share, a.normal * rest + b.normal * share,
          a.surface * rest + b.surface * share, a.lit * rest + b.lit * share};
}

MeshVertex vertexOf(const Mixed& mixed) {
  MeshVertex vertex{mixed.place_m, mixed.normal, mixed.surface, {}};
  for (int k = 0; k < 4; ++k)
    vertex.lit[static_cast<std::size_t>(k)] = static_cast<std::uint8_t>(mixed.lit[k] + 0.5F);
  return vertex;
}

}  // namespace

int tiledCells(int cells) {
  if (cells > kTileCells) return (cells + kTileCells - 1) / kTileCells * kTileCells;
  int power = 1;
  while (power < cells) power *= 2;
  return power;
}

void appendTriangles(const VertexGrid& grid, int level, const std::array<int, 4>& edgeLevels,
                     std::vector<std::uint32_t>& indices) {
  const int width = grid.cells[0], height = grid.cells[1], row = width + 1;
  const int nu = segmentsOf(width, level), nv = segmentsOf(height, level), du = width / nu, dv = height / nv;
  const auto vertex = [&](int i, int j) {
    return grid.firstVertex + static_cast<std::uint32_t>(j * row + i);
  };
  const auto alongU = [&](int j, int edge) {
    const int count = segmentsOf(width, edgeLevels[static_cast<std::size_t>(edge)]), step = width / count;
    return Row{vertex(0, j), step, count + 1, 0, step};
  };
  const auto alongV = [&](int i, int edge) {
    const int count = segmentsOf(height, edgeLevels[static_cast<std::size_t>(edge)]), step = height / count;
    return Row{vertex(i, 0), step * row, count + 1, 0, step};
  };
  const Row south = alongU(0, 0), north = alongU(height, 1), west = alongV(0, 2), east = alongV(width, 3);
  if (nv == 1) return zip(south, north, false, indices);
  if (nu == 1) return zip(west, east, true, indices);
  zip(south, {vertex(du, dv), du, nu - 1, du, du}, false, indices);
  zip(north, {vertex(du, height - dv), du, nu - 1, du, du}, true, indices);
  zip(west, {vertex(du, dv), dv * row, nv - 1, dv, dv}, true, indices);
  zip(east, {vertex(width - du, dv), dv * row, nv - 1, dv, dv}, false, indices);
  for (int j = 1; j < nv - 1; ++j) {
    const Row below{vertex(du, j * dv), du, nu - 1, du, du};
    const Row above{vertex(du, (j + 1) * dv), du, nu - 1, du, du};
    zip(below, above, false, indices);
  }
}

void appendVertices(const std::array<const MeshVertex*, 4>& corners, int parts,
                    std::vector<MeshVertex>& vertices) {
  const Mixed a = mixedOf(*corners[0]), b = mixedOf(*corners[1]), c = mixedOf(*corners[2]),
              d = mixedOf(*corners[3]);
  const float step = 1.0F / static_cast<float>(parts);  // exact: a power of two
  for (int j = 0; j <= parts; ++j) {
    const float v = step * static_cast<float>(j);
    const Mixed left = mixed(a, c, v), right = mixed(b, d, v);
    for (int i = 0; i <= parts; ++i)
      vertices.push_back(vertexOf(mixed(left, right, step * static_cast<float>(i))));
  }
}

}  // namespace carom
