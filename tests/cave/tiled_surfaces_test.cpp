// Tiles at the levels that a head chooses, against where light shows each point, by the engine's own boosts: nothing
// is off by more than half a pixel, and nothing gapes.

#include "cave/render/tiled_surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

#include <glm/geometric.hpp>

#include "cave/mesh/tessellation.h"
#include "cave/scene/scene_builder.h"
#include "engine/light/light_cone.h"
#include "engine/random_world.h"

namespace carom {
namespace {

using test::Random;

constexpr double kC_m_s = 1.42;
constexpr double kHalfPixel_rad = 0.0005;

/// A table in its hall, of which everything is chosen.
struct Room {
  Scene scene;
  SceneChunks chunks;
  TiledSurfaces surfaces;
  VisibleChunks visible;

  explicit Room(std::size_t mostVertices = 50000)
      : scene(buildScene(withTable(), {}, {}, {}, {2.0 * kHalfPixel_rad, mostVertices})),
        chunks(scene),
        surfaces(chunks),
        visible(chunks) {
    std::vector<BodyView> bodies(1);
    const Lorentz rests(kC_m_s);
    viewBody(WorldLine(Knot{}, kC_m_s, 20.0), Event{}, rests, bodies[0]);
    visible.look(bodies, ViewFrame(rests, {}));
    visible.choose(glm::dmat4(1.0), true);
  }

  static BilliardSetup withTable() {
    BilliardSetup setup;
    setup.board = Board{2.84, 1.42};
    return setup;
  }

