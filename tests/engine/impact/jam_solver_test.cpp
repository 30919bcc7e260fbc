// Jams out of a game: heaps of bodies that press on one another, judged by Newton's mechanics, as all is
// slow, and by exact sums of four-momenta.

#include "engine/impact/jam_solver.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include <glm/geometric.hpp>

#include "engine/base/never.h"
#include "engine/random_world.h"

namespace carom {
namespace {

using Vec2 = glm::dvec2;

constexpr double kSpeed = 1e-3;  // of light: Newton's mechanics are right to a millionth of it

JamBody bodyAt(const Vec2& place, const Vec2& u, double mass, double radius, int number) {
  JamBody body;
  body.puck = body.group = number;
  body.masses = {mass, 0.5 * mass};
  body.mass = mass;
  body.radius = radius;
  body.turn.x = {0.0, place.x, place.y};
  body.turn.u = body.u = fourVelocity(u.x, u.y);
  return body;
}

Vec2 placeOf(const JamBody& body) { return {body.turn.x.x, body.turn.x.y}; }

/// Returns the four-momentum with what was radiated and what cushions took.
Vec21 total(const std::vector<JamBody>& bodies) {
  Vec21 sum;
  for (const JamBody& body : bodies) sum = sum + body.u * body.mass + body.radiated + body.taken;
  return sum;
}

/// A heap of equal discs, closely packed, with a contact for each pair that touches.
struct Heap {
  std::vector<JamBody> bodies;
  std::vector<JamContact> contacts;

