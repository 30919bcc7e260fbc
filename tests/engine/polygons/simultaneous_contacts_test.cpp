// Sides that lie on sides: what touches at one time, and its middle.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "engine/polygons/corner_contact.h"
#include "engine/polygons/corner_kick.h"
#include "engine/polygons/corner_pairs.h"

namespace carom {
namespace {

using test::flight;
using test::fourVelocityOf;
using test::rectangle;
using Vec2 = glm::dvec2;

TEST(CornerContact, SquaresFaceToFaceTieInTheMiddle) {
  const Outline square(rectangle(0.08, 0.08));
  const MovingShape left = flight({-0.5, 0.01}, {0.6, 0.0}, square);
  const MovingShape right = flight({0.5, -0.01}, {-0.6, 0.0}, square);
  const auto found = findCornerContact(left, right);
  ASSERT_TRUE(found && found->sideOnSide);
  EXPECT_WITHIN(found->contact.event.x, 0.0, 1e-15);
  EXPECT_WITHIN(found->contact.event.y, 0.0, 1e-15);
  EXPECT_WITHIN(found->contact.event.t, (0.5 - 0.04 * 0.8) / 0.6, 1e-14);
  // Aligned, the levers vanish and nothing turns.
  const auto aligned =
      findCornerContact(flight({-0.5, 0.0}, {0.6, 0.0}, square), flight({0.5, 0.0}, {-0.6, 0.0}, square));
  ASSERT_TRUE(aligned && aligned->sideOnSide);
  std::array<LeveredBody, 2> bodies;
  for (int i = 0; i < 2; ++i) {
    const MovingShape& one = i == 0 ? left : right;
    bodies[i] = {{{0.2, 0.1}, 0.0, one.u},
                 square.radius(),
                 aligned->contact.event - Vec21{0.0, i == 0 ? -0.5 : 0.5, 0.0}};
  }
  const auto kick = kickCorners(aligned->contact.U, aligned->contact.n, bodies, {});
  ASSERT_TRUE(kick);
  EXPECT_WITHIN(kick->j[0], 0.0, 1e-16);
  EXPECT_WITHIN(kick->centres.u[0].x, -left.u.x, 1e-15);
  // In a frame that moves along the sides one end is first, and it is no tie.
  const auto there = findCornerContact(left, right, fourVelocityOf({0.0, 0.3}));
  ASSERT_TRUE(there);
  EXPECT_FALSE(there->sideOnSide);
  EXPECT_WITHIN(std::abs(there->contact.event.y), 0.03, 1e-15);
}

// The face of a square comes to a face half as long and, with its upper corner, to a slope above that. The
// slope is later by less than what counts as one time, so that the face is the first.
TEST(CornerContact, WhatTouchesAnotherSideAtThatTimeDoesNotMoveTheMiddle) {
  constexpr double kLater = 2e-11;
  const Outline square(rectangle(0.08, 0.08));
  const std::vector<Vec2> corners{{-0.04, -0.04},         {0.08, -0.04},          {0.08, 0.06},
                                  {-0.06 + kLater, 0.06}, {-0.02 + kLater, 0.02}, {-0.04, 0.0}};
  ASSERT_FALSE(faultOf(corners));
  const Outline notched(corners);
  const auto found =
      findCornerContact(flight({-0.5, 0.0}, {0.6, 0.0}, square), flight({0.5, 0.0}, {-0.6, 0.0}, notched));
  ASSERT_TRUE(found && found->sideOnSide);
  EXPECT_WITHIN(found->contact.event.x, 0.0, 1e-12);
  EXPECT_WITHIN(found->contact.event.y, -0.02, 1e-12);
}

}  // namespace
}  // namespace carom
