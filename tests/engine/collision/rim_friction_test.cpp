#include "engine/collision/rim_friction.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "engine/random_world.h"

namespace carom {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

class RandomPucks : public test::Random {
 public:
  using test::Random::Random;
  /// Up to 0.999 c, slow ones and nearly the fastest ones often.
  double beta() { return in(0.0, 1.0) < 0.3 ? 0.999 - in(0.0, 0.05) : 0.999 * in(0.0, 1.0) * in(0.0, 1.0); }
  SpinningPuck puck() {
    const double mass = in(0.1, 5.0), angle = in(0.0, 2.0 * std::numbers::pi), b = beta();
    const double u = b / std::sqrt(1.0 - b * b);
    SpinningPuck puck{
        {mass, mass * in(0.01, 1.0)}, 0.0, fourVelocity(u * std::cos(angle), u * std::sin(angle))};
    puck.j = in(0.0, 1.0) < 0.2 ? 0.0 : spinOfRim(puck.body, in(0.0, 1.0) < 0.5 ? beta() : -beta());
    return puck;
  }
  RimRules rules() {
    const double kind = in(0.0, 1.0);
    return {in(0.0, 1.0) < 0.3 ? 1.0 : in(0.0, 1.0), kind < 0.3 ? kInfinity : in(0.0, 2.0),
            in(0.0, 1.0) < 0.3 ? std::floor(in(0.0, 2.0)) : in(0.0, 1.0)};
  }
};

double size(const Vec21& p) { return std::abs(p.t) + std::abs(p.x) + std::abs(p.y); }

/// Four-momentum with the heat that the kick left.
Vec21 momentum(const SpinningPuck& puck, const Vec21& u, double j, double heat) {
  return u * (restMass(puck.body, j) + heat);
}
Vec21 momentum(const SpinningPuck& puck) { return momentum(puck, puck.u, puck.j, 0.0); }

/// Two pucks, and the geometry of a contact between them.
struct SpinningPair {
  std::array<SpinningPuck, 2> pucks;
  Vec21 U, n;
};

/// Half of these pairs approach.
SpinningPair randomSpinningPair(RandomPucks& random) {
  SpinningPair pair{{random.puck(), random.puck()}, {}, {}};
  const Vec21 sum = pair.pucks[0].u + pair.pucks[1].u;
  pair.U = sum * (1.0 / std::sqrt(dot(sum, sum)));
  const double angle = random.in(0.0, 2.0 * std::numbers::pi);
  pair.n = cross(pair.U, fourVelocity(std::cos(angle), std::sin(angle)));
  return pair;
}

/// The axes of a contact in the centre-of-mass frame.
struct Axes {
  Vec21 centre, k, t;
};

Axes axesOf(const SpinningPair& pair) {
  const Vec21 P = momentum(pair.pucks[0]) + momentum(pair.pucks[1]);
  Vec21 k = pair.n - pair.U * (dot(pair.n, P) / dot(pair.U, P));
  k = k * (1.0 / std::sqrt(-dot(k, k)));
  const Vec21 centre = P * (1.0 / std::sqrt(dot(P, P)));
  return {centre, k, cross(k, centre)};
}

/// The four-velocity of the point of the rim that touches, where `normal` is the wall's: the puck's own
/// axis along the rim is orthogonal to its velocity and to the normal.
Vec21 rimVelocity(const SpinningBody& body, double j, const Vec21& u, const Vec21& normal) {
  const Vec21 along = cross(normal, u);
  const double f = rimBeta(body, j);
  return (u + along * (f / std::sqrt(-dot(along, along)))) * (1.0 / std::sqrt(1.0 - f * f));
}

TEST(RimFriction, APairKeepsItsFourMomentumWithTheHeat) {
  RandomPucks random(1);
  int kicked = 0;
  for (int i = 0; i < 20000; ++i) {
    CASE(random, i);
    const SpinningPair pair = randomSpinningPair(random);
    const RimRules rules = random.rules();
    const auto kick = kickSpinningPair(pair.U, pair.n, pair.pucks, rules);
    if (!kick) continue;
    ++kicked;
    const Vec21 before = momentum(pair.pucks[0]) + momentum(pair.pucks[1]);
    Vec21 after;
    for (int k = 0; k < 2; ++k) {
      after = after + momentum(pair.pucks[k], kick->centres.u[k], kick->j[k], kick->centres.heat[k]);
      EXPECT_GE(kick->centres.heat[k], 0.0);
    }
    EXPECT_TRUE(size(after - before) <= 1e-12 * size(before)) << size(after - before) / size(before);
  }
  EXPECT_GT(kicked, 8000);
}

// χ − j/E of a puck in the frame of the patch stays the same, and so does its energy there. In the frame of
// the wall the normal velocity becomes −e times what it was; the tangential impulse is within Coulomb's
// limit.
TEST(RimFriction, ACushionTurnsByTheImpulseAtTheRim) {
  RandomPucks random(2);
  for (int i = 0; i < 20000; ++i) {
    CASE(random, i);
    const CushionPlane plane{i % 2, i % 4 < 2 ? 1.0 : -1.0, 1.0};
    const SpinningPuck puck = random.puck();
    const RimRules rules = random.rules();
    const auto kick = kickSpinningOffCushion(plane, puck, rules);
    ASSERT_EQ(static_cast<bool>(kick), plane.towards(puck.u) > 0.0);
    if (!kick) continue;
    const Vec21 before = momentum(puck), after = momentum(puck, kick->centre.u, kick->j, kick->centre.heat);
    const double E = before.t, rounding = 1e-12 * E;
    EXPECT_NEAR(after.t, E, rounding);
    EXPECT_NEAR(plane.towards(after), -rules.restitution * plane.towards(before), rounding);
    EXPECT_GE(kick->centre.heat, 0.0);
    // With the wall's normal as n, anticlockwise from it is t.
    const auto along = [&](const Vec21& p) { return plane.sign * (plane.axis == 0 ? p.y : -p.x); };
    const double turned = std::asin(along(after) / E) - std::asin(along(before) / E);
    EXPECT_NEAR(kick->j - puck.j, E * turned, 30.0 * rounding);  // asin is steep near c
    EXPECT_LT(std::abs(turned), 1.48) << "no kick turns a puck by a right angle";
    EXPECT_LE(std::abs(along(after) - along(before)),
              rules.friction * (1.0 + rules.restitution) * plane.towards(before) + rounding);
  }
}

// Without slip the touching points of both rims move with the patch, and the touching point rests on a
// cushion.
TEST(RimFriction, RimsThatDoNotSlideRestOnEachOther) {
  RandomPucks random(3);
  for (int i = 0; i < 5000; ++i) {
    CASE(random, i);
    const RimRules rules{random.in(0.0, 1.0), kInfinity, 0.0};
    const SpinningPuck puck = random.puck();
    if (const auto kick = kickSpinningOffCushion({0, 1.0, 1.0}, puck, rules)) {
      const Vec21 rim = rimVelocity(puck.body, kick->j, kick->centre.u, {0.0, 1.0, 0.0});
      EXPECT_NEAR(rim.y, 0.0, 1e-9 * kick->centre.u.t);
    }
    const SpinningPair pair = randomSpinningPair(random);
    const auto kick = kickSpinningPair(pair.U, pair.n, pair.pucks, rules);
    if (!kick) continue;
    const Axes axes = axesOf(pair);
    std::array<double, 2> patch{};
    for (int k = 0; k < 2; ++k) {
      const Vec21 normal = k == 0 ? axes.k : axes.k * -1.0;
      const Vec21 rim = rimVelocity(pair.pucks[k].body, kick->j[k], kick->centres.u[k], normal);
      patch[k] = -dot(rim, axes.t) / dot(rim, axes.centre);
    }
    EXPECT_NEAR(patch[0], patch[1], 1e-9 * axes.centre.t * axes.centre.t);
  }
}

Vec21 mirrored(const Vec21& v) { return {v.t, v.x, -v.y}; }
SpinningPuck mirrored(const SpinningPuck& puck) { return {puck.body, -puck.j, mirrored(puck.u)}; }

// Mirror images are kicked to mirror images, whose spins have the other sign; and which puck is the first
// does not matter.
TEST(RimFriction, HasTheSymmetriesOfAPair) {
  RandomPucks random(4);
  for (int i = 0; i < 10000; ++i) {
    CASE(random, i);
    const SpinningPair pair = randomSpinningPair(random);
    const RimRules rules = random.rules();
    const auto kick = kickSpinningPair(pair.U, pair.n, pair.pucks, rules);
    const auto mirror = kickSpinningPair(mirrored(pair.U), mirrored(pair.n),
                                         {mirrored(pair.pucks[0]), mirrored(pair.pucks[1])}, rules);
    const auto exchanged = kickSpinningPair(pair.U, pair.n * -1.0, {pair.pucks[1], pair.pucks[0]}, rules);
    ASSERT_EQ(static_cast<bool>(kick), static_cast<bool>(mirror));
    ASSERT_EQ(static_cast<bool>(kick), static_cast<bool>(exchanged));
    if (!kick) continue;
    const double energy = size(momentum(pair.pucks[0]) + momentum(pair.pucks[1]));
    for (int k = 0; k < 2; ++k) {
      const SpinningPuck& puck = pair.pucks[k];
      const Vec21 p = momentum(puck, kick->centres.u[k], kick->j[k], kick->centres.heat[k]);
      const Vec21 seenInMirror =
          momentum(mirrored(puck), mirror->centres.u[k], mirror->j[k], mirror->centres.heat[k]);
      const int other = 1 - k;
      const Vec21 asOther =
          momentum(puck, exchanged->centres.u[other], exchanged->j[other], exchanged->centres.heat[other]);
      // The spin follows from the steep end of asin where a puck moves along the patch at nearly c.
      EXPECT_TRUE(size(mirrored(p) - seenInMirror) <= 1e-10 * energy) << size(mirrored(p) - seenInMirror);
      EXPECT_TRUE(size(p - asOther) <= 1e-10 * energy) << size(p - asOther);
      EXPECT_NEAR(mirror->j[k], -kick->j[k], 1e-10 * energy);
      EXPECT_NEAR(exchanged->j[other], kick->j[k], 1e-10 * energy);
    }
  }
}

// An elastic rough kick makes no heat, and turned back in time it gives the start.
TEST(RimFriction, AnElasticKickIsReversible) {
  RandomPucks random(5);
  const RimRules elastic{1.0, kInfinity, 1.0};
  const CushionPlane plane{0, 1.0, 1.0};
  for (int i = 0; i < 5000; ++i) {
    CASE(random, i);
    const SpinningPuck puck = random.puck();
    const auto kick = kickSpinningOffCushion(plane, puck, elastic);
    if (!kick) continue;
    const double energy = momentum(puck).t;
    EXPECT_NEAR(kick->centre.heat, 0.0, 1e-11 * energy);
    const SpinningPuck back{puck.body, -kick->j, {kick->centre.u.t, -kick->centre.u.x, -kick->centre.u.y}};
    const auto again = kickSpinningOffCushion(plane, back, elastic);
    ASSERT_TRUE(again);
    EXPECT_NEAR(again->j, -puck.j, 1e-10 * energy);
    const Vec21 end = momentum(puck, again->centre.u, again->j, again->centre.heat), start = momentum(puck);
    EXPECT_TRUE(size(end - Vec21{start.t, -start.x, -start.y}) <= 1e-10 * energy);
  }
}

// Without friction nothing is new: to the bit.
TEST(RimFriction, WithoutItKicksAreThoseOfSmoothPucks) {
  RandomPucks random(6);
  for (int i = 0; i < 5000; ++i) {
    CASE(random, i);
    const SpinningPair pair = randomSpinningPair(random);
    const RimRules rules{random.in(0.0, 1.0), 0.0, random.in(0.0, 1.0)};
    const auto [first, second] = pair.pucks;
    const auto kick = kickSpinningPair(pair.U, pair.n, pair.pucks, rules);
    const auto smooth =
        kickPair(pair.U, pair.n, {first.u, second.u},
                 {restMass(first.body, first.j), restMass(second.body, second.j)}, rules.restitution);
    ASSERT_EQ(static_cast<bool>(kick), static_cast<bool>(smooth));
    if (!kick) continue;
    for (int k = 0; k < 2; ++k) {
      EXPECT_EQ(kick->centres.u[k].x, smooth->u[k].x);
      EXPECT_EQ(kick->centres.u[k].y, smooth->u[k].y);
      EXPECT_EQ(kick->centres.heat[k], smooth->heat[k]);
      EXPECT_EQ(kick->j[k], pair.pucks[k].j);
    }
    const CushionPlane plane{1, 1.0, 1.0};
    const auto bounce = kickSpinningOffCushion(plane, first, rules);
    const auto plain = kickOffCushion(plane, first.u, restMass(first.body, first.j), rules.restitution);
    ASSERT_EQ(static_cast<bool>(bounce), static_cast<bool>(plain));
    if (!bounce) continue;
    EXPECT_EQ(bounce->centre.u.x, plain->u.x);
    EXPECT_EQ(bounce->centre.u.y, plain->u.y);
    EXPECT_EQ(bounce->j, first.j);
  }
}

// Newton's limit: a slow puck on a cushion keeps v_t − (v_t + R ω) k/(1+k), in units of c, and its spin
// takes the rest. Head-on with opposite spins, equal rims already agree: no tangential impulse.
TEST(RimFriction, HasTheLimitsOfNewtonAndOfSymmetry) {
  const double k = 0.3, v = 2e-6, f = 3e-6;
  const SpinningBody body{0.2, 0.2 * k};
  const SpinningPuck puck{body, spinOfRim(body, f), fourVelocity(1e-6, v)};
  const auto kick = kickSpinningOffCushion({0, 1.0, 1.0}, puck, {1.0, kInfinity, 0.0});
  ASSERT_TRUE(kick);
  const double along = v - (v + f) * k / (1.0 + k);
  EXPECT_NEAR(kick->centre.u.y, along, 1e-16);
  EXPECT_NEAR(rimBeta(body, kick->j), -along, 1e-16);

  const std::array<SpinningPuck, 2> headOn{SpinningPuck{body, 0.1, fourVelocity(1.0, 0.0)},
                                           SpinningPuck{body, -0.1, fourVelocity(-1.0, 0.0)}};
  const auto blow = kickSpinningPair({1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, headOn, {1.0, kInfinity, 1.0});
  ASSERT_TRUE(blow);
  EXPECT_NEAR(blow->centres.u[0].y, 0.0, 1e-15);
  EXPECT_NEAR(blow->j[0], 0.1, 1e-15);
  EXPECT_NEAR(blow->j[1], -0.1, 1e-15);
}

// Known bits: the same on every machine, or cluster nodes would drift apart.
TEST(RimFriction, HasTheseBits) {
  const SpinningBody body{0.2, 0.1};
  const SpinningPuck puck{body, 0.05, fourVelocity(0.75, 0.5)}, other{body, -0.02, fourVelocity(-0.75, -0.5)};
  const auto bounce = kickSpinningOffCushion({0, 1.0, 1.0}, puck, {0.9, 0.3, 0.5});
  const auto blow = kickSpinningPair({1.0, 0.0, 0.0}, {0.0, 0.8, 0.6}, {puck, other}, {0.9, 5.0, 0.5});
  ASSERT_TRUE(bounce && blow);
  EXPECT_EQ(bounce->centre.u.y, 0x1.fedbd7ce0e3b2p-5);
  EXPECT_EQ(bounce->j, -0x1.6162a3738ba66p-5);
  EXPECT_EQ(blow->centres.u[0].y, -0x1.069e93b351649p-1);
  EXPECT_EQ(blow->j[1], -0x1.e91d1fb74049cp-6);
}

// The heat over c² is what Newton's disc loses, to v/c and rounding: for a rim that sticks to a cushion,
// (1 − e²)/2 m v_n² + k/(1 + k)/2 m v_t². A difference of masses would have only rounding
// left. Momenta along the wall are kept as E ± p, so that their digits end at 1e-16 of m c.
TEST(RimFriction, HeatKeepsItsDigitsWhereLightIsFast) {
  constexpr double kMass = 0.2, kShare = 0.5, kRestitution = 0.7;
  for (const double c : {1e4, 1e6, 1e7, 1e8}) {
    const double across = 1.0 / c, along = 0.8 / c;
    const SpinningPuck puck{{kMass, kShare * kMass}, 0.0, fourVelocity(across, along)};
    const auto kick = kickSpinningOffCushion({0, 1.0, 0.0}, puck, {kRestitution, 1e3, 0.0});
    ASSERT_TRUE(kick);
    const double newton =
        0.5 * kMass *
        ((1.0 - kRestitution * kRestitution) * across * across + kShare / (1.0 + kShare) * along * along);
    EXPECT_TRUE(std::abs(kick->centre.heat / newton - 1.0) <= 10.0 * across * across + 1e-15 * c)
        << c << ": " << kick->centre.heat << " instead of " << newton;
    const SpinningPuck other{{kMass, kShare * kMass}, 0.0, fourVelocity(-across, -along)};
    const auto pair =
        kickSpinningPair({1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {puck, other}, {kRestitution, 1e3, 0.0});
    ASSERT_TRUE(pair);
    for (const double heat : pair->centres.heat)
      EXPECT_TRUE(std::abs(heat / newton - 1.0) <= 10.0 * across * across + 1e-15 * c)
          << c << ": " << heat << " instead of " << newton;
  }
}

}  // namespace
}  // namespace carom
