#include "engine/spacetime/minkowski.h"

#include <gtest/gtest.h>

#include "engine/random_world.h"

namespace carom {
namespace {

Vec21 randomVector(test::Random& random) {
  return {random.in(-3.0, 3.0), random.in(-3.0, 3.0), random.in(-3.0, 3.0)};
}

double determinant(const Vec21& d, const Vec21& a, const Vec21& b) {
  return d.t * (a.x * b.y - a.y * b.x) - d.x * (a.t * b.y - a.y * b.t) + d.y * (a.t * b.x - a.x * b.t);
}

TEST(Minkowski, TheCrossProductIsOrthogonalAndGivesTheDeterminant) {
  test::Random random(67);
  for (int i = 0; i < 500; ++i) {
    CASE(random, i);
    const Vec21 a = randomVector(random), b = randomVector(random), d = randomVector(random);
    const Vec21 n = cross(a, b);
    EXPECT_NEAR(dot(n, a), 0.0, 1e-12);
    EXPECT_NEAR(dot(n, b), 0.0, 1e-12);
    EXPECT_NEAR(dot(n, d), determinant(d, a, b), 1e-12);
  }
}

TEST(Minkowski, AFourVelocityHasTheLengthOne) {
  test::Random random(68);
  for (int i = 0; i < 500; ++i) {
    CASE(random, i);
    const Vec21 u = fourVelocity(random.in(-20.0, 20.0), random.in(-20.0, 20.0));
    EXPECT_NEAR(dot(u, u), 1.0, 1e-12 * u.t * u.t);
    EXPECT_GE(u.t, 1.0);
  }
}

}  // namespace
}  // namespace carom