  void look(const Vec3& eye_m, const Vec3& u) {
    surfaces.look(eye_m, u);
    surfaces.choose(visible, kHalfPixel_rad);
  }
  Vec3 placeOf(std::size_t index) const { return chunks.meshes.vertices[surfaces.indices()[index]].place_m; }
};

/// Where a head sees a point at rest on the board, from its eye.
Vec3 seenFrom(const Lorentz& headFromBoard, const Vec3& fromEye_m) {
  return (headFromBoard * Displacement{-glm::length(fromEye_m) / kC_m_s, fromEye_m}).dr_m;
}

/// How far a drawn triangle is off at one of its points, as an angle at the eye.
double offAt(const Lorentz& headFromBoard, const std::array<Vec3, 3>& corners,
             const std::array<double, 3>& shares) {
  Vec3 there(0.0), drawn(0.0);
  for (std::size_t k = 0; k < 3; ++k) {
    there += shares[k] * corners[k];
    drawn += shares[k] * seenFrom(headFromBoard, corners[k]);
  }
  const Vec3 exact = seenFrom(headFromBoard, there);
  return std::atan2(glm::length(glm::cross(drawn, exact)), glm::dot(drawn, exact));
}

/// Returns the worst of a few points of the triangle: its middle, its edges' middles and a random one.
double worstOf(Random& random, const Lorentz& headFromBoard, const std::array<Vec3, 3>& corners) {
  double worst = 0.0;
  std::array<double, 3> any{random.in(0.01, 1.0), random.in(0.01, 1.0), random.in(0.01, 1.0)};
  const double sum = any[0] + any[1] + any[2];
  for (double& share : any) share /= sum;
  for (const auto& shares : {std::array{1.0 / 3, 1.0 / 3, 1.0 / 3}, std::array{0.5, 0.5, 0.0},
                             std::array{0.0, 0.5, 0.5}, std::array{0.5, 0.0, 0.5}, any})
    worst = std::max(worst, offAt(headFromBoard, corners, shares));
  return worst;
}

/// An eye somewhere in the hall and how its head moves.
struct Head {
  Vec3 eye_m, u;
  explicit Head(Random& random)
      : eye_m{random.in(-3.0, 3.0), random.in(-3.0, 3.0), random.in(0.5, 1.5)},
        u(random.direction() *
          [](double beta) { return beta / std::sqrt(1.0 - beta * beta); }(random.in(0.0, 0.95))) {}
};

TEST(TiledSurfaces, NothingIsOffByMoreThanHalfAPixel) {
  Room room;
  ASSERT_EQ(room.scene.finer, 4);
  Random random(161);
  double worst_rad = 0.0;
  std::size_t compared = 0, finest = 0;
  for (int i = 0; i < 60; ++i) {
    const Head head(random);
    CASE(random, i);
    room.look(head.eye_m, head.u);
    const Lorentz headFromBoard = Lorentz::boost(head.u, kC_m_s).inverse();
    const std::size_t triangles = room.surfaces.indices().size() / 3;
    for (std::size_t t = static_cast<std::size_t>(i % 7); t < triangles; t += 7) {
      std::array<Vec3, 3> corners{};
      for (std::size_t k = 0; k < 3; ++k) corners[k] = room.placeOf(3 * t + k) - head.eye_m;
      const double nearest_m =
          std::min({glm::length(corners[0]), glm::length(corners[1]), glm::length(corners[2])});
      if (nearest_m < kNearestEye_m + 0.3) continue;
      const double off_rad = worstOf(random, headFromBoard, corners);
      // What is divided as finely as it can be may be off by more; the message at the start says up to which speed not.
      const double edge_m =
          std::max({glm::distance(corners[0], corners[1]), glm::distance(corners[1], corners[2]),
                    glm::distance(corners[2], corners[0])});
      ++compared;
      if (off_rad > kHalfPixel_rad && edge_m < 0.07) {
        ++finest;
        continue;
      }
      ASSERT_LE(off_rad, kHalfPixel_rad * (1.0 + 1e-3))
          << "triangle " << t << ", head " << glm::length(head.u);
      worst_rad = std::max(worst_rad, off_rad);
    }
  }
  std::printf(
      "%zu triangles, %zu of them too large though finest; worst of the others: %.2f of half a pixel\n",
      compared, finest, worst_rad / kHalfPixel_rad);
  EXPECT_GT(worst_rad, 0.3 * kHalfPixel_rad) << "finer than needed";
  EXPECT_LT(finest, compared / 50);
}

// Floor, walls and ceiling close the hall: each edge of a triangle is that of another one.
TEST(TiledSurfaces, BetweenLevelsNothingGapes) {
  Room room(1000);
  Random random(162);
  for (int i = 0; i < 30; ++i) {
    const Head head(random);
    CASE(random, i);
    room.look(head.eye_m, head.u);
    std::map<std::array<long long, 6>, int> edges;
    for (std::size_t part = 0; part < room.scene.parts.size(); ++part) {
      const Paint paint = room.scene.parts[part].paint;
      if (paint != Paint::floor && paint != Paint::panels) continue;
      for (std::size_t k = room.surfaces.firstIndexOf(part); k < room.surfaces.endIndexOf(part); ++k) {
        const Vec3 ends[2] = {room.placeOf(k), room.placeOf(k % 3 == 2 ? k - 2 : k + 1)};
        std::array<std::array<long long, 3>, 2> keys{};
        for (int e = 0; e < 2; ++e)
          for (int axis = 0; axis < 3; ++axis) keys[e][axis] = std::llround(1e5 * ends[e][axis]);
        std::sort(keys.begin(), keys.end());
        ++edges[{keys[0][0], keys[0][1], keys[0][2], keys[1][0], keys[1][1], keys[1][2]}];
      }
    }
    ASSERT_GT(edges.size(), 100U);
    for (const auto& [ends, count] : edges)
      ASSERT_EQ(count, 2) << ends[0] << ", " << ends[1] << ", " << ends[2];
  }
}

TEST(TiledSurfaces, EveryTriangleFacesOutwardsAndTheyCoverTheirTile) {
  for (const std::array<int, 2> cells :
       {std::array{16, 16}, std::array{16, 4}, std::array{2, 16}, std::array{1, 1}}) {
    SurfaceTile tile;
    tile.cells = cells;
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

// A head at rest needs no more than shape and light do; a fast one needs more.
TEST(TiledSurfaces, AHeadAtRestNeedsTheCoarsestLevels) {
  Room room;
  room.look({1.0, -2.0, 0.9}, Vec3(0.0));
  const std::size_t atRest = room.surfaces.indices().size(), digest = room.surfaces.digest();
  room.look({1.0, -2.0, 0.9}, Vec3(0.0, 0.6, 0.0));
  EXPECT_GT(room.surfaces.indices().size(), atRest);
  EXPECT_NE(room.surfaces.digest(), digest);
  room.look({1.0, -2.0, 0.9}, Vec3(0.0));
  EXPECT_EQ(room.surfaces.digest(), digest);
  std::size_t finest = 0;
  for (const SurfaceTile& tile : room.chunks.meshes.tiles)
    finest += static_cast<std::size_t>(6 * tile.cells[0] * tile.cells[1]);
  EXPECT_LT(atRest, finest / 16);
}

}  // namespace
}  // namespace carom
