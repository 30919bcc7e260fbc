// Balls, boxes and rods: closed, right side out, of the volume that geometry gives them.
#include "engine/sculpture/solid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/random_world.h"
#include "engine/sculpture/closed.h"

namespace carom {
namespace {

TEST(Solid, ABoxHasItsVolume) {
  const SolidMesh solid = box({1.0, -2.0, 0.5}, {3.0, 1.0, 0.75});
  EXPECT_EQ(test::openEdges(solid), 0);
  EXPECT_NEAR(volume_m3(solid), 2.0 * 3.0 * 0.25, 1e-12);
}

// A ball of 128 triangles lies inside the sphere, and has over nine tenths of its volume.
TEST(Solid, ABallIsNearlyASphere) {
  const Vec3 middle_m(1.0, 2.0, 3.0);
  const SolidMesh solid = ball(middle_m, 0.5);
  EXPECT_EQ(test::openEdges(solid), 0);
  for (const Vec3& point : solid.points) EXPECT_NEAR(glm::distance(point, middle_m), 0.5, 1e-12);
  const double sphere = 4.0 / 3.0 * std::numbers::pi * 0.125;
  EXPECT_GT(volume_m3(solid), 0.9 * sphere);
  EXPECT_LT(volume_m3(solid), sphere);
}

// V = A × length for a straight rod whose section is a regular octagon, A = 2√2 r². The planes in which a
// bent one is joined take from one side of the path what they give the other: V = A × length of the path
// again.
TEST(Solid, ARodHasTheVolumeOfItsPath) {
  test::Random random(36);
  for (int i = 0; i < 200; ++i) {
    CASE(random, i);
    std::vector<Vec3> path_m{random.inBox(1.0)};
    double length_m = 0.0;
    Vec3 along = glm::normalize(random.inBox(1.0));
    for (int k = 0; k < 1 + i % 4; ++k) {
      const Vec3 turned = along + random.inBox(0.4);
      along = glm::normalize(turned);
      const double step_m = random.in(0.3, 1.0);
      path_m.push_back(path_m.back() + along * step_m);
      length_m += step_m;
    }
    const double radius_m = random.in(0.001, 0.02);
    const SolidMesh solid = rod(path_m, radius_m);
    EXPECT_EQ(test::openEdges(solid), 0);
    EXPECT_NEAR(volume_m3(solid), 2.0 * std::numbers::sqrt2 * radius_m * radius_m * length_m,
                1e-9 * length_m * radius_m);
  }
}

}  // namespace
}  // namespace carom
