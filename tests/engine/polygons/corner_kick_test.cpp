// Kicks beside the centre: conservation, Newton's limit, discs, friction.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include <glm/vec2.hpp>

#include "engine/polygons/corner_kick.h"

namespace carom {
namespace {

using Vec2 = glm::dvec2;

// Written so that NaN fails.
#define EXPECT_WITHIN(value, expected, tolerance)            \
  EXPECT_TRUE(std::abs((value) - (expected)) <= (tolerance)) \
      << #value " = " << (value) << ", expected " << (expected)

Vec21 momentum(const LeveredBody& body, const Vec21& u, double j) { return u * restMass(body.puck.body, j); }

struct Drawn {
  std::array<LeveredBody, 2> bodies;
  Vec21 U, n;
  RimRules rules;
};

Drawn drawn(std::mt19937_64& random) {
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  Drawn made;
  for (LeveredBody& body : made.bodies) {
    const double mass = uniform(0.05, 0.5);
    body.puck = {{mass, mass * uniform(0.1, 1.0)},
                 mass * uniform(-1.0, 1.0),
                 fourVelocity(uniform(-2.0, 2.0), uniform(-2.0, 2.0))};
    body.radius = uniform(0.02, 0.08);
    body.lever = Vec21{0.1, 0.0, 0.0} + Vec21{0.0, uniform(-0.05, 0.05), uniform(-0.05, 0.05)};
  }
  const Vec21 sum = made.bodies[0].puck.u + made.bodies[1].puck.u;
  made.U = sum * (1.0 / std::sqrt(dot(sum, sum)));
  const double angle = uniform(0.0, 2.0 * M_PI);
  made.n = {0.0, std::cos(angle), std::sin(angle)};
  made.rules = {std::min(1.0, uniform(0.0, 2.0)), uniform(0.0, 1.0) < 0.5 ? 0.0 : uniform(0.0, 2.0),
                uniform(0.0, 1.0)};
  return made;
}

/// Expects that no heat is negative and that nothing of the four-momentum is missing but rounding.
void expectConserved(const Drawn& made, const SpinningPairKick& kick, double rounding) {
  Vec21 difference;
  for (int i = 0; i < 2; ++i) {
    const SpinningPuck& puck = made.bodies[i].puck;
    EXPECT_GE(kick.centres.heat[i], 0.0);
    difference =
        difference + momentum(made.bodies[i], puck.u, puck.j) -
        (momentum(made.bodies[i], kick.centres.u[i], kick.j[i]) + kick.centres.u[i] * kick.centres.heat[i]);
  }
  EXPECT_WITHIN(difference.t, 0.0, rounding);
  EXPECT_WITHIN(difference.x, 0.0, rounding);
  EXPECT_WITHIN(difference.y, 0.0, rounding);
}

TEST(CornerKick, ConservesFourMomentumWithHeat) {
  std::mt19937_64 random(1);
  int kicks = 0;
  for (int n = 0; n < 2000; ++n) {
    SCOPED_TRACE(n);
    const Drawn made = drawn(random);
    const auto kick = kickCorners(made.U, made.n, made.bodies, made.rules);
    if (!kick) continue;
    ++kicks;
    expectConserved(made, *kick, 1e-13);
  }
  EXPECT_GT(kicks, 500);
}

// Masses 1 : 100 000, rims and centres up to 0.999 c: what is missing is a share of the whole energy.
TEST(CornerKick, ConservesFourMomentumOverWideRanges) {
  std::mt19937_64 random(3);
  const auto decades = [&](double low, double high) {
    return std::pow(10.0, std::uniform_real_distribution<double>(low, high)(random));
  };
  int kicks = 0;
  for (int n = 0; n < 5000; ++n) {
    SCOPED_TRACE(n);
    Drawn made = drawn(random);
    double energy = 0.0;
    for (LeveredBody& body : made.bodies) {
      const double mass = decades(-3.0, 2.0), share = decades(-2.0, 0.0), fast = decades(-3.0, 1.3);
      body.puck.body = {mass, mass * share};
      body.puck.j = std::copysign(mass * share * decades(-3.0, 1.3), body.puck.j);
      const double way = body.puck.u.x > 0.0 ? 1.0 : -1.0;
      body.puck.u = fourVelocity(way * fast, body.puck.u.y);
      body.lever = body.lever - body.puck.u * dot(body.puck.u, body.lever);
      energy += restMass(body.puck.body, body.puck.j) * body.puck.u.t;
    }
    const Vec21 sum = made.bodies[0].puck.u + made.bodies[1].puck.u;
    made.U = sum * (1.0 / std::sqrt(dot(sum, sum)));
    if (n % 2 == 0) made.rules = {};
    const auto kick = kickCorners(made.U, made.n, made.bodies, made.rules);
    if (!kick) continue;
    ++kicks;
    expectConserved(made, *kick, 1e-12 * energy);
  }
  EXPECT_GT(kicks, 1500);
}

// Levers through the centre are discs, and the law is that of kick.h.
TEST(CornerKick, WithoutLeversItIsTheKickOfDiscs) {
  std::mt19937_64 random(2);
  for (int n = 0; n < 500; ++n) {
    SCOPED_TRACE(n);
    Drawn made = drawn(random);
    made.rules.friction = 0.0, made.rules.restitution = 1.0;
    std::array<double, 2> mass;
    for (int i = 0; i < 2; ++i) {
      LeveredBody& body = made.bodies[i];
      body.puck.j = 0.0, mass[i] = body.puck.body.mass;
    }
    const Vec21 P = made.bodies[0].puck.u * mass[0] + made.bodies[1].puck.u * mass[1];
    const Vec21 k = made.n - made.U * (dot(made.n, P) / dot(made.U, P));
    made.bodies[0].lever = k * 0.03, made.bodies[1].lever = k * -0.03;
    const auto discs = kickPair(made.U, made.n, {made.bodies[0].puck.u, made.bodies[1].puck.u}, mass, 1.0);
    const auto kick = kickCorners(made.U, made.n, made.bodies, made.rules);
    ASSERT_EQ(discs.has_value(), kick.has_value());
    if (!kick) continue;
    // k is a lever without a moment only for equal directions; the determinant is 0 to rounding.
    for (int i = 0; i < 2; ++i) {
      EXPECT_WITHIN(kick->centres.u[i].x, discs->u[i].x, 1e-13);
      EXPECT_WITHIN(kick->centres.u[i].y, discs->u[i].y, 1e-13);
      EXPECT_WITHIN(kick->j[i], 0.0, 1e-14);
    }
  }
}

// A slow point mass m on the end of a free bar M at rest, of half length a and I = M a²/3, elastic:
//   q = 2 v / (1/m + 1/M + a²/I)     v' = v − q/m     V = q/M     Ω = q a/I
TEST(CornerKick, PointOnTheEndOfABarAsNewtonHasIt) {
  const double v = 1e-5, m = 0.1, M = 0.3, a = 0.06, I = M * a * a / 3.0;
  const LeveredBody point{{{m, 0.5 * m}, 0.0, fourVelocity(0.0, v)}, 1e-3, {0.0, 0.0, 0.0}};
  const LeveredBody bar{{{M, I / (a * a)}, 0.0, fourVelocity(0.0, 0.0)}, a, {0.0, a, 0.0}};
  const Vec21 U = fourVelocity(0.0, 0.5 * v);
  const auto kick = kickCorners(U, {0.0, 0.0, 1.0}, {point, bar}, {});
  ASSERT_TRUE(kick);
  const double q = 2.0 * v / (1.0 / m + 1.0 / M + a * a / I);
  EXPECT_WITHIN(kick->centres.u[0].y, v - q / m, 1e-9 * v);
  EXPECT_WITHIN(kick->centres.u[1].y, q / M, 1e-9 * v);
  EXPECT_WITHIN(rimBeta(bar.puck.body, kick->j[1]) / a, q * a / I, 1e-9 * v / a);
  EXPECT_WITHIN(kick->centres.heat[0] + kick->centres.heat[1], 0.0, 0.0);
  EXPECT_WITHIN(kick->centres.closing, v, 1e-9 * v);
}

TEST(CornerKick, RoughSidesStickAtLowSpeedAsNewtonHasIt) {
  // A block slides over a cushion and falls on it, no slip afterwards: the corner's speed along it is 0.
  const double vn = 1e-5, vt = 2e-5, m = 0.2, R = 0.05, I = 0.4 * m * R * R;
  const CushionPlane cushion{1, -1.0, 0.5};
  const LeveredBody block{{{m, I / (R * R)}, 0.0, fourVelocity(vt, -vn)}, R, {0.0, 0.03, -0.04}};
  const RimRules rough{1.0, 1e9, 0.0};
  const auto kick = kickCornerOffCushion(cushion, block, rough);
  ASSERT_TRUE(kick);
  const double omega = rimBeta(block.puck.body, kick->j) / R;
  EXPECT_WITHIN(kick->centre.u.x - omega * block.lever.y, 0.0, 1e-9 * vt);
  const double energy = 0.5 * m * (vn * vn + vt * vt);
  const Vec21& u = kick->centre.u;
  EXPECT_WITHIN(0.5 * m * (u.x * u.x + u.y * u.y) + 0.5 * I * omega * omega + kick->centre.heat, energy,
                1e-6 * energy);
  // Coulomb's limit.
  const auto slides = kickCornerOffCushion(cushion, block, {1.0, 0.01, 0.0});
  ASSERT_TRUE(slides);
  EXPECT_WITHIN(vt - slides->centre.u.x, 0.01 * (slides->centre.u.y + vn), 1e-9 * vt);
}

// In one frame with light faster and faster: the heat over c² is what Newton's bodies lose, to (v/c)² and
// rounding. A difference of masses would have only rounding left.
TEST(CornerKick, HeatKeepsItsDigitsWhereLightIsFast) {
  for (const double c : {1e4, 1e6, 1e7, 1e8}) {
    const double beta = 1.0 / c, mass = 0.2, radius = 0.06, lever = 0.05, e = 0.5;
    const SpinningBody material{mass, 0.3 * mass};
    std::array<LeveredBody, 2> bodies;
    for (int i = 0; i < 2; ++i) {
      bodies[i].puck = {material, 0.0, fourVelocity(i == 0 ? beta : -beta, 0.0)};
      bodies[i].radius = radius;
      bodies[i].lever = {0.0, i == 0 ? 0.02 : -0.02, i == 0 ? lever : -lever};
    }
    const auto kick = kickCorners({1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, bodies, RimRules{e});
    ASSERT_TRUE(kick);
    // (1 − e²)/2 μ w², w = 2 v the closing speed and 1/μ = 2 (1/m + lever²/(k m R²)).
    const double perImpulse = 2.0 * (1.0 + lever * lever / (0.3 * radius * radius)) / mass;
    const double newton = 0.5 * (1.0 - e * e) * 4.0 * beta * beta / perImpulse;
    const double heat = kick->centres.heat[0] + kick->centres.heat[1];
    EXPECT_WITHIN(heat / newton, 1.0, 10.0 * beta * beta + 1e-13) << c;
  }
}

// What slides gets the tangential impulse μ times the normal one, whatever the restitution; less only where
// less makes the sides stick or, with tangential restitution, turn back as they should: as much as without a
// limit.
TEST(CornerKick, SlidingImpulseIsCoulombsShareOfTheNormalOne) {
  constexpr double kSlow = 1e-5;
  std::mt19937_64 random(4);
  int slid = 0, stuck = 0;
  for (int n = 0; n < 1000; ++n) {
    SCOPED_TRACE("seed 4, pair " + std::to_string(n));
    Drawn made = drawn(random);
    for (LeveredBody& body : made.bodies) {
      body.puck.j *= kSlow;
      body.puck.u = fourVelocity(body.puck.u.x * kSlow, body.puck.u.y * kSlow);
    }
    made.U = {1.0, 0.0, 0.0};
    made.rules.friction = 0.02 + 0.5 * made.rules.tangentialRestitution;
    const Vec2 k{made.n.x, made.n.y}, t{-k.y, k.x};
    const auto impulseOf = [&](const RimRules& rules) {
      const auto kick = kickCorners(made.U, made.n, made.bodies, rules);
      if (!kick) return Vec2{0.0};
      const LeveredBody& body = made.bodies[0];
      const Vec21 q =
          momentum(body, kick->centres.u[0], kick->j[0]) - momentum(body, body.puck.u, body.puck.j);
      return Vec2{k.x * q.x + k.y * q.y, t.x * q.x + t.y * q.y};
    };
    RimRules unlimited = made.rules;
    unlimited.friction = 1e9;
    const Vec2 given = impulseOf(made.rules), wanted = impulseOf(unlimited);
    if (given.x == 0.0) continue;
    const double limit = made.rules.friction * std::abs(given.x);
    EXPECT_WITHIN(given.x, wanted.x, 1e-4 * std::abs(wanted.x));
    EXPECT_WITHIN(std::abs(given.y), std::min(limit, std::abs(wanted.y)), 1e-4 * std::abs(given.x));
    ++(std::abs(wanted.y) > limit ? slid : stuck);
  }
  EXPECT_GT(slid, 100);
  EXPECT_GT(stuck, 50);
}

}  // namespace
}  // namespace carom
