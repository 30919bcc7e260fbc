// How large flat cells may be: straight edges in random boxes, by the engine's own boosts.
#include "cave/bodies/flat_cells.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "engine/light_speed.h"
#include "engine/random_world.h"

namespace carom {
namespace {

using test::kC_m_s;

constexpr double kLargest_rad = 5e-4;  // of angles that are small enough to be drawn

/// Where light shows a place at rest on the board, from the eye.
Vec3 seen(const Lorentz& headFromBoard, const Vec3& fromEye_m) {
  return (headFromBoard * Displacement{-glm::length(fromEye_m) / kC_m_s, fromEye_m}).dr_m;
}

// The middle of an edge that is drawn straight is off by no more than the square of the edge's length over
// the longest flat one, and somewhere by nearly as much.
TEST(FlatCells, EdgesAreOffByNoMoreThanTheirLengthSays) {
  test::Random random(171);
  double worst = 0.0;
  for (int i = 0; i < 2000; ++i) {
    CASE(random, i);
    const Vec3 u = random.u(0.95), eye_m = random.inBox(1.0);
    const double half_m = random.in(0.002, 0.03);
    const Vec3 middle_m = eye_m + random.direction() * random.in(0.2, 3.0);
    const Extent box{middle_m - half_m, middle_m + half_m};
    const double longest_m = longestFlat_m(box, eye_m, u);
    ASSERT_GT(longest_m, 0.0);
    const Lorentz headFromBoard = Lorentz::boost(u, kC_m_s).inverse();
    for (int edge = 0; edge < 20; ++edge) {
      const Vec3 from_m = middle_m + random.inBox(half_m) - eye_m,
                 to_m = middle_m + random.inBox(half_m) - eye_m;
      const Vec3 straight = 0.5 * (seen(headFromBoard, from_m) + seen(headFromBoard, to_m)),
                 exact = seen(headFromBoard, 0.5 * (from_m + to_m));
      const double off_rad = std::atan2(glm::length(glm::cross(straight, exact)), glm::dot(straight, exact));
      const double share = glm::distance(from_m, to_m) / longest_m, allowed_rad = share * share;
      if (allowed_rad > kLargest_rad) continue;
      EXPECT_LE(off_rad, 1.05 * allowed_rad + 1e-9);
      if (allowed_rad > 1e-6) worst = std::max(worst, off_rad / allowed_rad);
    }
  }
  EXPECT_GT(worst, 0.5) << "cells could be larger";
}

TEST(FlatCells, AHeadAtRestSeesStraightEdges) {
  const Extent box{{0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}};
  EXPECT_EQ(longestFlat_m(box, {3.0, 0.0, 0.0}, glm::dvec3(0.0)), std::numeric_limits<double>::infinity());
  // From within the box, and nearer than a tenth of a metre, it is that of a tenth of a metre.
  const glm::dvec3 u(0.5, 0.0, 0.0);
  EXPECT_EQ(longestFlat_m(box, {0.5, 0.5, 0.5}, u), longestFlat_m(box, {0.9, 0.4, 0.5}, u));
}

}  // namespace
}  // namespace carom
