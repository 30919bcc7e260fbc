// A soft body that falls asleep and wakes: what it keeps, and how it is brought back.
#include "engine/soft/soft_player.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <memory>

#include "engine/random_world.h"
#include "engine/soft/soft_discs.h"
#include "engine/soft/soft_group.h"

namespace carom {
namespace {

using test::kMass, test::kSmallRadius;

SoftPlayer disc(const glm::dvec2& beta) {
  const double gamma = 1.0 / std::sqrt(1.0 - glm::dot(beta, beta));
  SoftEntry entry{"disc",      std::make_shared<SoftMesh>(softDisc(kSmallRadius, 6)),
                  {},          kMass,
                  {0.1, -0.2}, {gamma, gamma * beta.x, gamma * beta.y}};
  SoftPlayer player(std::make_shared<const SoftEntry>(entry));
  player.measure();
  return player;
}

/// Lets a body run into a cushion, so that it rings.
void ring(SoftPlayer& player) {
  player.wake(player.since);
  const double offset = player.centre.x + kSmallRadius + 1e-4;
  SoftGroup group({&player.body}, {{{1.0, 0.0}, offset}});
  group.advance(3.0 * kSmallRadius);
  player.since += 3.0 * kSmallRadius;
  player.measure();
}

TEST(SoftPlayer, SleepKeepsEnergyMomentumAndCentreAndMakesTheRestHeat) {
  SoftPlayer player = disc({0.5, 0.1});
  ring(player);
  const SoftTotals before = player.body.totals();
  ASSERT_GT(before.elastic, 1e-9 * kMass) << "it rings";
  player.fallAsleep(false);
  const SoftTotals after = player.body.totals();
  EXPECT_NEAR(after.momentum.t, before.momentum.t, 1e-14);
  EXPECT_NEAR(after.momentum.x, before.momentum.x, 1e-14);
  EXPECT_NEAR(after.momentum.y, before.momentum.y, 1e-14);
  EXPECT_LT(glm::distance(after.centre, before.centre), 1e-14);
  EXPECT_GT(after.heat, before.heat);
  EXPECT_LT(after.elastic, 1e-12 * kMass);
  EXPECT_FALSE(player.isAwake);
}

// Where its nodes were beside their places fades evenly within the time R; put to sleep at once, it has no
// such memory.
TEST(SoftPlayer, ItsLastShapeFades) {
  SoftPlayer player = disc({0.5, 0.1});
  ring(player);
  SoftPlayer atOnce = player;
  const glm::dvec2 node = player.body.place(0);
  player.fallAsleep(false);
  EXPECT_LT(glm::distance(player.body.place(0) + player.fade[0], node), 1e-16);
  EXPECT_EQ(player.fadeAt(player.since), 1.0);
  EXPECT_NEAR(player.fadeAt(player.since + 0.25 * kSmallRadius), 0.75, 1e-12);
  EXPECT_EQ(player.fadeAt(player.since + 2.0 * kSmallRadius), 0.0);
  atOnce.fallAsleep(true);
  EXPECT_TRUE(atOnce.fade.empty());
}

// It wakes where its mean motion has taken it.
TEST(SoftPlayer, WakesWhereItHasFlown) {
  SoftPlayer player = disc({0.6, -0.3});
  const glm::dvec2 there = player.centreAt(2.5);
  EXPECT_LT(glm::distance(there, glm::dvec2(0.1, -0.2) + 2.5 * glm::dvec2(0.6, -0.3)), 1e-14);
  player.wake(2.5);
  EXPECT_TRUE(player.isAwake);
  EXPECT_EQ(player.since, 2.5);
  EXPECT_LT(glm::distance(player.body.centre(), there), 1e-14);
}

// Left alone it is quiet once the sound has crossed it and come back, and not while it rings.
TEST(SoftPlayer, IsQuietAfterASoundTime) {
  SoftPlayer quiet = disc({0.5, 0.0}), rings = disc({0.5, 0.1});
  quiet.wake(1.0);
  EXPECT_FALSE(quiet.isQuiet(1.0 + 0.9 * quiet.soundTime()));
  EXPECT_TRUE(quiet.isQuiet(1.0 + 1.1 * quiet.soundTime()));
  ring(rings);
  EXPECT_FALSE(rings.isQuiet(rings.since + 10.0 * rings.soundTime()));
  EXPECT_EQ(rings.quietSince, rings.since + 10.0 * rings.soundTime());
}

// Brought back to an earlier state it goes on with the same bits, also another body in its place.
TEST(SoftPlayer, GoesOnWithTheSameBitsFromAnEarlierState) {
  SoftPlayer player = disc({0.5, 0.1}), other = disc({-0.2, 0.3});
  ring(player);
  const SoftPlayer::State state = player.state();
  const auto goOn = [](SoftPlayer& one) {
    one.refresh();
    SoftGroup group({&one.body}, {});
    group.advance(kSmallRadius);
    return one.body.state();
  };
  const SoftBody::State first = goOn(player);
  player.restore(state);
  const SoftBody::State second = goOn(player);
  other.restore(state);
  const SoftBody::State third = goOn(other);
  for (const SoftBody::State* again : {&second, &third}) {
    EXPECT_EQ(first.x, again->x);
    EXPECT_EQ(first.py, again->py);
    EXPECT_EQ(first.e, again->e);
  }
}

}  // namespace
}  // namespace carom
