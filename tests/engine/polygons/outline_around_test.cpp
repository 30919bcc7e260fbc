#include "engine/polygons/outline_around.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "engine/polygons/outline.h"
#include "engine/random_world.h"

namespace carom {
namespace {

using Vec2 = glm::dvec2;

double turn(const Vec2& a, const Vec2& b, const Vec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

TEST(HullOf, IsConvexHoldsAllAndHasOnlyTheirPoints) {
  test::Random random(83);
  for (int i = 0; i < 200; ++i) {
    CASE(random, i);
    std::vector<Vec2> points;
    for (int k = 3 + static_cast<int>(random.in(0.0, 60.0)); k > 0; --k)
      points.push_back({std::round(random.in(-9.0, 9.0)), std::round(random.in(-9.0, 9.0))});
    points.insert(points.end(), {{-10.0, -10.0}, {10.0, -10.0}, {0.0, 10.0}});  // not all on a line
    const std::vector<Vec2> hull = hullOf(points);
    ASSERT_GE(hull.size(), 3u);
    for (std::size_t k = 0; k < hull.size(); ++k) {
      const Vec2 &a = hull[k], &b = hull[(k + 1) % hull.size()], &c = hull[(k + 2) % hull.size()];
      EXPECT_GT(turn(a, b, c), 0.0) << "a corner on a side, or a dent";
      EXPECT_NE(std::find(points.begin(), points.end(), a), points.end());
      for (const Vec2& point : points) EXPECT_GE(turn(a, b, point), 0.0);
    }
  }
}

// A star of many corners.
std::vector<Vec2> star(test::Random& random, int corners) {
  std::vector<Vec2> ring;
  for (int k = 0; k < corners; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / corners, radius = random.in(0.9, 1.1);
    ring.push_back(radius * Vec2{std::cos(angle), std::sin(angle)});
  }
  return ring;
}

TEST(OutlineAround, HoldsTheRingIsNearAndHasFewCorners) {
  test::Random random(84);
  for (int i = 0; i < 60; ++i) {
    CASE(random, i);
    const std::vector<Vec2> ring = star(random, 60);
    constexpr double kMost = 0.4;
    const std::vector<Vec2> around = outlineAround(ring, kMost, 12);
    EXPECT_LE(around.size(), 12u);
    const Outline outer(around), inner(ring);
    for (const Vec2& corner : ring) EXPECT_LE(outer.clearanceOf(corner).outside, 1e-9);
    for (const Vec2& corner : around) EXPECT_LE(inner.clearanceOf(corner).outside, kMost + 1e-9);
  }
}

TEST(OutlineAround, CornersOnStraightSidesGo) {
  const std::vector<Vec2> ring{{0.0, 0.0}, {0.5, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.5, 1.0}, {0.0, 1.0}};
  EXPECT_EQ(outlineAround(ring, 0.1, 10).size(), 4u);
}

}  // namespace
}  // namespace carom