  Heap(test::Random& random, int rows) {
    constexpr double kRadius = 0.03;
    for (int row = 0; row < rows; ++row)
      for (int k = 0; k < rows; ++k)
        bodies.push_back(bodyAt(kRadius * Vec2{2.0 * k + row % 2, std::sqrt(3.0) * row},
                                kSpeed * Vec2{random.in(-1.0, 1.0), random.in(-1.0, 1.0)},
                                random.in(0.1, 1.0), kRadius, static_cast<int>(bodies.size())));
    for (int i = 0; i < static_cast<int>(bodies.size()); ++i)
      for (int j = i + 1; j < static_cast<int>(bodies.size()); ++j)
        if (glm::length(placeOf(bodies[j]) - placeOf(bodies[i])) < 2.001 * kRadius)
          contacts.push_back({i, j, false, {}});
  }
  /// The speed at which the two of a contact close.
  double closing(const JamContact& contact) const {
    const JamBody &one = bodies[contact.first], &two = bodies[contact.second];
    const Vec2 n = glm::normalize(placeOf(two) - placeOf(one));
    return glm::dot(Vec2{one.u.x - two.u.x, one.u.y - two.u.y}, n);
  }
};

void expectSame(const Vec21& one, const Vec21& other) {
  EXPECT_NEAR(one.t, other.t, 1e-12);
  EXPECT_NEAR(one.x, other.x, 1e-15);
  EXPECT_NEAR(one.y, other.y, 1e-15);
}

TEST(JamSolver, NoneClosesAfterwardsAndFourMomentumIsKept) {
  test::Random random(81);
  for (int i = 0; i < 100; ++i) {
    CASE(random, i);
    Heap heap(random, 2 + i % 5);
    const Vec21 before = total(heap.bodies);
    constexpr double kSlow = 1e-9;
    ASSERT_TRUE(JamSolver({0.0, 0.0}, {}, heap.bodies, heap.contacts).relax(kSlow));
    for (const JamContact& contact : heap.contacts) ASSERT_LT(heap.closing(contact), 2.0 * kSlow);
    for (const JamBody& body : heap.bodies) ASSERT_GE(body.heat, 0.0);
    expectSame(total(heap.bodies), before);
  }
}

TEST(JamSolver, ElasticDiscsAmongBodiesWithCornersLoseNothing) {
  test::Random random(82);
  for (int i = 0; i < 50; ++i) {
    CASE(random, i);
    Heap heap(random, 2);
    const Vec21 before = total(heap.bodies);
    JamSolver({1.0, 1.0, true}, {}, heap.bodies, heap.contacts).relax(1e-9);
    for (const JamBody& body : heap.bodies) ASSERT_NEAR(body.heat, 0.0, 1e-20);
    expectSame(total(heap.bodies), before);
  }
}

TEST(JamSolver, WhatIsSlowMovesOnWithTheVelocityOfItsMomentum) {
  test::Random random(83);
  Heap heap(random, 3);
  const Vec21 before = total(heap.bodies);
  const double m = std::sqrt(dot(before, before));
  JamSolver({0.0, 0.0}, {}, heap.bodies, heap.contacts).moveOnTogether(1.0);
  for (const JamBody& body : heap.bodies) {
    EXPECT_EQ(body.u.x, heap.bodies[0].u.x);
    EXPECT_EQ(body.u.y, heap.bodies[0].u.y);
    EXPECT_NEAR(body.u.x, before.x / m, 1e-15);
    EXPECT_NEAR(body.u.y, before.y / m, 1e-15);
  }
  expectSame(total(heap.bodies), before);
  Heap apart(random, 3);
  const double u = apart.bodies[0].u.x;
  JamSolver({0.0, 0.0}, {}, apart.bodies, apart.contacts).moveOnTogether(1e-12);
  EXPECT_EQ(apart.bodies[0].u.x, u) << "faster than that, they move on apart";
}

TEST(JamSolver, CushionsTakeMomentum) {
  const std::vector<CushionPlane> cushions{{0, 1.0, 0.5}};
  std::vector<JamBody> bodies{bodyAt({0.47, 0.0}, {kSpeed, 2.0 * kSpeed}, 0.2, 0.03, 0)};
  bodies[0].cushions = 1;
  const Vec21 before = total(bodies);
  ASSERT_TRUE(JamSolver({0.0, 0.0}, cushions, bodies, {}).relax(1e-9));
  EXPECT_NEAR(bodies[0].u.x, 0.0, 1e-15);
  EXPECT_NEAR(bodies[0].u.y, 2.0 * kSpeed, 1e-8);
  EXPECT_NEAR(bodies[0].taken.x, 0.2 * kSpeed, 1e-12);
  expectSame(total(bodies), before);
}

// Two squares face to face, which touch at both ends of the face: neither end closes, one velocity and no
// spin in the end.
TEST(JamSolver, SquaresRecedeAtEachPlaceOrComeToRestTogether) {
  const std::vector<Vec2> corners{{-0.05, -0.05}, {0.05, -0.05}, {0.05, 0.05}, {-0.05, 0.05}};
  const Outline square(corners);
  const auto heap = [&] {
    std::vector<JamBody> bodies{bodyAt({-0.05, 0.0}, {kSpeed, 0.0}, 0.3, square.radius(), 0),
                                bodyAt({0.05, 0.02}, {-kSpeed, 0.0}, 0.3, square.radius(), 1)};
    for (JamBody& body : bodies) body.outline = &square;
    return bodies;
  };
  const std::vector<JamContact> contacts{
      {0, 1, true, {{{0.0, 0.0, 0.05}, {0.0, 1.0, 0.0}}, {{0.0, 0.0, -0.03}, {0.0, 1.0, 0.0}}}}};
  std::vector<JamBody> bodies = heap();
  const Vec21 before = total(bodies);
  ASSERT_TRUE(JamSolver({0.5, 0.5, true}, {}, bodies, contacts).relax(1e-9));
  for (const TouchedPlace& place : contacts[0].places) {
    const auto speed = [&](const JamBody& body) {
      const double omega = rimBeta(body.masses, body.j) / body.radius;
      return body.u.x - omega * (place.event.y - body.turn.x.y);
    };
    EXPECT_LT(speed(bodies[0]) - speed(bodies[1]), 1e-8);
  }
  expectSame(total(bodies), before);

  bodies = heap();
  bodies[0].turnTo(1e-4);
  const Vec21 turning = total(bodies);
  JamSolver({0.5, 0.5, true}, {}, bodies, contacts).moveOnTogether(1.0);
  EXPECT_NE(bodies[0].u.x, bodies[1].u.x) << "bodies with corners only where all do";
  JamSolver({0.5, 0.5, true}, {}, bodies, contacts).moveOnTogether(kNever);
  EXPECT_EQ(bodies[0].u.x, bodies[1].u.x);
  EXPECT_EQ(bodies[0].j, 0.0);
  expectSame(total(bodies), turning);
}

}  // namespace
}  // namespace carom
