// The triangles and vertices of tiles.
#include "cave/mesh/surface_tiles.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "engine/random_world.h"

namespace carom {
namespace {

using test::Random;

TEST(TiledSurfaces, EveryTriangleFacesOutwardsAndTheyCoverTheirTile) {
  for (const std::array<int, 2> cells :
       {std::array{16, 16}, std::array{16, 4}, std::array{2, 16}, std::array{1, 1}}) {
    const VertexGrid tile{0, cells};
    Random random(163);
    for (int i = 0; i < 300; ++i) {
      const int level = static_cast<int>(random.in(0.0, 5.0));
      std::array<int, 4> edges{};
      for (int& edge : edges) edge = level + static_cast<int>(random.in(0.0, 5.0 - level));
      std::vector<std::uint32_t> indices;
      appendTriangles(tile, level, edges, indices);
      const auto at = [&](std::size_t k) {
        const auto number = static_cast<int>(indices[k]);
        return glm::dvec2(number % (cells[0] + 1), number / (cells[0] + 1));
      };
      double area = 0.0;
      for (std::size_t k = 0; k < indices.size(); k += 3) {
        const glm::dvec2 a = at(k + 1) - at(k), b = at(k + 2) - at(k);
        const double twice = a.x * b.y - a.y * b.x;
        ASSERT_GT(twice, 0.0) << "level " << level << ", triangle " << k / 3;
        area += 0.5 * twice;
      }
      ASSERT_EQ(area, cells[0] * cells[1]) << "level " << level;
    }
  }
}

// Neighbours that are divided differently follow the same points, to the bit, as far as both have them.
TEST(TiledSurfaces, CellsThatMeetHaveTheSamePlacesBetweenThem) {
  Random random(164);
  for (int i = 0; i < 100; ++i) {
    CASE(random, i);
    std::array<MeshVertex, 6> corners;  // two cells beside each other: 0 1 2 above 3 4 5
    for (MeshVertex& vertex : corners) {
      vertex.place_m = glm::vec3(random.inBox(1.0));
      vertex.normal = glm::vec3(random.direction());
      vertex.lit = {static_cast<std::uint8_t>(random.in(0.0, 255.0)), 7, 100, 255};
    }
    const int fine = 8, coarse = 1 << (i % 4);
    std::vector<MeshVertex> left, right;
    appendVertices({&corners[0], &corners[1], &corners[3], &corners[4]}, fine, left);
    appendVertices({&corners[1], &corners[2], &corners[4], &corners[5]}, coarse, right);
    ASSERT_EQ(left.size(), static_cast<std::size_t>((fine + 1) * (fine + 1)));
    ASSERT_EQ(right.size(), static_cast<std::size_t>((coarse + 1) * (coarse + 1)));
    EXPECT_EQ(left.front().place_m, corners[0].place_m);
    EXPECT_EQ(left.back().place_m, corners[4].place_m);
    for (int j = 0; j <= coarse; ++j) {
      const MeshVertex& one = left[static_cast<std::size_t>(j * (fine / coarse) * (fine + 1) + fine)];
      const MeshVertex& other = right[static_cast<std::size_t>(j * (coarse + 1))];
      EXPECT_EQ(one.place_m, other.place_m) << j;
      EXPECT_EQ(one.normal, other.normal) << j;
      EXPECT_EQ(one.lit, other.lit) << j;
    }
  }
}

// The least number that parts into tiles of cells that can be joined in pairs down to one.
TEST(TiledSurfaces, CellsPartIntoTiles) {
  const auto fits = [](int cells) {
    if (cells > kTileCells) return cells % kTileCells == 0;
    return cells == 1 || cells == 2 || cells == 4;
  };
  for (int cells = 1; cells <= 40; ++cells) {
    int least = cells;
    while (!fits(least)) ++least;
    EXPECT_EQ(tiledCells(cells), least) << cells;
  }
  EXPECT_EQ(segmentsOf(4, 0), 4);
  EXPECT_EQ(segmentsOf(4, 2), 1);
  EXPECT_EQ(segmentsOf(4, 9), 1);
}

}  // namespace
}  // namespace carom
