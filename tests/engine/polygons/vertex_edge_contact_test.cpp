// Corners that pierce sides: random pairs against dense sampling, and cases with closed forms.

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include <glm/geometric.hpp>

#include "engine/polygons/corner_contact.h"
#include "engine/polygons/corner_pairs.h"

namespace carom {
namespace {

using test::expectRandomPairs;
using test::flight;
using test::fourVelocityOf;
using test::RandomPairs;
using test::rectangle;
using test::regular;
using Vec2 = glm::dvec2;

TEST(CornerContact, RandomPairsAsSampled) { expectRandomPairs(1, 6700, false, 0.0); }

TEST(CornerContact, RandomSpinningPairsAsSampled) { expectRandomPairs(2, 3300, false, 1.0); }

// A bar that has been turned away from another just now does not touch it where it would have come from.
TEST(CornerContact, WhatALegWouldHaveDoneBeforeItBeganDoesNotCount) {
  const Outline bar(rectangle(0.3, 0.02));
  const MovingShape rests = flight({0.0, 0.0}, {0.0, 0.0}, bar);
  MovingShape leaves = flight({0.0, 0.1}, {0.1, 0.6}, bar);
  leaves.start.t = 2.0;
  EXPECT_FALSE(findCornerContact(rests, leaves));
  EXPECT_FALSE(findCornerContact(leaves, rests));
  leaves.u = fourVelocityOf({0.1, -0.6});
  const auto found = findCornerContact(rests, leaves);
  ASSERT_TRUE(found);
  EXPECT_GT(found->contact.event.t, leaves.start.t);
}

// A point of a triangle comes to a square that rests and has turned since before the triangle's flight: in
// the square's own time, which is the board's.
TEST(CornerContact, TheNormalLiesAsTheTouchedBodyHasTurnedByThen) {
  const Outline square(regular(4, 0.1)), triangle(regular(3, 0.02, M_PI));
  constexpr double kBegin = -0.3, kAngle = 0.2, kTurning = 2.0;
  const MovingShape turns{{kBegin, 0.0, 0.0}, {1.0, 0.0, 0.0}, square.radius(), &square, kAngle, kTurning};
  const MovingShape comes = flight({0.5, 0.012}, {-0.6, 0.0}, triangle);
  const auto found = findCornerContact(turns, comes, equalSpeedFrame(turns.u, comes.u));
  ASSERT_TRUE(found);
  const Vec21& n = found->contact.n;
  const double angle = kAngle + kTurning * (found->contact.event.t - kBegin);
  double nearest = -1.0;
  for (const Outline::Side& side : square.sides()) {
    const Vec2 normal{side.normal.x * std::cos(angle) - side.normal.y * std::sin(angle),
                      side.normal.x * std::sin(angle) + side.normal.y * std::cos(angle)};
    nearest = std::max(nearest, glm::dot(normal, Vec2{n.x, n.y}));
  }
  EXPECT_WITHIN(n.t, 0.0, 1e-12);
  EXPECT_WITHIN(nearest, 1.0, 1e-12);
}

TEST(CornerContact, TurningBarsThatRestBesideEachOtherMeet) {
  const Outline bar(rectangle(0.12, 0.02));
  const MovingShape still = flight({0.0, 0.0}, {0.0, 0.0}, bar);
  const MovingShape turns = flight({0.09, 0.0}, {0.0, 0.0}, bar, 3.0);
  ASSERT_FALSE(findCornerContact(still, flight({0.13, 0.0}, {0.0, 0.0}, bar, 3.0)));
  MovingShape upright = turns;
  upright.angle = M_PI / 2;
  const auto found = findCornerContact(still, upright);
  ASSERT_TRUE(found);
  // The corner of the bar that stands comes down on the other's end.
  EXPECT_GT(found->contact.event.t, 0.1);
  EXPECT_LT(found->contact.event.t, M_PI / 3.0);
}

// Corner on corner: it lies on the end of two sides, and rounding must not let it pass between them.
TEST(CornerContact, CornersThatMeetExactlyDoNotPassBetweenTheSides) {
  RandomPairs random(6);
  for (int n = 0; n < 2000; ++n) {
    SCOPED_TRACE("seed 6, pair " + std::to_string(n));
    const double angle = random.uniform(0.0, 2.0 * M_PI), radius = random.uniform(0.02, 0.06),
                 speed = random.uniform(0.1, 0.95);
    const int corners = 3 + n % 5;
    const Vec2 way{std::cos(angle), std::sin(angle)};
    const Outline one(regular(corners, radius, angle)), other(regular(corners, radius, angle + M_PI));
    const double apart = random.uniform(0.2, 0.5);
    const auto found =
        findCornerContact(flight(-apart * way, speed * way, one), flight(apart * way, -speed * way, other));
    ASSERT_TRUE(found);
    const Vec21& C = found->contact.event;
    EXPECT_WITHIN(C.t, (apart - radius * std::sqrt(1.0 - speed * speed)) / speed, 1e-12);
    EXPECT_WITHIN(std::hypot(C.x, C.y), 0.0, 1e-13);
  }
}

// Corner on corner, in numbers without rounding: of all that happens at once the first body's corner counts,
// on the side of the second that comes first in its outline.
TEST(CornerContact, OfEqualPiercingsTheFirstCounts) {
  const Vec2 east{0.125, 0.0}, north{0.0, 0.125}, west{-0.125, 0.0}, south{0.0, -0.125};
  const Outline diamond(std::vector<Vec2>{east, north, west, south}),
      turned(std::vector<Vec2>{north, west, south, east});
  const auto normalOf = [](const Outline& first, const Outline& second) {
    const auto found =
        findCornerContact(flight({-0.5, 0.0}, {0.6, 0.0}, first), flight({0.5, 0.0}, {-0.6, 0.0}, second));
    EXPECT_TRUE(found && !found->sideOnSide);
    return found ? Vec2{found->contact.n.x, found->contact.n.y} : Vec2{0.0};
  };
  // The second's sides at its western corner: from north to west before that from west to south.
  EXPECT_LT(normalOf(diamond, diamond).y, -0.1);
  EXPECT_LT(normalOf(turned, diamond).y, -0.1);
  const Outline fromWest(std::vector<Vec2>{west, south, east, north});  // its first side leads to the south
  EXPECT_GT(normalOf(diamond, fromWest).y, 0.1);
}

}  // namespace
}  // namespace carom
