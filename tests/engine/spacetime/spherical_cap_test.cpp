#include "engine/spacetime/spherical_cap.h"

#include <gtest/gtest.h>

#include <cmath>

#include <glm/geometric.hpp>

#include "engine/random_world.h"
#include "engine/spacetime/lorentz.h"

namespace carom {
namespace {

// Points of the sphere are seen within the cap, and points of its edge at the cap's edge: in its rest frame
// and, by aberration of each ray, in any other.
TEST(SphericalCap, HoldsEveryRayOfTheSphere) {
  test::Random random(66);
  for (int i = 0; i < 300; ++i) {
    CASE(random, i);
    const double radius_m = random.in(0.05, 1.0);
    const Vec3 middle_m = random.direction() * random.in(1.05, 10.0) * radius_m;
    const SphericalCap cap = capOfSphere(middle_m, radius_m);
    const Lorentz other = Lorentz::boost(random.u(0.99), 1.0);
    const SphericalCap moved = carried(cap, other.matrix());
    EXPECT_NEAR(cap.cosine * cap.cosine + cap.sine * cap.sine, 1.0, 1e-12);
    double least = 2.0;
    for (int k = 0; k < 200; ++k) {
      const Vec3 way = glm::normalize(middle_m + random.direction() * radius_m);
      // Light that arrives from `way` left earlier: (−1, way).
      const Displacement ray = other * Displacement{-1.0, way};
      const Vec3 seen = glm::normalize(ray.dr_m);
      EXPECT_GE(glm::dot(way, cap.axis), cap.cosine - 1e-9);
      EXPECT_GE(glm::dot(seen, moved.axis), moved.cosine - 1e-9);
      least = std::min(least, glm::dot(seen, moved.axis));
    }
    // The edge: at right angles to the way that touches.
    const Vec3 axis = glm::normalize(middle_m);
    const Vec3 aside = glm::normalize(glm::cross(axis, random.direction()));
    const Vec3 edge = axis * cap.cosine + aside * cap.sine;
    const Vec3 seen = glm::normalize((other * Displacement{-1.0, edge}).dr_m);
    EXPECT_NEAR(glm::dot(seen, moved.axis), moved.cosine, 1e-6);
    EXPECT_LE(moved.cosine, least + 1e-9);
  }
}

TEST(SphericalCap, InTheSphereItIsTheWholeSky) {
  const SphericalCap cap = capOfSphere({0.1, 0.0, 0.0}, 0.2);
  EXPECT_TRUE(cap.isWholeSky());
  EXPECT_TRUE(carried(cap, Lorentz::boost({1.0, 0.0, 0.0}, 1.0).matrix()).isWholeSky());
  EXPECT_NEAR(capOfSphere({0.0, 3.0, 0.0}, 1.0).nearest_m, 2.0, 1e-12);
}

}  // namespace
}  // namespace carom
