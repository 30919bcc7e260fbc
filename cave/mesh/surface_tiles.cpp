#include "cave/mesh/surface_tiles.h"

namespace carom {
namespace {

/// Points along a line of a tile: point i is the vertex first + i·stride, at the place from + i·step along the line.
struct Row {
  std::uint32_t first;
  int stride;
  int points;
  int from;
  int step;

  std::uint32_t at(int i) const { return first + static_cast<std::uint32_t>(i * stride); }
  int place(int i) const { return from + i * step; }
};

/// Appends the triangles between two rows that run the same way, the first to the right of the second, or with
/// `mirrored` to its left.
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

}  // namespace

int tiledCells(int cells) {
  if (cells > kTileCells) return (cells + kTileCells - 1) / kTileCells * kTileCells;
  int power = 1;
  while (power < cells) power *= 2;
  return power;
}

void appendTriangles(const SurfaceTile& tile, int level, const std::array<int, 4>& edgeLevels,
                     std::vector<std::uint32_t>& indices) {
  const int width = tile.cells[0], height = tile.cells[1], row = width + 1;
  const int nu = segmentsOf(width, level), nv = segmentsOf(height, level), du = width / nu, dv = height / nv;
  const auto vertex = [&](int i, int j) {
    return tile.firstVertex + static_cast<std::uint32_t>(j * row + i);
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

}  // namespace carom
