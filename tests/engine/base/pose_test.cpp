#include "engine/base/pose.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>

#include "engine/random_world.h"

namespace carom {
namespace {

Pose randomPose(test::Random& random) {
  return {random.inBox(3.0), glm::angleAxis(random.in(-3.0, 3.0), random.direction())};
}

// By 4 × 4 matrices.
glm::dmat4 matrixOf(const Pose& pose) {
  return glm::translate(glm::dmat4(1.0), pose.position_m) * glm::mat4_cast(pose.orientation);
}

TEST(Pose, ActsComposesAndInvertsAsMatricesDo) {
  test::Random random(52);
  for (int i = 0; i < 300; ++i) {
    CASE(random, i);
    const Pose one = randomPose(random), other = randomPose(random);
    const Vec3 point_m = random.inBox(5.0);
    const glm::dmat4 product = matrixOf(one) * matrixOf(other);
    EXPECT_LT(glm::length(one * (other * point_m) - Vec3(product * glm::dvec4(point_m, 1.0))), 1e-13);
    EXPECT_LT(glm::length((one * other) * point_m - one * (other * point_m)), 1e-13);
    EXPECT_LT(
        glm::length(inverse(one) * point_m - Vec3(glm::inverse(matrixOf(one)) * glm::dvec4(point_m, 1.0))),
        1e-12);
    EXPECT_LT(glm::length(inverse(one) * (one * point_m) - point_m), 1e-13);
    EXPECT_NEAR(glm::length((one * other).orientation), 1.0, 1e-15);
  }
}

TEST(Pose, APersonsDirectionsAreARightHandedFrame) {
  const RoomAxes axes;
  EXPECT_EQ(glm::cross(axes.right, axes.up), -axes.forward);
}

}  // namespace
}  // namespace carom
