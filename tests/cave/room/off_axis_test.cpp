#include "cave/room/off_axis.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <glm/geometric.hpp>
#include <limits>
#include <vector>

#include "app/rig/rig.h"
#include "cave/room/room_geometry.h"
#include "engine/random_world.h"
#include "places.h"

namespace carom {
namespace {

constexpr double kOnWall_m = 1e-9;  // double rounding over some metres; a pixel is a millimetre or more

Wall wallOf(const glm::dvec3& lowerLeft, const glm::dvec3& lowerRight, const glm::dvec3& upperLeft) {
  Wall wall;
  wall.lowerLeft_m = lowerLeft;
  wall.lowerRight_m = lowerRight;
  wall.upperLeft_m = upperLeft;
  return wall;
}

/// Each file of config/rigs.
std::vector<Rig> shippedRigs() {
  std::vector<Rig> rigs;
  for (const auto& file : std::filesystem::directory_iterator(CAROM_CONFIG_DIR "/rigs")) {
    Rig rig = readRig(file.path());
    if (!isHeadset(rig)) rig.walls = standingWalls(rig);  // the flat pieces of curved screens
    rigs.push_back(std::move(rig));
  }
  return rigs;
}

/// x right, y forward, z up.
const Wall kFront = wallOf({-1.5, 1.5, 0}, {1.5, 1.5, 0}, {-1.5, 1.5, 3});

/// A wall anywhere, turned anyhow, of 0.3 to 4 m.
Wall randomWall(test::Random& random) {
  const glm::dvec3 right = random.direction();
  const glm::dvec3 up = glm::normalize(glm::cross(right, random.direction()));
  const glm::dvec3 corner = random.inBox(3.0);
  return wallOf(corner, corner + random.in(0.3, 4.0) * right, corner + random.in(0.3, 4.0) * up);
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

double before_m(const Wall& wall, const glm::dvec3& eye) {
  return glm::dot(normalOf(wall), eye - wall.lowerLeft_m);
}

/// A head where a person may be before all walls of the room, turned and rolled anyhow.
Eyes randomHead(test::Random& random, const Rig& rig) {
  constexpr double kNearest_m = 0.1;
  for (;;) {
    const glm::dvec3 head = random.in(0.8, 2.1) * rig.axes.up + random.in(-1.4, 1.4) * rig.axes.right +
                            random.in(-1.4, 1.4) * rig.axes.forward;
    const glm::dvec3 half = 0.5 * rig.viewers.front().head.eyeSeparation_m * random.direction();
    const Eyes eyes{head - half, head + half};
    if (std::all_of(rig.walls.begin(), rig.walls.end(), [&](const Wall& wall) {
          return std::min(before_m(wall, eyes.left_m), before_m(wall, eyes.right_m)) > kNearest_m;
        }))
      return eyes;
  }
}

glm::dvec3 randomOnWall(test::Random& random, const Wall& wall) {
  return wall.lowerLeft_m + random.in(0, 1) * (wall.lowerRight_m - wall.lowerLeft_m) +
         random.in(0, 1) * (wall.upperLeft_m - wall.lowerLeft_m);
}

TEST(OffAxis, ProjectsAsTheRayThroughTheWallDoes) {
  test::Random random(1);
  for (int i = 0; i < 10000; ++i) {
    CASE(random, i);
    const Wall wall = randomWall(random);
    const glm::dvec3 middle = 0.5 * (wall.lowerRight_m + wall.upperLeft_m);
    const glm::dvec3 eye = middle + random.in(0.1, 3.0) * normalOf(wall) +
                           random.in(-2.0, 2.0) * (wall.lowerRight_m - wall.lowerLeft_m);
    const glm::dvec3 point = eye + random.direction() * random.in(0.2, 20.0);
    if (glm::dot(point - eye, normalOf(wall)) > -0.1) continue;  // beside or behind the eye
    const auto fromEye = clipFromEye(wall, eye);
    const auto fromRoom = clipFromRoom(wall, eye);
    ASSERT_TRUE(fromEye && fromRoom);
    const glm::dvec3 expected = rayOnWall(wall, eye, point);
    const double tolerance_m = kOnWall_m * (1.0 + glm::length(expected));
    ASSERT_LT(glm::length(clipOnWall(wall, *fromEye * glm::dvec4(point - eye, 1.0)) - expected), tolerance_m);
    ASSERT_LT(glm::length(clipOnWall(wall, *fromRoom * glm::dvec4(point, 1.0)) - expected), tolerance_m);
  }
}

TEST(OffAxis, EveryWallAndEyeOfTheShippedRigsProjectsAsTheRayDoes) {
  test::Random random(5);
  for (const Rig& rig : shippedRigs()) {
    SCOPED_TRACE(rig.title);
    for (int i = 0; i < 10000; ++i) {
      const Eyes eyes = randomHead(random, rig);
      for (const Wall& wall : rig.walls) {
        for (const glm::dvec3& eye : {eyes.left_m, eyes.right_m}) {
          // Before the wall or behind it, seen within its edges.
          const glm::dvec3 expected = randomOnWall(random, wall);
          const glm::dvec3 point = eye + random.in(0.3, 20.0) * (expected - eye);
          const auto fromEye = clipFromEye(wall, eye);
          ASSERT_TRUE(fromEye) << wall.name << ", case " << i;
          const glm::dvec4 clip = *fromEye * glm::dvec4(point - eye, 1.0);
          ASSERT_LT(glm::length(clipOnWall(wall, clip) - rayOnWall(wall, eye, point)), kOnWall_m)
              << wall.name << ", case " << i;
          ASSERT_LT(glm::length(clipOnWall(wall, clip) - expected), kOnWall_m) << wall.name << ", case " << i;
        }
      }
    }
  }
}

TEST(OffAxis, CornersOfTheWallAreCornersOfThePicture) {
  const Wall wall = wallOf({-1.5, -1.5, 0}, {-1.5, 1.5, 0}, {-1.5, -1.5, 3});
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
  const glm::dvec3 eye(0.4, 0.2, 1.6);
  const ClipRange range{0.05, 60.0};
  const glm::dmat4 clip = *clipFromEye(kFront, eye, range);
  const glm::dvec4 nearest = clip * glm::dvec4(0.01, range.near_m, 0.02, 1.0);
  const glm::dvec4 farthest = clip * glm::dvec4(3.0, range.far_m, -2.0, 1.0);
  EXPECT_NEAR(nearest.z / nearest.w, -1.0, 1e-12);
  EXPECT_NEAR(farthest.z / farthest.w, 1.0, 1e-12);
  EXPECT_NEAR(farthest.w, range.far_m, 1e-12);
}

TEST(OffAxis, PointsOnTheWallsOfShippedRigsHaveNoParallaxForARolledHead) {
  test::Random random(2);
  for (const Rig& rig : shippedRigs()) {
    SCOPED_TRACE(rig.title);
    for (int i = 0; i < 10000; ++i) {
      const Eyes eyes = randomHead(random, rig);
      for (const Wall& wall : rig.walls) {
        const auto left = clipFromRoom(wall, eyes.left_m);
        const auto right = clipFromRoom(wall, eyes.right_m);
        ASSERT_TRUE(left && right) << wall.name << ", case " << i;
        const glm::dvec4 point(randomOnWall(random, wall), 1.0);
        const glm::dvec3 parallax = clipOnWall(wall, *right * point) - clipOnWall(wall, *left * point);
        ASSERT_LT(glm::length(parallax), kOnWall_m) << wall.name << ", case " << i;
      }
    }
  }
}

// A point s times as far as the wall has the parallax (1 − 1/s) of the eyes' distance, along their line:
// behind the wall (s > 1) uncrossed, in front (s < 1) crossed. Both eyes are equally far from the wall, the
// head rolled anyhow.
TEST(OffAxis, PointsBehindAreUncrossedAndInFrontCrossed) {
  test::Random random(3);
  for (const Rig& rig : shippedRigs()) {
    SCOPED_TRACE(rig.title);
    for (int i = 0; i < 10000; ++i) {
      const Eyes eyes = randomHead(random, rig);
      const glm::dvec3 head = 0.5 * (eyes.left_m + eyes.right_m);
      for (const Wall& wall : rig.walls) {
        const glm::dvec3 inWall = random.direction();
        const glm::dvec3 rightwards =
            glm::normalize(inWall - glm::dot(inWall, normalOf(wall)) * normalOf(wall));
        const glm::dvec3 half = 0.5 * rig.viewers.front().head.eyeSeparation_m * rightwards;
        const glm::dvec3 onWall = randomOnWall(random, wall);
        for (const double s : {random.in(0.5, 1.0), random.in(1.0, 20.0)}) {
          const glm::dvec4 point(head + s * (onWall - head), 1.0);
          const glm::dvec3 parallax = clipOnWall(wall, *clipFromRoom(wall, head + half) * point) -
                                      clipOnWall(wall, *clipFromRoom(wall, head - half) * point);
          ASSERT_LT(glm::length(parallax - (1.0 - 1.0 / s) * 2.0 * half), kOnWall_m)
              << wall.name << ", case " << i;
        }
      }
    }
  }
}

struct Edge {
  const Wall *a, *b;
  glm::dvec3 from_m, to_m;
};

/// The edges along which two walls of a rig meet.
std::vector<Edge> sharedEdges(const Rig& rig) {
  const auto corners = [](const Wall& wall) {
    return std::array{wall.lowerLeft_m, wall.lowerRight_m,
                      wall.lowerRight_m + wall.upperLeft_m - wall.lowerLeft_m, wall.upperLeft_m};
  };
  const auto same = [](const glm::dvec3& a, const glm::dvec3& b) { return glm::distance(a, b) < 1e-9; };
  std::vector<Edge> edges;
  for (std::size_t i = 0; i < rig.walls.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const auto one = corners(rig.walls[i]), other = corners(rig.walls[j]);
      for (std::size_t k = 0; k < 4; ++k) {
        for (std::size_t l = 0; l < 4; ++l) {
          const glm::dvec3 &p = one[k], &q = one[(k + 1) % 4], &r = other[l], &s = other[(l + 1) % 4];
          if ((same(p, r) && same(q, s)) || (same(p, s) && same(q, r)))
            edges.push_back({&rig.walls[i], &rig.walls[j], p, q});
        }
      }
    }
  }
  return edges;
}

// A point seen through the shared edge of two walls lights up the same physical place on both.
TEST(OffAxis, WallsOfShippedRigsMeetWithoutASeam) {
  test::Random random(4);
  std::size_t most = 0;
  for (Rig rig : shippedRigs()) {
    SCOPED_TRACE(rig.title);
    // Walls on the head; pictures by direction, which stand nowhere; pieces that overlap.
    if (isHeadset(rig) || rig.walls.empty() || rig.walls.front().piece > 0) continue;
    std::vector<Wall> screens;  // once each, however many walls of the rig are on them
    for (const Wall& wall : rig.walls) {
      const auto isThere = [&](const Wall& screen) { return standSame(screen, wall); };
      if (std::none_of(screens.begin(), screens.end(), isThere)) screens.push_back(wall);
    }
    rig.walls = screens;
    const std::vector<Edge> edges = sharedEdges(rig);
    // A corner of n walls that meet at each other in a box has more edges than walls, but for one wall alone.
    EXPECT_GE(edges.size() + 1, rig.walls.size());
    most = std::max(most, edges.size());
    for (int i = 0; i < 10000; ++i) {
      const Eyes eyes = randomHead(random, rig);
      for (const Edge& edge : edges) {
        for (const glm::dvec3& eye : {eyes.left_m, eyes.right_m}) {
          const glm::dvec3 onEdge = edge.from_m + random.in(0, 1) * (edge.to_m - edge.from_m);
          const glm::dvec4 seen((onEdge - eye) * random.in(0.3, 10.0), 1.0);
          const glm::dvec3 a = clipOnWall(*edge.a, *clipFromEye(*edge.a, eye) * seen);
          const glm::dvec3 b = clipOnWall(*edge.b, *clipFromEye(*edge.b, eye) * seen);
          ASSERT_LT(glm::length(a - b), kOnWall_m)
              << "case " << i << " edge of walls " << edge.a->name << ", " << edge.b->name;
          ASSERT_LT(glm::length(a - onEdge), kOnWall_m) << "case " << i;
        }
      }
    }
  }
  EXPECT_EQ(most, 8U) << "front, left, right, floor and ceiling meet along eight edges";
}

TEST(OffAxis, AnEyeOnOrBehindTheWallHasNoPicture) {
  const Wall wall = kFront;
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
