// A stroke on a soft body: on which nodes, from when, for how long.
#include "engine/soft/soft_push.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <memory>

#include "engine/random_world.h"
#include "engine/soft/soft_discs.h"

namespace carom {
namespace {

using test::kMass, test::kSmallRadius;

SoftPlayer disc() {
  SoftEntry entry{
      "disc", std::make_shared<SoftMesh>(softDisc(kSmallRadius, 6)), {}, kMass, {0.0, 0.0}, {1.0, 0.0, 0.0}};
  SoftPlayer player(std::make_shared<const SoftEntry>(entry));
  player.wake(0.0);
  return player;
}

/// A hand beside the body: its light comes node by node.
SoftStroke besideIt() {
  SoftStroke stroke;
  stroke.hand = {0.01, -0.2, 0.0};
  stroke.height = 0.05;
  stroke.hasPlace = true;
  stroke.momentum = {0.1, 0.0};
  return stroke;
}

/// Returns when the light of the hand is at a place.
double litAt(const SoftStroke& stroke, const glm::dvec2& place) {
  const glm::dvec2 way = place - glm::dvec2(stroke.hand.x, stroke.hand.y);
  return stroke.hand.t + std::hypot(glm::length(way), stroke.height);
}

// Without a place of the hand the whole half begins at once; the momentum that is given in 2R/c_s is the
// stroke's, and then it is over.
TEST(SoftPush, GivesTheMomentumOfTheStrokeAndEnds) {
  SoftPlayer player = disc();
  SoftStroke stroke;
  stroke.hand.t = 0.02;
  stroke.momentum = {0.03, 0.04};
  SoftPush push(stroke);
  FarSides farSides;
  push.act(player, 0.01, farSides);
  EXPECT_FALSE(push.began()) << "not before its time";
  EXPECT_EQ(push.nextChange(player, 0.01, 1.0), 0.02);
  push.act(player, 0.02, farSides);
  ASSERT_TRUE(push.began());
  EXPECT_EQ(*push.began(), 0.02);
  const double ends = push.nextChange(player, 0.02, 1.0);
  EXPECT_NEAR(ends, 0.02 + player.soundTime(), 1e-15);
  // By one short step of the body: all its nodes together are pushed by p/T.
  constexpr double kStep = 1e-6;
  player.body.tryStep(kStep, false);
  glm::dvec2 given(0.0);
  for (std::size_t i = 0; i < player.body.size(); ++i) {
    const SoftBody::Trial node = player.body.trial(i);
    given += glm::dvec2(node.px, node.py);
  }
  const glm::dvec2 expected = kStep / player.soundTime() * stroke.momentum;
  EXPECT_LT(glm::distance(given, expected), 1e-12 * glm::length(expected));
  push.act(player, ends, farSides);
  EXPECT_TRUE(push.isOver());
  EXPECT_EQ(push.nextChange(player, ends, 1.0), 1.0);
}

// A node is pushed from the first step on at which the light of the hand has reached it; those on the far
// half never are.
TEST(SoftPush, ReachesNodesWithTheLightOfTheHand) {
  const SoftStroke stroke = besideIt();
  SoftPlayer player = disc();
  SoftPush push(stroke);
  FarSides farSides;
  const double first = litAt(stroke, {-kSmallRadius, 0.0}), middle = litAt(stroke, {0.0, 0.0});
  push.act(player, first - 1e-6, farSides);
  EXPECT_FALSE(push.began());
  const double half = 0.5 * (first + middle);
  player.body.endPushes();
  push.act(player, half, farSides);
  ASSERT_TRUE(push.began());
  constexpr double kStep = 1e-6;
  player.body.tryStep(kStep, false);
  // Of all nodes together; the stresses of a relaxed body are of the order of rounding.
  const double all = kStep / player.soundTime() * stroke.momentum.x;
  std::size_t pushed = 0;
  for (std::size_t i = 0; i < player.body.size(); ++i) {
    const glm::dvec2 place = player.body.place(i);
    const bool isLit = litAt(stroke, place) <= half && place.x < -1e-9;
    EXPECT_EQ(player.body.trial(i).px > 1e-6 * all, isLit) << place.x << ' ' << place.y;
    pushed += isLit ? 1 : 0;
  }
  EXPECT_GT(pushed, 3U);
  EXPECT_LT(pushed, player.body.size() / 2);
}

// It says that it may reach a body no later than it does, and not long before.
TEST(SoftPush, SaysWhenItMayReachABody) {
  constexpr double kSlice = 0.005;
  test::Random random(33);
  for (int i = 0; i < 100; ++i) {
    CASE(random, i);
    SoftStroke stroke = besideIt();
    stroke.hand = {random.in(0.0, 0.5), random.in(-0.5, 0.5), random.in(-0.5, 0.5)};
    const SoftPush push(stroke);
    const SoftPlayer player = disc();
    const double apart = std::max(0.0, std::hypot(stroke.hand.x, stroke.hand.y) - kSmallRadius);
    const double arrives = stroke.hand.t + std::hypot(apart, stroke.height);
    ASSERT_TRUE(push.reachesBefore(player, arrives, kSlice, arrives + 1e-9));
    ASSERT_FALSE(push.reachesBefore(player, arrives, kSlice, arrives - 2.0 * kSlice));
  }
}

// A stroke of no momentum is over as soon as it is looked at.
TEST(SoftPush, NothingIsOverAtOnce) {
  SoftPlayer player = disc();
  SoftPush push({});
  FarSides farSides;
  push.act(player, 0.0, farSides);
  EXPECT_TRUE(push.isOver());
  EXPECT_FALSE(push.began());
}

}  // namespace
}  // namespace carom
