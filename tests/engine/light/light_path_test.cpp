// Where a pulse of light is seen on its way, against bisection of the past cone's equation.
#include "engine/light/light_path.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "engine/light_speed.h"
#include "engine/random_world.h"

namespace carom {
namespace {

using test::kC_m_s;

std::vector<Vec3> randomPath(test::Random& random) {
  std::vector<Vec3> path_m;
  const int places = 2 + static_cast<int>(random.in(0.0, 4.0));
  for (int i = 0; i < places; ++i) path_m.push_back(random.inBox(2.0));
  return path_m;
}

// Light that left the path at s after c s reaches the eye when c (t_o − t_0) − s = |r_o − r(s)|.
TEST(LightOnItsWay, IsSeenWhereItsLightReachesTheEye) {
  test::Random random(81);
  int onTheWay = 0;
  for (int i = 0; i < 3000; ++i) {
    CASE(random, i);
    const std::vector<Vec3> path_m = randomPath(random);
    const double start_s = random.in(-3.0, 3.0), length_m = lengthOf(path_m);
    const Event eye{start_s + random.in(-1.0, 8.0), random.inBox(2.0)};
    double from_m = 0.0, to_m = length_m;
    for (int k = 0; k < 60; ++k) {
      const double s = 0.5 * (from_m + to_m);
      const double arrives_s = start_s + (s + glm::distance(eye.r_m, placeAlong(path_m, s))) / kC_m_s;
      (arrives_s < eye.t_s ? from_m : to_m) = s;
    }
    const double seen_m = seenAlong_m(start_s, path_m, eye, kC_m_s);
    ASSERT_NEAR(seen_m, from_m, 1e-7)
        << "case " << i << ": " << path_m.size() << " places, eye at " << eye.t_s - start_s << " s, "
        << eye.r_m.x << ' ' << eye.r_m.y << ' ' << eye.r_m.z;
    onTheWay += seen_m > 0.0 && seen_m < length_m ? 1 : 0;
  }
  EXPECT_GT(onTheWay, 1000);
}

// The light has reached the moving point when |r + β c s − r_e| = c (t + s − t_e): bisected in s.
TEST(LightOnItsWay, MeetsAPointThatMovesOn) {
  test::Random random(83);
  for (int i = 0; i < 2000; ++i) {
    CASE(random, i);
    const Event from{random.in(-2.0, 2.0), random.inBox(2.0)};
    const Event at{from.t_s + random.in(-0.5, 2.0), random.inBox(2.0)};
    const Vec3 beta = random.direction() * random.in(0.0, 0.95);
    const auto isShort = [&](double s) {
      return kC_m_s * (at.t_s + s - from.t_s) < glm::distance(at.r_m + kC_m_s * s * beta, from.r_m);
    };
    double low_s = 0.0, high_s = 1e3;
    for (int k = 0; k < 80; ++k) {
      const double s = 0.5 * (low_s + high_s);
      (isShort(s) ? low_s : high_s) = s;
    }
    const Event met = lightMeets(from, at, beta, kC_m_s);
    ASSERT_NEAR(met.t_s - at.t_s, low_s, 1e-10 * (1.0 + low_s));
    ASSERT_LT(glm::distance(met.r_m, at.r_m + kC_m_s * (met.t_s - at.t_s) * beta), 1e-12);
  }
}

TEST(LightOnItsWay, SeenFromItsStartGoesAtHalfItsSpeed) {
  const std::array<Vec3, 2> path_m{{{0, 0, 0}, {2, 0, 0}}};
  for (const double t_s : {0.5, 1.0, 2.0})
    EXPECT_NEAR(seenAlong_m(0.0, path_m, {t_s, {0, 0, 0}}, kC_m_s), 0.5 * kC_m_s * t_s, 1e-12);
}

TEST(LightOnItsWay, ThatRunsStraightAtTheEyeIsNotSeenBeforeItIsThere) {
  const std::array<Vec3, 2> path_m{{{0, 0, 0}, {1, 0, 0}}};
  const double arrives_s = 1.0 / kC_m_s;
  EXPECT_EQ(seenAlong_m(0.0, path_m, {arrives_s * (1.0 - 1e-9), {1, 0, 0}}, kC_m_s), 0.0);
  EXPECT_NEAR(seenAlong_m(0.0, path_m, {arrives_s * (1.0 + 1e-9), {1, 0, 0}}, kC_m_s), 1.0, 1e-6);
  EXPECT_EQ(seenAlong_m(0.0, path_m, {1.0, {1, 0, 0}}, 1.0), 1.0) << "at that very moment, all of it";
}

TEST(LightOnItsWay, StaysOnItsPath) {
  const std::array<Vec3, 4> path_m{{{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {1, 2, 0}}};  // a place twice
  EXPECT_EQ(lengthOf(path_m), 3.0);
  EXPECT_EQ(placeAlong(path_m, -1.0), Vec3(0.0));
  EXPECT_EQ(placeAlong(path_m, 2.0), Vec3(1, 1, 0));
  EXPECT_EQ(placeAlong(path_m, 9.0), Vec3(1, 2, 0));
  EXPECT_EQ(reached_m(1.0, path_m, 0.5, 2.0), 0.0);
  EXPECT_EQ(reached_m(1.0, path_m, 2.0, 2.0), 2.0);
  EXPECT_EQ(reached_m(1.0, path_m, 9.0, 2.0), 3.0);
  EXPECT_NEAR(seenAlong_m(0.0, path_m, {4.0, {1, -1, 0}}, 1.0), 2.0, 1e-12)
      << "1 m after the corner, 2 m away";
  EXPECT_EQ(seenAlong_m(0.0, path_m, {99.0, {1, -1, 0}}, 1.0), 3.0);
}

}  // namespace
}  // namespace carom
