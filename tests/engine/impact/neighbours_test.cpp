#include "engine/impact/neighbours.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "engine/gas.h"
#include "engine/random_world.h"

namespace carom {
namespace {

// All pucks beside each other that meet, each with each.
std::set<int> meetNearby(const GameState& game, int i, double within) {
  std::set<int> found;
  for (int other = 0; other < game.count(); ++other) {
    if (other == i) continue;
    const Vec21 way = game.discs[other].start - game.discs[i].start;
    const PuckPair who{std::min(i, other), std::max(i, other)};
    if (std::max(std::abs(way.x), std::abs(way.y)) < within &&
        findMeeting(game.discs[who[0]], game.discs[who[1]], game.rules.convention))
      found.insert(other);
  }
  return found;
}

void expectAllFound(Neighbours& neighbours, GameState& game, int i, double clock) {
  const int end = neighbours.find(game, i, 0, clock);
  std::set<int> found;
  for (int k = 0; k < end; ++k) {
    EXPECT_NE(neighbours[k], i);
    EXPECT_TRUE(found.insert(neighbours[k]).second) << "twice: " << neighbours[k];
  }
  for (const int other : meetNearby(game, i, neighbours.cells().cellEdge()))
    EXPECT_TRUE(found.contains(other)) << i << " meets " << other;
}

TEST(Neighbours, AreAllThatAreNearAndMeet) {
  for (const CollisionEvent event : {CollisionEvent::centre, CollisionEvent::contact}) {
    BilliardSetup setup = test::gasSetup(400, 0.3, 1.4, 5);
    setup.rules.collisionEvent = event;
    GameState game(setup);
    Neighbours neighbours(setup, game);
    ASSERT_TRUE(neighbours.hasCells());
    neighbours.layOut(game, 0.0);
    std::size_t meet = 0;
    for (int i = 0; i < game.count(); ++i) {
      expectAllFound(neighbours, game, i, 0.0);
      meet += meetNearby(game, i, neighbours.cells().cellEdge()).size();
    }
    EXPECT_GT(meet, 400u);
  }
}

// What has begun a leg is found by its new flight.
TEST(Neighbours, FollowLegsThatBegin) {
  const BilliardSetup setup = test::gasSetup(200, 0.3, 1.4, 6);
  GameState game(setup);
  Neighbours neighbours(setup, game);
  neighbours.layOut(game, 0.0);
  test::Random random(7);
  for (int i = 0; i < 200; ++i) {
    CASE(random, i);
    const int puck = static_cast<int>(random.in(0.0, 200.0));
    const double angle = random.in(0.0, 2.0 * M_PI);
    Leg leg = game.legOf(puck);
    leg.u = fourVelocity(std::cos(angle), std::sin(angle));
    game.beginLeg(puck, leg, {});
    EXPECT_FALSE(game.begun.empty());
    neighbours.update(game, 0.0);
    EXPECT_TRUE(game.begun.empty());
    for (int other = 0; other < game.count(); ++other) expectAllFound(neighbours, game, other, 0.0);
  }
}

TEST(Neighbours, OneThatCrossesIsInTheCellWhereItsLegIsThen) {
  const BilliardSetup setup = test::gasSetup(200, 0.1, 1.4, 8);
  GameState game(setup);
  Neighbours neighbours(setup, game);
  neighbours.layOut(game, 0.0);
  int crossed = 0;
  for (int i = 0; i < game.count(); ++i) {
    const Prediction before = game.predictions[i];
    if (before.leavesCell == kNever) continue;
    ++crossed;
    const int axis = before.leavesAlong();
    neighbours.cross(game, i, axis, wayAlong(game.discs[i], axis));
    const Vec21 soon = momentAt(game.flightOf(i), before.leavesCell + 1e-9).x;
    EXPECT_EQ(neighbours.cells().cellOf(i), neighbours.cells().cellAt(soon.x, soon.y)) << i;
    EXPECT_GT(game.predictions[i].leavesCell, before.leavesCell);
  }
  EXPECT_GT(crossed, 100);
}

TEST(Neighbours, FewPucksNeedNoCellsAndFastOnesLargerOnes) {
  const BilliardSetup few = test::gasSetup(32, 0.1, 1.4, 9), many = test::gasSetup(33, 0.1, 1.4, 9);
  GameState ofFew(few);
  EXPECT_FALSE(Neighbours(few, ofFew).hasCells());

  BilliardSetup setup = many;
  setup.rules.collisionEvent = CollisionEvent::centre;
  GameState game(setup);
  Neighbours neighbours(setup, game);
  neighbours.layOut(game, 0.0);
  const double edge = neighbours.cells().cellEdge();
  EXPECT_FALSE(neighbours.areTooSmall(game));
  game.fastest = 100.0;
  EXPECT_TRUE(neighbours.areTooSmall(game));
  game.discs[3].u = fourVelocity(100.0, 0.0);
  neighbours.layOut(game, 0.0);
  EXPECT_FALSE(neighbours.areTooSmall(game));
  EXPECT_GT(neighbours.cells().cellEdge(), 10.0 * edge);
}

}  // namespace
}  // namespace carom
