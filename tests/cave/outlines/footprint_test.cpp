// Footprints of meshes, against closed forms and against dense samples of random meshes.
#include "cave/outlines/footprint.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <numbers>
#include <vector>

#include "cave/outlines/mesh_from_above.h"
#include "engine/polygons/outline.h"
#include "engine/random_world.h"
#include "engine/text/input_error.h"
#include "places.h"

namespace carom {
namespace {

using Vec2 = glm::dvec2;
using Corners = std::vector<Vec2>;

double cross2(const Vec2& a, const Vec2& b) { return a.x * b.y - a.y * b.x; }

double distanceToTriangle(const Vec2& x, const Vec2* p) {
  double nearest = 1e300;
  int left = 0, right = 0;
  for (int k = 0; k < 3; ++k) {
    const Vec2 a = p[k], along = p[(k + 1) % 3] - a;
    const double share =
        std::clamp(glm::dot(x - a, along) / std::max(glm::dot(along, along), 1e-300), 0.0, 1.0);
    nearest = std::min(nearest, glm::length(x - a - share * along));
    (cross2(along, x - a) >= 0.0 ? left : right) += 1;
  }
  return left == 3 || right == 3 ? 0.0 : nearest;
}

/// Expects that the outline contains every triangle, and how far it is from them.
void expectAround(const Footprint& footprint, const Corners& triangles, double outwards) {
  ASSERT_FALSE(faultOf(footprint.corners));
  const Outline outline(footprint.corners);
  EXPECT_NEAR(glm::length(momentsOf(footprint.corners).centre), 0.0, 1e-12 * footprint.radius);
  EXPECT_DOUBLE_EQ(outline.radius(), footprint.radius);
  constexpr int kSamples = 12;
  double within = -1e300, farthest = 0.0;
  for (std::size_t i = 0; i < triangles.size(); i += 3) {
    for (int u = 0; u <= kSamples; ++u) {
      for (int v = 0; u + v <= kSamples; ++v) {
        const double shares[]{static_cast<double>(u) / kSamples, static_cast<double>(v) / kSamples};
        const Vec2 at = triangles[i] + shares[0] * (triangles[i + 1] - triangles[i]) +
                        shares[1] * (triangles[i + 2] - triangles[i]);
        within = std::max(within, outline.clearanceOf(at - footprint.centre).outside);
      }
    }
  }
  EXPECT_LT(within, 1e-7 * footprint.radius) << "it is covered";
  for (const Outline::Side& side : outline.sides()) {
    for (double along = 0.0; along <= side.length; along += 0.002 * footprint.radius) {
      const Vec2 at = side.from + along * side.along + footprint.centre;
      double nearest = 1e300;
      for (std::size_t i = 0; i < triangles.size(); i += 3)
        nearest = std::min(nearest, distanceToTriangle(at, &triangles[i]));
      farthest = std::max(farthest, nearest);
    }
  }
  EXPECT_LE(farthest, outwards * footprint.radius);
}

/// The triangles between a centre and the sides of a polygon that is seen from there.
Corners fan(const Corners& polygon, const Vec2& centre = Vec2(0.0)) {
  Corners triangles;
  for (std::size_t k = 0; k < polygon.size(); ++k)
    triangles.insert(triangles.end(), {centre, polygon[k], polygon[(k + 1) % polygon.size()]});
  return triangles;
}

Corners ring(int corners, double radius) {
  Corners all;
  for (int k = 0; k < corners; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / corners;
    all.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return all;
}

/// Each corner of the outline is one of the polygon's, all of which are there.
void expectCorners(const Footprint& footprint, const Corners& polygon) {
  ASSERT_EQ(footprint.corners.size(), polygon.size());
  for (const Vec2& corner : polygon) {
    const auto same = [&](const Vec2& found) { return found + footprint.centre - corner; };
    const bool found = std::any_of(footprint.corners.begin(), footprint.corners.end(),
                                   [&](const Vec2& other) { return glm::length(same(other)) < 1e-15; });
    EXPECT_TRUE(found) << corner.x << " " << corner.y;
  }
}

TEST(Footprint, OfAFinelyDividedBoxAreItsFourCorners) {
  Corners triangles;
  const double a = 0.25, b = 0.0625;  // halves of its sides
  constexpr int kCells = 8;
  const auto at = [&](int i, int j) {
    return Vec2(a * (2.0 * i / kCells - 1.0) + 1.0, b * (2.0 * j / kCells - 1.0));
  };
  for (int i = 0; i < kCells; ++i) {
    for (int j = 0; j < kCells; ++j) {
      triangles.insert(triangles.end(), {at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      triangles.insert(triangles.end(), {at(i, j), at(i, j + 1), at(i + 1, j + 1)});  // its other way round
    }
    triangles.insert(triangles.end(), {at(i, 0), at(i, 0), at(i + 1, 0)});  // upright: a line
  }
  const Footprint footprint = footprintOf(triangles);
  EXPECT_TRUE(footprint.isInOnePiece);
  expectCorners(footprint, {{1.0 - a, -b}, {1.0 + a, -b}, {1.0 + a, b}, {1.0 - a, b}});
  EXPECT_NEAR(footprint.centre.x, 1.0, 1e-15);
  EXPECT_NEAR(footprint.radius, std::hypot(a, b), 1e-15);
  EXPECT_NEAR(momentsOf(footprint.corners).area, 4.0 * a * b, 1e-15);
}

Corners gear(int teeth, double foot, double tip) {
  Corners polygon;
  for (int k = 0; k < 4 * teeth; ++k) {
    const double angle = 2.0 * std::numbers::pi * (k + 0.5) / (4 * teeth), radius = k % 4 < 2 ? tip : foot;
    polygon.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return polygon;
}

TEST(Footprint, OfAGearAreItsTeeth) {
  for (const int teeth : {4, 8, 12}) {
    const Corners polygon = gear(teeth, 0.7, 1.0);
    const Footprint footprint = footprintOf(fan(polygon));
    expectCorners(footprint,
                  polygon);  // more than 16 where there are more teeth than four: each dent is deep
    EXPECT_NEAR(momentsOf(footprint.corners).area, momentsOf(polygon).area, 1e-14);
    EXPECT_FALSE(Outline(footprint.corners).isConvex());
  }
}

TEST(Footprint, OfARingCoversItsHole) {
  Corners triangles;
  const Corners outer = ring(6, 1.0), inner = ring(6, 0.5);
  for (std::size_t k = 0; k < 6; ++k) {
    const std::size_t next = (k + 1) % 6;
    triangles.insert(triangles.end(), {inner[k], outer[k], outer[next], inner[k], outer[next], inner[next]});
  }
  expectCorners(footprintOf(triangles), outer);
}

// A circle's polygon of n corners around it leaves it by 1/cos(π/n) − 1: 16 leave it by 1.96 %, 23 by 0.95 %.
TEST(Footprint, OfARoundMeshHasAsManyCornersAsOnePercentNeeds) {
  for (const int corners : {24, 64, 96, 200}) {
    const Corners triangles = fan(ring(corners, 0.04));
    const Footprint footprint = footprintOf(triangles);
    EXPECT_GE(footprint.corners.size(), corners == 24 ? 22u : 23u);
    EXPECT_LE(footprint.corners.size(), 34u);
    expectAround(footprint, triangles, kFootprintOutwards);
  }
}

TEST(Footprint, OfPiecesIsTheirHull) {
  Corners triangles = fan(ring(4, 1.0));
  for (const Vec2& corner : fan(ring(4, 1.0))) triangles.push_back(corner + Vec2(3.0, 0.0));
  const Footprint footprint = footprintOf(triangles);
  EXPECT_FALSE(footprint.isInOnePiece);
  expectCorners(footprint, {{-1.0, 0.0}, {0.0, -1.0}, {3.0, -1.0}, {4.0, 0.0}, {3.0, 1.0}, {0.0, 1.0}});
}

TEST(Footprint, OfALineOrAPointIsNone) {
  EXPECT_THROW(footprintOf({}), std::runtime_error);
  EXPECT_THROW(footprintOf(Corners{{1, 2}, {1, 2}, {1, 2}}), std::runtime_error);
  EXPECT_THROW(footprintOf(Corners{{0, 0}, {1, 1}, {3, 3}}), std::runtime_error);
  EXPECT_THROW(footprintOf(Corners{{0, 0}, {1, 0}, {0.5, 1e-12}}), std::runtime_error);
}

/// Convex clouds like stones, stars with dents, and heaps of triangles that cross each other.
Corners randomMesh(test::Random& random, int kind) {
  const double stretch = random.in(0.3, 1.0);
  const Vec2 centre{random.in(-5.0, 5.0), random.in(-5.0, 5.0)};
  Corners triangles;
  if (kind == 2) {
    const int count = static_cast<int>(random.in(1.0, 12.0));
    const auto part = [&](double from) {
      const double angle = from + random.in(0.1, 2.0), radius = random.in(0.2, 1.0);
      return Vec2{radius * std::cos(angle), stretch * radius * std::sin(angle)};
    };
    for (int i = 0; i < count; ++i)  // each around the middle
      triangles.insert(triangles.end(), {part(0.0), part(2.1), part(4.2)});
  } else {
    const int count = static_cast<int>(random.in(3.0, kind == 0 ? 40.0 : 14.0));
    Corners polygon;
    for (int k = 0; k < count; ++k) {
      const double angle = 2.0 * std::numbers::pi * (k + random.in(0.1, 0.9)) / count;
      const double radius = kind == 0 ? random.in(0.97, 1.0) : random.in(0.3, 1.0);
      polygon.push_back({radius * std::cos(angle), stretch * radius * std::sin(angle)});
    }
    triangles = fan(polygon);
  }
  for (Vec2& corner : triangles) corner += centre;
  return triangles;
}

TEST(Footprint, OfRandomMeshesContainsThemAndLeavesThemByOnePercent) {
  test::Random random(2201);
  int few = 0, simplified = 0, many = 0;
  for (int i = 0; i < 150; ++i) {
    CASE(random, i);
    const Corners triangles = randomMesh(random, i % 3);
    const Footprint footprint = footprintOf(triangles);
    if (!footprint.isInOnePiece) continue;
    expectAround(footprint, triangles, kFootprintOutwards);
    (footprint.corners.size() <= kEnoughCorners ? few : many) += 1;
    simplified += footprint.corners.size() < triangles.size() / 3 ? 1 : 0;
  }
  std::printf("%d with 16 corners at most, %d of all simplified, %d with more\n", few, simplified, many);
  EXPECT_GT(few, 75);
  EXPECT_GT(simplified, 20);
}

TEST(Footprint, OfAMeshFile) {
  const Footprint bar = footprintOf(trianglesFromAbove(CAROM_CONFIG_DIR "/models/cushion-bar.obj"));
  EXPECT_LE(bar.corners.size(), kEnoughCorners);
  const Corners wheel = trianglesFromAbove(CAROM_CONFIG_DIR "/models/wheel.obj");
  expectAround(footprintOf(wheel), wheel, kFootprintOutwards);
  EXPECT_THROW(trianglesFromAbove("nothing.obj"), InputError);
}

}  // namespace
}  // namespace carom
