#include "engine/collision/kick.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/random_world.h"

namespace carom {
namespace {

using test::Random;

constexpr double kKickRounding = 1e-12;  // of momenta of order 1 to 10, times γ

Vec21 fourVelocityBelow(Random& random, double beta) {
  const double b = random.in(0.0, beta), angle = random.in(0.0, 2.0 * std::numbers::pi);
  const double u = b / std::sqrt(1.0 - b * b);
  return fourVelocity(u * std::cos(angle), u * std::sin(angle));
}

// For any normal: four-momentum with the heat is conserved; elastic kicks make no heat; the velocity along
// the normal, in the centre-of-mass frame, becomes −e times what it was, and across it stays in the momenta.
TEST(Kick, pairConservesAndReflects) {
  const auto size = [](const Vec21& p) { return std::abs(p.t) + std::abs(p.x) + std::abs(p.y); };
  Random random(11);
  for (int i = 0; i < 2000; ++i) {
    CASE(random, i);
    const Vec21 u1 = fourVelocityBelow(random, 0.99), u2 = fourVelocityBelow(random, 0.99);
    const std::array<double, 2> mass{random.in(0.1, 5.0), random.in(0.1, 5.0)};
    const Vec21 U = (u1 + u2) * (1.0 / std::sqrt(dot(u1 + u2, u1 + u2)));
    const Vec21 any = fourVelocityBelow(random, 0.9);
    const Vec21 n = cross(U, any);
    const double e = random.in(0.0, 1.0);
    const auto elastic = kickPair(U, n, {u1, u2}, mass, 1.0), lossy = kickPair(U, n, {u1, u2}, mass, e);
    const auto opposite = kickPair(U, n * -1.0, {u1, u2}, mass, 1.0);
    ASSERT_NE(static_cast<bool>(elastic), static_cast<bool>(opposite));  // they approach along n or along −n
    if (!elastic) continue;
    const Vec21 before = u1 * mass[0] + u2 * mass[1];
    const double tolerance = kKickRounding * size(before) * size(before);
    const auto momentum = [&](const PairKick& kick, int k) { return kick.u[k] * (mass[k] + kick.heat[k]); };
    for (const auto& kick : {elastic, lossy}) {
      EXPECT_TRUE(size(momentum(*kick, 0) + momentum(*kick, 1) - before) <= tolerance);
    }
    EXPECT_EQ(elastic->heat[0], 0.0);
    EXPECT_GE(lossy->heat[0], 0.0);
    // k is n without its part along the total momentum: spatial in the centre-of-mass frame.
    const Vec21 k = n - U * (dot(n, before) / dot(U, before));
    const double closing = dot(u1 * mass[0], k), opening = dot(momentum(*lossy, 0), k);
    EXPECT_TRUE(std::abs(opening + e * closing) <= tolerance * size(k));
    const Vec21 impulse = momentum(*lossy, 0) - u1 * mass[0];
    EXPECT_TRUE(size(impulse * dot(k, k) - k * dot(impulse, k)) <= tolerance * size(k) * size(k) * size(k));
  }
}

TEST(Kick, cushionReversesTheNormalVelocity) {
  Random random(11);
  for (int i = 0; i < 2000; ++i) {
    CASE(random, i);
    const CushionPlane plane{i % 2, i % 4 < 2 ? 1.0 : -1.0, 1.0};
    const Vec21 u = fourVelocityBelow(random, 0.999);
    const double e = random.in(0.0, 1.0), mass = random.in(0.1, 5.0);
    const auto kick = kickOffCushion(plane, u, mass, e);
    ASSERT_EQ(static_cast<bool>(kick), plane.towards(u) > 0.0);
    if (!kick) continue;
    const auto tangential = [&](const Vec21& v) { return (plane.axis == 0 ? v.y : v.x) / v.t; };
    EXPECT_TRUE(std::abs(plane.towards(kick->u) / kick->u.t + e * plane.towards(u) / u.t) <= kKickRounding);
    EXPECT_TRUE(std::abs(tangential(kick->u) - tangential(u)) <= kKickRounding);
    // The cushion takes no energy: it stays in the puck, as motion and as heat.
    EXPECT_TRUE(std::abs((mass + kick->heat) * kick->u.t - mass * u.t) <= kKickRounding * mass * u.t);
  }
}

}  // namespace
}  // namespace carom
