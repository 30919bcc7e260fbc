// Outlines: what is wrong with corners, and what a plate of that outline is.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "engine/polygons/outline.h"
#include "engine/sampled_body.h"

namespace carom {
namespace {

using Vec2 = glm::dvec2;

std::vector<Vec2> regular(int corners) {
  std::vector<Vec2> all;
  for (int k = 0; k < corners; ++k)
    all.push_back({0.03 * std::cos(2.0 * M_PI * k / corners), 0.03 * std::sin(2.0 * M_PI * k / corners)});
  return all;
}

void expectFault(const std::vector<Vec2>& corners, std::size_t corner, const std::string& part) {
  const auto fault = faultOf(corners);
  ASSERT_TRUE(fault) << part;
  EXPECT_EQ(fault->corner, corner) << fault->what;
  EXPECT_NE(fault->what.find(part), std::string::npos) << fault->what;
}

TEST(Outline, SaysWhatIsWrongAndWhere) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(faultOf(regular(3)));
  EXPECT_FALSE(faultOf(regular(256)));
  EXPECT_FALSE(faultOf(std::vector<Vec2>{{0, 0}, {2, 0}, {1, 0.5}, {2, 2}, {0, 2}}));
  expectFault({{0, 0}, {1, 0}}, 0, "2 corners: expected 3 to 256");
  expectFault(regular(257), 0, "257 corners");
  expectFault({{0, 0}, {1, 0}, {1, nan}}, 2, "corner 3 is not a place");
  expectFault({{0, 0}, {1, 0}, {1, 1}, {1, 0}}, 3, "corner 4 lies on corner 2");
  expectFault({{0, 0}, {0, 1}, {1, 1}, {1, 0}}, 0, "clockwise");
  expectFault({{0, 0}}, 0, "1 corner: expected 3 to 256");
  expectFault({{0, 0}, {1, 0}, {2, 0}}, 0, "one line");
  expectFault({{0, 0}, {2, 0}, {1, 0}, {1.5, 0}}, 0, "one line");
  expectFault({{0, 0}, {2, 0}, {0.5, 1}, {1, -1}}, 2, "crosses or touches");
  expectFault({{0, 0}, {2, 0}, {2, 2}, {1, 0}, {0, 2}}, 2, "crosses or touches");
  expectFault({{0, 0}, {2, 0}, {1, 0}, {1, 1}}, 1, "lie on each other");
}

// Bow ties of any turn, size and waist, also such as have no area: both sides that cross are named.
TEST(Outline, ABowTieCrossesItself) {
  for (double angle = 0.0; angle < 6.3; angle += 0.37) {
    for (const double size : {1e-6, 1.0, 1e6}) {
      for (const double wide : {0.5, 0.9, 1.0, 1.1, 2.0}) {
        std::vector<Vec2> corners;
        for (const Vec2& p : {Vec2{-1, -1}, Vec2{wide, 1}, Vec2{wide, -1}, Vec2{-1, 1}})
          corners.push_back(size * Vec2{p.x * std::cos(angle) - p.y * std::sin(angle),
                                        p.x * std::sin(angle) + p.y * std::cos(angle)});
        expectFault(corners, 2, "the side from corner 3 crosses or touches the side from corner 1");
      }
    }
  }
}

TEST(Outline, MirrorImagesHaveTheSameBits) {
  for (int count = 3; count < 40; ++count) {
    std::vector<Vec2> corners = regular(count), image;
    for (auto corner = corners.rbegin(); corner != corners.rend(); ++corner)
      image.push_back({corner->x, -corner->y});
    const Outline outline(corners), mirrored(image);
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const Outline::Side &side = outline.sides()[k],
                          &other = mirrored.sides()[(2 * corners.size() - 2 - k) % corners.size()];
      EXPECT_EQ(side.offset, other.offset);
      EXPECT_EQ(side.normal.x, other.normal.x);
      EXPECT_EQ(side.normal.y, -other.normal.y);
    }
  }
}

TEST(Outline, MomentsOfARectangleAndOfMovedCorners) {
  const double a = 0.12, b = 0.02;
  const std::vector<Vec2> bar{{-a / 2, -b / 2}, {a / 2, -b / 2}, {a / 2, b / 2}, {-a / 2, b / 2}};
  const OutlineMoments moments = momentsOf(bar);
  EXPECT_NEAR(moments.area, a * b, 1e-17);
  EXPECT_NEAR(moments.centre.x, 0.0, 1e-17);
  EXPECT_NEAR(moments.inertia, (a * a + b * b) / 12.0 / ((a * a + b * b) / 4.0), 1e-15);
  std::vector<Vec2> moved = bar;
  for (Vec2& corner : moved) corner += Vec2{0.5, 0.25};
  EXPECT_NEAR(momentsOf(moved).centre.x, 0.5, 1e-15);
  EXPECT_NEAR(momentsOf(moved).centre.y, 0.25, 1e-15);
  EXPECT_NEAR(momentsOf(regular(256)).inertia, 0.5, 1e-3);  // a disc
}

TEST(Outline, ClearanceInsideAndOutside) {
  const Outline square(std::vector<Vec2>{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}});
  EXPECT_TRUE(square.isConvex());
  EXPECT_DOUBLE_EQ(square.clearanceOf({0.75, 0.5}).outside, -0.25);
  EXPECT_EQ(square.clearanceOf({0.75, 0.5}).side, 1u);
  EXPECT_DOUBLE_EQ(square.clearanceOf({0.5, -3.0}).outside, 2.0);
  const Outline notch(std::vector<Vec2>{{-1, -1}, {1, -1}, {1, 1}, {0, 0}, {-1, 1}});
  EXPECT_FALSE(notch.isConvex());
  EXPECT_DOUBLE_EQ(notch.clearanceOf({0.0, 0.5}).outside, std::sqrt(0.125));
  EXPECT_DOUBLE_EQ(notch.clearanceOf({0.0, -0.75}).outside, -0.25);
  EXPECT_DOUBLE_EQ(notch.clearanceOf({3.0, 2.0}).outside, std::sqrt(5.0));
}

// Against the number of crossings of a ray: stars with sharp points and dents.
TEST(Outline, APointIsInsideWhereARaySaysSo) {
  std::mt19937_64 random(17);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  int inside = 0, outside = 0;
  for (int n = 0; n < 500; ++n) {
    const int count = 4 + n % 17;
    std::vector<Vec2> corners;
    for (int k = 0; k < count; ++k) {
      const double at = 2.0 * M_PI * (k + 0.8 * uniform(random)) / count, far = 0.1 + 0.9 * uniform(random);
      corners.push_back({far * std::cos(at), far * std::sin(at)});
    }
    if (faultOf(corners)) continue;
    const Outline outline(corners);
    const test::SampledBody sampled(corners, {0.0, 0.0, 0.0}, {0.0, 0.0}, 0.0, outline.radius());
    for (int m = 0; m < 100; ++m) {
      const Vec2 point{2.2 * uniform(random) - 1.1, 2.2 * uniform(random) - 1.1};
      const double depth = sampled.depthOf({0.0, point.x, point.y});
      const double clearance = outline.clearanceOf(point).outside;
      ASSERT_EQ(depth > 0.0, clearance < 0.0) << "outline " << n << " at " << point.x << ", " << point.y;
      (depth > 0.0 ? inside : outside) += 1;
    }
  }
  EXPECT_GT(inside, 5000);
  EXPECT_GT(outside, 5000);
}

}  // namespace
}  // namespace carom
