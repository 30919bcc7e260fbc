// Tiles at the levels that a head chooses, against where light shows each point, by the engine's own boosts:
// nothing is off by more than half a pixel, and nothing gapes.

#include "cave/bodies/tiled_surfaces.h"

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
#include "engine/light_speed.h"
#include "engine/random_world.h"

namespace carom {
namespace {

using test::kC_m_s;
using test::Random;

constexpr double kHalfPixel_rad = 0.0005;

/// A table in its hall, of which everything is chosen.
struct Room {
  Scene scene;
  SceneChunks chunks;
  TiledSurfaces surfaces;
  VisibleChunks visible;

  Room()
      : scene(buildScene(withTable(), {}, {}, {}, {.pixel_rad = 2.0 * kHalfPixel_rad})),
        chunks(scene),
        surfaces(chunks),
        visible(chunks) {
    std::vector<BodyView> bodies(1);
    const Lorentz rests(kC_m_s);
    viewBody(WorldLine(Knot{}, kC_m_s, 20.0), Event{}, rests, bodies[0]);
    visible.look(bodies, ViewFrame(rests, {}));
    visible.choose(glm::dmat4(1.0), 0.0, true);
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

  /// A drawn triangle, with the part that it belongs to.
  struct Triangle {
    std::array<Vec3, 3> corners_m;
    std::size_t part;
  };
  std::vector<Triangle> triangles() const {
    std::vector<Triangle> all;
    const auto append = [&](std::size_t part, const TiledSurfaces::Range& range, const auto& indices,
                            const auto& vertices) {
      for (std::size_t k = range.first; k < range.end; k += 3)
        all.push_back({{Vec3(vertices[indices[k]].place_m), Vec3(vertices[indices[k + 1]].place_m),
                        Vec3(vertices[indices[k + 2]].place_m)},
                       part});
    };
    for (std::size_t part = 0; part < scene.parts.size(); ++part) {
      append(part, surfaces.rangeOf(part), surfaces.indices(), chunks.meshes.tileVertices);
      append(part, surfaces.fineRangeOf(part), surfaces.fineIndices(), surfaces.fineVertices());
    }
    return all;
  }
  std::size_t triangleCount() const {
    return (surfaces.indices().size() + surfaces.fineIndices().size()) / 3;
  }
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

/// An eye somewhere in the hall, every other one near a surface of table or hall, and how its head moves.
struct Head {
  Vec3 eye_m, u;
  Head(Random& random, const Room& room)
      : eye_m{random.in(-3.0, 3.0), random.in(-3.0, 3.0), random.in(0.5, 1.5)},
        u(random.direction() * [](double beta) {
          return beta / std::sqrt(1.0 - beta * beta);
        }(random.in(0.0, 1.0) < 0.5 ? 0.95 : random.in(0.0, 0.95))) {
    if (random.in(0.0, 1.0) < 0.5) return;
    const auto& vertices = room.chunks.meshes.tileVertices;
    const MeshVertex& vertex =
        vertices[static_cast<std::size_t>(random.in(0.0, static_cast<double>(vertices.size())))];
    eye_m = Vec3(vertex.place_m) + random.in(kNearestToSurface_m, 0.6) * Vec3(vertex.normal);
  }
};

TEST(TiledSurfaces, NothingIsOffByMoreThanHalfAPixel) {
  Room room;
  Random random(161);
  // What the start of a session promises.
  const double from_m = std::max(
      kNearestToSurface_m, kNearestEye_m * room.scene.notes[1].longestEdge_m / longestEdge_m(kHalfPixel_rad));
  EXPECT_LT(from_m, 0.15);
  double worst_rad = 0.0;
  std::size_t compared = 0, most = 0;
  for (int i = 0; i < 60; ++i) {
    const Head head(random, room);
    CASE(random, i);
    room.look(head.eye_m, head.u);
    const Lorentz headFromBoard = Lorentz::boost(head.u, kC_m_s).inverse();
    const std::vector<Room::Triangle> triangles = room.triangles();
    most = std::max(most, triangles.size());
    for (std::size_t t = static_cast<std::size_t>(i % 17); t < triangles.size(); t += 17) {
      std::array<Vec3, 3> corners = triangles[t].corners_m;
      for (Vec3& corner : corners) corner -= head.eye_m;
      const double nearest_m =
          std::min({glm::length(corners[0]), glm::length(corners[1]), glm::length(corners[2])});
      if (nearest_m < from_m) continue;
      const double off_rad = worstOf(random, headFromBoard, corners);
      ++compared;
      ASSERT_LE(off_rad, kHalfPixel_rad * (1.0 + 1e-3))
          << "triangle " << t << ", head " << glm::length(head.u) << ", nearest " << nearest_m;
      worst_rad = std::max(worst_rad, off_rad);
    }
  }
  std::printf("%zu triangles, at most %zu for a head; worst: %.2f of half a pixel\n", compared, most,
              worst_rad / kHalfPixel_rad);
  EXPECT_GT(worst_rad, 0.3 * kHalfPixel_rad) << "finer than needed";
}

// Floor, walls and ceiling close the hall: each edge of a triangle is that of another one.
TEST(TiledSurfaces, BetweenLevelsNothingGapes) {
  Room room;
  Random random(162);
  for (int i = 0; i < 12; ++i) {
    const Head head(random, room);
    CASE(random, i);
    room.look(head.eye_m, head.u);
    std::map<std::array<long long, 6>, int> edges;
    for (const Room::Triangle& triangle : room.triangles()) {
      const Paint paint = room.scene.parts[triangle.part].paint;
      if (paint != Paint::floor && paint != Paint::panels) continue;
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec3 ends[2] = {triangle.corners_m[k], triangle.corners_m[(k + 1) % 3]};
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

// A head at rest needs no more than shape and light do; a fast one needs more.
TEST(TiledSurfaces, AHeadAtRestNeedsTheCoarsestLevels) {
  Room room;
  room.look({1.0, -2.0, 0.9}, Vec3(0.0));
  const std::size_t atRest = room.triangleCount(), digest = room.surfaces.digest();
  room.look({1.0, -2.0, 0.9}, Vec3(0.0, 0.6, 0.0));
  EXPECT_GT(room.triangleCount(), atRest);
  EXPECT_NE(room.surfaces.digest(), digest);
  room.look({1.0, -2.0, 0.9}, Vec3(0.0));
  EXPECT_EQ(room.surfaces.digest(), digest);
  std::size_t built = 0;
  for (const SurfaceTile& tile : room.chunks.meshes.tiles)
    built += static_cast<std::size_t>(2 * tile.cells[0] * tile.cells[1]);
  EXPECT_LT(atRest, built / 2);
}

}  // namespace
}  // namespace carom
