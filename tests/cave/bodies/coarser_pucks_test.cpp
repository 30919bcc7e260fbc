// The coarser meshes of pucks, chosen for random eyes, against where the light of a round puck comes from, by
// the engine's own world lines.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

#include <glm/geometric.hpp>

#include "cave/bodies/visible_chunks.h"
#include "cave/scene/scene_builder.h"
#include "engine/light/light_cone.h"
#include "engine/light_speed.h"
#include "engine/random_world.h"

namespace carom {
namespace {

using test::kC_m_s;
using test::Random;

/// Where an eye sees a place of a puck.
struct Seen {
  WorldLine line{Knot{}, kC_m_s};
  Event eye;
  Lorentz headFromBoard{kC_m_s};

  Vec3 at(const Vec3& place_m) const { return emission(line, place_m, eye, headFromBoard)->seen.dr_m; }
};

/// A puck that moves up to 0.9 c and an eye from 0.3 m to 10 m away, up to 0.95 c.
Seen seenBy(Random& random, double radius_m) {
  Seen seen;
  Knot knot;
  knot.u = random.u(0.9) * Vec3(1.0, 1.0, 0.0);
  seen.line = WorldLine(knot, kC_m_s, 2.0 * radius_m);
  const Vec3 fromPuck_m = random.direction() * std::exp(random.in(std::log(0.3), std::log(10.0)));
  const Lorentz boardFromBody = Lorentz::boost(knot.u, kC_m_s);
  seen.eye = Event{} + boardFromBody * Displacement{random.in(-1.0, 1.0), fromPuck_m};
  seen.headFromBoard = Lorentz::boost(random.u(0.95), kC_m_s);
  return seen;
}

/// Returns the point of the round puck for which a point of one of its flat cells stands: as far from the
/// axis as the corners are.
Vec3 roundOf(const std::array<Vec3, 3>& corners, const std::array<double, 3>& shares) {
  Vec3 flat(0.0);
  double radius_m = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    flat += shares[k] * corners[k];
    radius_m += shares[k] * std::hypot(corners[k].x, corners[k].y);
  }
  const double from_m = std::hypot(flat.x, flat.y);
  return from_m > 0.0 ? Vec3(flat.x * radius_m / from_m, flat.y * radius_m / from_m, flat.z) : flat;
}

double angleBetween(const Vec3& a, const Vec3& b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

/// Returns the largest angle by which points of a triangle are drawn beside the round puck's.
double worstOf(Random& random, const Seen& seen, const std::array<Vec3, 3>& corners) {
  const std::array<Vec3, 3> drawn{seen.at(corners[0]), seen.at(corners[1]), seen.at(corners[2])};
  double worst_rad = 0.0;
  std::array<double, 3> any{random.in(0.01, 1.0), random.in(0.01, 1.0), random.in(0.01, 1.0)};
  const double sum = any[0] + any[1] + any[2];
  for (double& share : any) share /= sum;
  for (const auto& shares : {std::array{1.0 / 3, 1.0 / 3, 1.0 / 3}, std::array{0.5, 0.5, 0.0},
                             std::array{0.0, 0.5, 0.5}, std::array{0.5, 0.0, 0.5}, any}) {
    const Vec3 there = shares[0] * drawn[0] + shares[1] * drawn[1] + shares[2] * drawn[2];
    worst_rad = std::max(worst_rad, angleBetween(there, seen.at(roundOf(corners, shares))));
  }
  return worst_rad;
}

TEST(CoarserPucks, NothingIsOffByMoreThanAllowedAndFarPucksTakeFewerTriangles) {
  Random random(164);
  std::array<int, PartChunks::kMostCoarser + 1> chosen{};
  std::array<std::size_t, PartChunks::kMostCoarser + 1> triangles{};
  double worst = 0.0;
  for (const double radius_m : {0.015, 0.0305, 0.15}) {
    const std::vector<BodyLooks> looks{{"white", "", radius_m, 0.6 * radius_m}};
    const Scene scene = buildScene({}, looks);
    const SceneChunks chunks(scene);
    VisibleChunks visible(chunks);
    std::size_t part = 0;
    while (scene.parts[part].paint != Paint::puck) ++part;
    std::vector<BodyView> bodies(2);
    for (int i = 0; i < 150; ++i) {
      CASE(random, i);
      const Seen seen = seenBy(random, radius_m);
      viewBody(seen.line, seen.eye, seen.headFromBoard, bodies[1]);
      visible.look(bodies, ViewFrame(seen.headFromBoard, {}));
      const double tolerance_rad = std::exp(random.in(std::log(5e-5), std::log(2e-3)));
      visible.choose(glm::dmat4(1.0), tolerance_rad, true);
      const std::size_t level = visible.levelOf(part);
      ++chosen[level];
      const ChunkRange& range = chunks.parts[part].rangeOf(level);
      ASSERT_EQ(visible.chosenOf(part).size(), range.count);
      triangles[level] = 0;
      for (std::uint32_t c = range.first; c < range.first + range.count; ++c) {
        const MeshChunk& chunk = chunks.meshes.chunks[c];
        triangles[level] += chunk.indexCount / 3;
        for (std::uint32_t k = chunk.firstIndex; level > 0 && k < chunk.firstIndex + chunk.indexCount;
             k += 3) {
          std::array<Vec3, 3> corners{};
          for (std::uint32_t j = 0; j < 3; ++j)
            corners[j] = chunks.meshes.vertices[chunks.meshes.indices[k + j]].place_m;
          const double off = worstOf(random, seen, corners) / tolerance_rad;
          ASSERT_LE(off, 1.0 + 1e-3) << "level " << level << ", radius " << radius_m;
          worst = std::max(worst, off);
        }
      }
    }
  }
  std::printf("worst: %.2f of what is allowed; eyes and triangles by level:", worst);
  for (std::size_t k = 0; k < chosen.size(); ++k) std::printf(" %d, %zu;", chosen[k], triangles[k]);
  std::printf("\n");
  EXPECT_GT(worst, 0.5) << "finer than needed";
  for (int k : {0, 1, 2, 3}) EXPECT_GT(chosen[static_cast<std::size_t>(k)], 10) << k;
  EXPECT_LT(10 * triangles[3], triangles[0]);
}

// What turns, spins or is drawn as at one moment without contraction keeps its own mesh.
TEST(CoarserPucks, ATurnOfThePuckIsDrawnWithTheFinestMesh) {
  const std::vector<BodyLooks> looks{{"white", "", 0.03, 0.02}};
  const Scene scene = buildScene({}, looks);
  const SceneChunks chunks(scene);
  VisibleChunks visible(chunks);
  std::size_t part = 0;
  while (scene.parts[part].paint != Paint::puck) ++part;
  const Lorentz rests(kC_m_s);
  const Event eye{0.0, Vec3(0.0, -5.0, 1.0)};
  Knot before;
  before.turn.t_s = -100.0;
  WorldLine line(before, kC_m_s, 0.03);
  std::vector<BodyView> bodies(2);
  const auto levelNow = [&] {
    viewBody(line, eye, rests, bodies[1]);
    visible.look(bodies, ViewFrame(rests, {}));
    visible.choose(glm::dmat4(1.0), 0.0005, true);
    return visible.levelOf(part);
  };
  EXPECT_GT(levelNow(), 0U);
  Knot turn;
  turn.turn.t_s = -glm::length(eye.r_m) / kC_m_s;  // its news are in the middle of the puck when light leaves
  turn.signal = turn.turn;
  turn.u = Vec3(0.5, 0.0, 0.0);
  line.append(turn);
  EXPECT_EQ(levelNow(), 0U);
}

}  // namespace
}  // namespace carom
