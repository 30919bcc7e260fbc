// The bound on edges against dense sampling: seen places by the engine's world lines, not by circles on the
// sky.

#include "cave/mesh/tessellation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "cave/room/off_axis.h"
#include "engine/light/light_cone.h"
#include "engine/random_world.h"

namespace carom {
namespace {

using test::Random;

constexpr double kC_m_s = 1.42;
constexpr int kSamples = 16;

/// An edge of a body that moves, and a head that sees it.
struct Case {
  Vec3 from_m{0.0}, to_m{0.0};  // on the body, from its centre
  WorldLine body{Knot{}, kC_m_s};
  Event eye;
  Lorentz headFromBoard{kC_m_s};
};

/// The head's place and motion are chosen in the body's rest frame, where the bound is stated. `edge_m` long;
/// the nearest point of the edge 0.5 m from the eye or a little more.
Case makeCase(Random& random, double edge_m, double beta, bool behind) {
  Case made;
  const Vec3 along = random.direction();
  made.from_m = random.inBox(0.5);
  made.to_m = made.from_m + edge_m * along;
  Vec3 across = glm::normalize(glm::cross(along, random.direction()));
  const double share = behind ? 0.5 : random.in(0.0, 1.0);
  const double distance_m = kNearestEye_m * (behind ? 1.0 : random.in(1.0, 3.0));
  const Vec3 eyeInBody = glm::mix(made.from_m, made.to_m, share) + distance_m * across;
  Vec3 motion = random.direction();
  if (behind) {  // near the worst: the edge's middle almost straight behind, the edge across
    const double chi = random.in(0.02, 0.5);
    motion = across * std::cos(chi) + glm::cross(along, across) * std::sin(chi);
  }
  const Lorentz boardFromBody = Lorentz::boost(random.u(0.9), kC_m_s);
  Knot knot;
  knot.u = boardFromBody.u();
  made.body = WorldLine(knot, kC_m_s, 2.0);
  made.eye = Event{} + boardFromBody * Displacement{random.in(-1.0, 1.0), eyeInBody};
  made.headFromBoard =
      (boardFromBody * Lorentz::boost(motion * (beta / std::sqrt(1.0 - beta * beta)), kC_m_s)).inverse();
  return made;
}

Vec3 seenAt(const Case& edge, double share) {
  const Vec3 d = glm::mix(edge.from_m, edge.to_m, share);
  return emission(edge.body, d, edge.eye, edge.headFromBoard)->seen.dr_m;
}

/// How far the seen edge strays from the plane through the eye and the drawn one.
double bendOf(const Case& edge) {
  const Vec3 plane = glm::normalize(glm::cross(seenAt(edge, 0.0), seenAt(edge, 1.0)));
  double bend = 0.0;
  for (int i = 1; i < kSamples; ++i) {
    const Vec3 ray = glm::normalize(seenAt(edge, static_cast<double>(i) / kSamples));
    bend = std::max(bend, std::abs(std::asin(glm::dot(ray, plane))));
  }
  return bend;
}

TEST(Tessellation, NoEdgeBendsMoreThanTheBoundAndSomeAlmostThatMuch) {
  for (const double tolerance_rad : {3e-4, 2e-3, 2e-2}) {
    for (const double beta : {0.3, 0.95}) {
      const double edge_m = longestEdge_m(tolerance_rad, beta);
      Random random(7);
      double worst = 0.0;
      for (int i = 0; i < 4000; ++i) {
        const Case edge = makeCase(random, edge_m, i % 3 == 0 ? beta : random.in(0.0, beta), i % 2 == 0);
        const double bend = bendOf(edge);
        // Rounding of directions by two boosts: 1e-12 rad, far below any pixel.
        ASSERT_LE(bend, tolerance_rad + 1e-10)
            << "case " << i << ", edge " << edge_m << " m, to " << beta << " c";
        worst = std::max(worst, bend);
      }
      // The random cases come near the worst one, or the bound would divide too finely.
      if (beta > 0.9) {
        EXPECT_GT(worst, 0.95 * tolerance_rad);
      }
    }
  }
}

TEST(Tessellation, TheBoundGrowsWithLengthAndSpeedAndFallsWithDistance) {
  EXPECT_NEAR(worstBend_rad(0.01, 0.0), 0.0, 1e-14);  // rounding of angles
  EXPECT_LT(worstBend_rad(0.01), worstBend_rad(0.02));
  EXPECT_LT(worstBend_rad(0.01, 0.5), worstBend_rad(0.01, 0.6));
  EXPECT_NEAR(worstBend_rad(0.01, 0.95, 0.5), worstBend_rad(0.02, 0.95, 1.0), 1e-12)
      << "only their ratio counts";
  const double edge_m = longestEdge_m(1e-3);
  EXPECT_NEAR(worstBend_rad(edge_m), 1e-3, 1e-9);
  EXPECT_NEAR(fastestHead_beta(edge_m, 1e-3), kFastestHead_beta, 1e-6);
  EXPECT_LT(fastestHead_beta(5.0 * edge_m, 1e-3), 0.9);
}

/// The four walls of config/rigs/desk.toml.
std::vector<Wall> deskWalls() {
  const auto wall = [](const glm::dvec3& ll, const glm::dvec3& lr, const glm::dvec3& ul) {
    Wall made;
    made.lowerLeft_m = ll;
    made.lowerRight_m = lr;
    made.upperLeft_m = ul;
    made.pixels = {600, 600};
    return made;
  };
  return {wall({-1.5, 0, -1.5}, {1.5, 0, -1.5}, {-1.5, 3, -1.5}),
          wall({-1.5, 0, 1.5}, {-1.5, 0, -1.5}, {-1.5, 3, 1.5}),
          wall({1.5, 0, -1.5}, {1.5, 0, 1.5}, {1.5, 3, -1.5}),
          wall({-1.5, 0, 1.5}, {1.5, 0, 1.5}, {-1.5, 0, -1.5})};
}

/// Where the wall shows a place given from the eye, in pixels; none outside it.
std::optional<glm::dvec2> pixelOn(const Wall& wall, const glm::dmat4& clipFromEye, const Vec3& seen_m) {
  const glm::dvec4 clip = clipFromEye * glm::dvec4(seen_m, 1.0);
  if (!(clip.w > 0.0)) return std::nullopt;
  const glm::dvec2 at = glm::dvec2(clip) / clip.w;
  if (!(std::abs(at.x) <= 1.0 && std::abs(at.y) <= 1.0)) return std::nullopt;
  return 0.5 * (at + 1.0) * glm::dvec2(wall.pixels);
}

TEST(Tessellation, OnTheWallsNoEdgeIsOffByOverHalfAPixel) {
  const std::vector<Wall> walls = deskWalls();
  const glm::dvec3 eye(0.0, 1.7, 0.0);
  const double edge_m = longestEdge_m(0.5 * finestPixel_rad(walls, eye));
  Random random(11);
  int shown = 0;
  double worst_px = 0.0;
  for (int i = 0; i < 12000; ++i) {
    const Case edge = makeCase(random, edge_m, kFastestHead_beta, i % 2 == 0);
    for (const Wall& wall : walls) {
      const glm::dmat4 clip = *clipFromEye(wall, eye);
      const auto from = pixelOn(wall, clip, seenAt(edge, 0.0)), to = pixelOn(wall, clip, seenAt(edge, 1.0));
      if (!from || !to || glm::distance(*from, *to) < 1e-6) continue;
      const glm::dvec2 along = glm::normalize(*to - *from);
      for (int k = 1; k < kSamples; ++k) {
        const auto at = pixelOn(wall, clip, seenAt(edge, static_cast<double>(k) / kSamples));
        if (!at) continue;
        const glm::dvec2 way = *at - *from;
        const double off_px = std::abs(way.x * along.y - way.y * along.x);
        ++shown;
        worst_px = std::max(worst_px, off_px);
        // Angles become pixels through a tangent that is straight to 1e-3 over half a pixel.
        ASSERT_LE(off_px, 0.5 * 1.001) << "case " << i;
      }
    }
  }
  EXPECT_GT(shown, 50000);
  EXPECT_GT(worst_px, 0.2) << "the cases are far from the worst";
}

TEST(Tessellation, TheFinestPixelIsInTheFarthestCorner) {
  const std::vector<Wall> walls = deskWalls();
  const glm::dvec3 eye(0.0, 1.7, 0.0);
  // By differences instead: the angle between neighbouring pixels in the corners, along both diagonals.
  double finest = 1.0;
  for (const Wall& wall : walls) {
    const glm::dvec3 along = (wall.lowerRight_m - wall.lowerLeft_m) / 600.0,
                     up = (wall.upperLeft_m - wall.lowerLeft_m) / 600.0;
    for (const glm::dvec2 corner : {glm::dvec2(0, 0), {600, 0}, {0, 600}, {600, 600}}) {
      for (int turn = 0; turn < 180; ++turn) {
        const double angle = turn * std::numbers::pi / 180.0;
        const glm::dvec3 at = wall.lowerLeft_m + corner.x * along + corner.y * up - eye;
        const glm::dvec3 next = at + 1e-3 * (std::cos(angle) * along + std::sin(angle) * up);
        finest = std::min(finest,
                          1e3 * std::asin(glm::length(glm::cross(glm::normalize(at), glm::normalize(next)))));
      }
    }
  }
  EXPECT_NEAR(finestPixel_rad(walls, eye), finest, 1e-3 * finest);  // to a degree of the slant's direction
  EXPECT_EQ(finestPixel_rad({}, eye), 0.001);
}

}  // namespace
}  // namespace carom
