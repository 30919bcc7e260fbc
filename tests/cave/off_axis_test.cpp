#include "cave/off_axis.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <limits>

#include "engine/random_world.h"

namespace carom {
namespace {

constexpr double kOnWall_m = 1e-9;  // double rounding over some metres; a pixel is a millimetre or more
constexpr double kHalfEyes_m = 0.032;

Wall wallOf(const glm::dvec3& lowerLeft, const glm::dvec3& lowerRight, const glm::dvec3& upperLeft) {
  Wall wall;
  wall.lowerLeft_m = lowerLeft;
  wall.lowerRight_m = lowerRight;
  wall.upperLeft_m = upperLeft;
  return wall;
}

/// A cube of 3 m, x right, y forward, z up, seen from inside: front, left, right, floor, ceiling.
std::array<Wall, 5> room() {
  const double h = 1.5;
  return {wallOf({-h, h, 0}, {h, h, 0}, {-h, h, 3}), wallOf({-h, -h, 0}, {-h, h, 0}, {-h, -h, 3}),
          wallOf({h, h, 0}, {h, -h, 0}, {h, h, 3}), wallOf({-h, -h, 0}, {h, -h, 0}, {-h, h, 0}),
          wallOf({-h, h, 3}, {h, h, 3}, {-h, -h, 3})};
}

/// A wall anywhere, turned anyhow, of 0.3 to 4 m.
Wall randomWall(test::Random& random) {
  const glm::dvec3 right = random.direction();
  const glm::dvec3 up = glm::normalize(glm::cross(right, random.direction()));
  const glm::dvec3 corner = random.inBox(3.0);
  return wallOf(corner, corner + random.in(0.3, 4.0) * right, corner + random.in(0.3, 4.0) * up);
}

glm::dvec3 normalOf(const Wall& wall) {
  return glm::normalize(
      glm::cross(wall.lowerRight_m - wall.lowerLeft_m, wall.upperLeft_m - wall.lowerLeft_m));
}

/// The independent way: the ray from the eye through the point, cut with the wall's plane.
glm::dvec3 rayOnWall(const Wall& wall, const glm::dvec3& eye, const glm::dvec3& point) {
  const glm::dvec3 normal = normalOf(wall);
  const double share = glm::dot(normal, wall.lowerLeft_m - eye) / glm::dot(normal, point - eye);
  return eye + share * (point - eye);
}

/// Where on the wall clip coordinates light a pixel up.
glm::dvec3 clipOnWall(const Wall& wall, const glm::dvec4& clip) {
  const glm::dvec2 across = (glm::dvec2(clip) / clip.w + 1.0) * 0.5;
  return wall.lowerLeft_m + across.x * (wall.lowerRight_m - wall.lowerLeft_m) +
         across.y * (wall.upperLeft_m - wall.lowerLeft_m);
}

struct Eyes {
  glm::dvec3 left_m, right_m;
};

/// A head somewhere in the room, turned and rolled anyhow.
Eyes randomHead(test::Random& random) {
  const glm::dvec3 head = glm::dvec3(0, 0, 1.5) + random.inBox(1.3);
  const glm::dvec3 rightwards = random.direction();
  return {head - kHalfEyes_m * rightwards, head + kHalfEyes_m * rightwards};
}

TEST(OffAxis, ProjectsAsTheRayThroughTheWallDoes) {
  test::Random random(1);
  for (int i = 0; i < 10000; ++i) {
    const Wall wall = randomWall(random);
    const glm::dvec3 middle = 0.5 * (wall.lowerRight_m + wall.upperLeft_m);
    const glm::dvec3 eye = middle + random.in(0.1, 3.0) * normalOf(wall) +
                           random.in(-2.0, 2.0) * (wall.lowerRight_m - wall.lowerLeft_m);
    const glm::dvec3 point = eye + random.direction() * random.in(0.2, 20.0);
    if (glm::dot(point - eye, normalOf(wall)) > -0.1) continue;  // beside or behind the eye
    SCOPED_TRACE(testing::Message() << "case " << i);
    const auto fromEye = clipFromEye(wall, eye);
    const auto fromRoom = clipFromRoom(wall, eye);
    ASSERT_TRUE(fromEye && fromRoom);
    const glm::dvec3 expected = rayOnWall(wall, eye, point);
    const double tolerance_m = kOnWall_m * (1.0 + glm::length(expected));
    ASSERT_LT(glm::length(clipOnWall(wall, *fromEye * glm::dvec4(point - eye, 1.0)) - expected), tolerance_m);
    ASSERT_LT(glm::length(clipOnWall(wall, *fromRoom * glm::dvec4(point, 1.0)) - expected), tolerance_m);
  }
}

TEST(OffAxis, CornersOfTheWallAreCornersOfThePicture) {
  const Wall wall = room()[1];
  const glm::dmat4 clip = *clipFromRoom(wall, {0.3, -0.7, 1.2});
  const glm::dvec4 lowerLeft = clip * glm::dvec4(wall.lowerLeft_m, 1.0);
  const glm::dvec4 upperRight =
      clip * glm::dvec4(wall.lowerRight_m + wall.upperLeft_m - wall.lowerLeft_m, 1.0);
  for (int axis = 0; axis < 2; ++axis) {
    EXPECT_NEAR(lowerLeft[axis] / lowerLeft.w, -1.0, 1e-12);
    EXPECT_NEAR(upperRight[axis] / upperRight.w, 1.0, 1e-12);
  }
}

TEST(OffAxis, DepthRunsFromNearToFar) {
  const Wall wall = room()[0];
  const glm::dvec3 eye(0.4, 0.2, 1.6);
  const ClipRange range{0.05, 60.0};
  const glm::dmat4 clip = *clipFromEye(wall, eye, range);
  const glm::dvec4 nearest = clip * glm::dvec4(0.01, range.near_m, 0.02, 1.0);
  const glm::dvec4 farthest = clip * glm::dvec4(3.0, range.far_m, -2.0, 1.0);
  EXPECT_NEAR(nearest.z / nearest.w, -1.0, 1e-12);
  EXPECT_NEAR(farthest.z / farthest.w, 1.0, 1e-12);
  EXPECT_NEAR(farthest.w, range.far_m, 1e-12);
}

TEST(OffAxis, PointsOnTheWallHaveNoParallaxForARolledHead) {
  test::Random random(2);
  for (int i = 0; i < 10000; ++i) {
    const Eyes eyes = randomHead(random);
    for (const Wall& wall : room()) {
      const auto left = clipFromRoom(wall, eyes.left_m);
      const auto right = clipFromRoom(wall, eyes.right_m);
      ASSERT_TRUE(left && right) << "case " << i;
      const glm::dvec4 point(wall.lowerLeft_m + random.in(0, 1) * (wall.lowerRight_m - wall.lowerLeft_m) +
                                 random.in(0, 1) * (wall.upperLeft_m - wall.lowerLeft_m),
                             1.0);
      const glm::dvec3 parallax = clipOnWall(wall, *right * point) - clipOnWall(wall, *left * point);
      ASSERT_LT(glm::length(parallax), kOnWall_m) << "case " << i;
    }
  }
}

// A point s times as far as the wall has the parallax (1 − 1/s) of the eyes' distance, along their line:
// behind the wall (s > 1) uncrossed, in front (s < 1) crossed. Both eyes are equally far from the wall, the
// head rolled anyhow.
TEST(OffAxis, PointsBehindAreUncrossedAndInFrontCrossed) {
  test::Random random(3);
  for (int i = 0; i < 10000; ++i) {
    const glm::dvec3 head = glm::dvec3(0, 0, 1.5) + random.inBox(1.3);
    for (const Wall& wall : room()) {
      const glm::dvec3 inWall = random.direction();
      const glm::dvec3 rightwards =
          glm::normalize(inWall - glm::dot(inWall, normalOf(wall)) * normalOf(wall));
      const glm::dvec3 left = head - kHalfEyes_m * rightwards;
      const glm::dvec3 right = head + kHalfEyes_m * rightwards;
      const glm::dvec3 onWall = wall.lowerLeft_m + random.in(0, 1) * (wall.lowerRight_m - wall.lowerLeft_m) +
                                random.in(0, 1) * (wall.upperLeft_m - wall.lowerLeft_m);
      for (const double s : {random.in(0.5, 1.0), random.in(1.0, 20.0)}) {
        const glm::dvec4 point(head + s * (onWall - head), 1.0);
        const glm::dvec3 parallax = clipOnWall(wall, *clipFromRoom(wall, right) * point) -
                                    clipOnWall(wall, *clipFromRoom(wall, left) * point);
        ASSERT_LT(glm::length(parallax - (1.0 - 1.0 / s) * (right - left)), kOnWall_m) << "case " << i;
      }
    }
  }
}

// A point seen through the shared edge of two walls lights up the same physical place on both.
TEST(OffAxis, WallsMeetWithoutASeam) {
  const std::array<Wall, 5> walls = room();
  struct Edge {
    int a, b;
    glm::dvec3 from, to;
  };
  const double h = 1.5;
  const std::array<Edge, 6> edges{{{0, 1, {-h, h, 0}, {-h, h, 3}},
                                   {0, 2, {h, h, 0}, {h, h, 3}},
                                   {0, 3, {-h, h, 0}, {h, h, 0}},
                                   {1, 3, {-h, -h, 0}, {-h, h, 0}},
                                   {2, 3, {h, -h, 0}, {h, h, 0}},
                                   {0, 4, {-h, h, 3}, {h, h, 3}}}};
  test::Random random(4);
  for (int i = 0; i < 10000; ++i) {
    const Eyes eyes = randomHead(random);
    for (const Edge& edge : edges) {
      for (const glm::dvec3& eye : {eyes.left_m, eyes.right_m}) {
        const glm::dvec3 onEdge = edge.from + random.in(0, 1) * (edge.to - edge.from);
        const glm::dvec4 seen((onEdge - eye) * random.in(0.3, 10.0), 1.0);
        const glm::dvec3 a = clipOnWall(walls[edge.a], *clipFromEye(walls[edge.a], eye) * seen);
        const glm::dvec3 b = clipOnWall(walls[edge.b], *clipFromEye(walls[edge.b], eye) * seen);
        ASSERT_LT(glm::length(a - b), kOnWall_m)
            << "case " << i << " edge of walls " << edge.a << ", " << edge.b;
        ASSERT_LT(glm::length(a - onEdge), kOnWall_m) << "case " << i;
      }
    }
  }
}

TEST(OffAxis, AnEyeOnOrBehindTheWallHasNoPicture) {
  const Wall wall = room()[0];
  EXPECT_TRUE(clipFromEye(wall, {0.0, 1.49, 1.5}));
  EXPECT_FALSE(clipFromEye(wall, {0.0, 1.5, 1.5}));
  EXPECT_FALSE(clipFromEye(wall, {0.0, 1.6, 1.5}));
  EXPECT_FALSE(clipFromEye(wall, {0.0, std::numeric_limits<double>::quiet_NaN(), 1.5}));
  EXPECT_FALSE(clipFromRoom(wall, {0.0, 1.6, 1.5}));
}

TEST(OffAxis, CornersOnOneLineAreNoWall) {
  EXPECT_FALSE(clipFromEye(wallOf({0, 0, 0}, {1, 0, 0}, {2, 0, 0}), {0, -1, 0}));
}

}  // namespace
}  // namespace carom
