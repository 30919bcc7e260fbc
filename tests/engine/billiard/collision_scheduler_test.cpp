#include "engine/billiard/collision_scheduler.h"
#include "engine/light_speed.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace carom {
namespace {

using test::kC_m_s;
constexpr double kRadius_m = 0.05, kHalf_m = 0.8, kBeta = 0.6, kPlayed_s = 8.0;
constexpr std::size_t kMany = 1000;

/// Two pucks that run against each other along x, mirror images at all times, so that the board is the frame
/// of equal speeds of each of their collisions.
BilliardSetup mirrored() {
  BilliardSetup setup;
  setup.lightSpeed_m_s = kC_m_s;
  setup.board = Board{2.0 * kHalf_m, 1.0};
  setup.rules.collisionEvent = CollisionEvent::contact;
  setup.pucks = {{"left", kRadius_m, 0.02, 0.2, {-0.5, 0.0}, {kBeta, 0.0}},
                 {"right", kRadius_m, 0.02, 0.2, {0.5, 0.0}, {-kBeta, 0.0}}};
  return setup;
}

/// The same game by small steps of time: rims are contracted to R sqrt(1 − β²) and throw back when they
/// touch.
struct Stepped {
  double x_m = 0.5, direction = -1.0;
  int collisions = 0, bounces = 0;

  void step(double dt_s) {
    const double reach_m = kRadius_m * std::sqrt(1.0 - kBeta * kBeta);
    x_m += direction * kBeta * kC_m_s * dt_s;
    if (direction < 0.0 && x_m <= reach_m) direction = 1.0, ++collisions;
    if (direction > 0.0 && x_m >= kHalf_m - reach_m) direction = -1.0, ++bounces;
  }
};

TEST(CollisionScheduler, PlaysTheGameThatSmallStepsPlay) {
  const BilliardSetup setup = mirrored();
  CollisionScheduler game(setup);
  GameHistory history(setup);
  EXPECT_TRUE(game.playUntil(kPlayed_s * kC_m_s, kMany, history));
  constexpr double kStep_s = 1e-5;
  Stepped stepped;
  for (int step = 0; step * kStep_s < kPlayed_s; ++step) {
    if (step % 1000 == 0) {
      const double t_s = step * kStep_s;
      // Each turn is late by up to a step.
      const double late_m =
          (stepped.collisions + stepped.bounces + 1) * 2.0 * kStep_s * kBeta * kC_m_s + 1e-6;
      ASSERT_NEAR(history.worldLines()[1].at(t_s).event.r_m.x, stepped.x_m, late_m) << "at " << t_s << " s";
      ASSERT_NEAR(history.worldLines()[0].at(t_s).event.r_m.x, -stepped.x_m, late_m) << "at " << t_s << " s";
    }
    stepped.step(kStep_s);
  }
  int collisions = 0, bounces = 0;
  for (const GameEvent& event : history.events()) {
    ++(event.kind == EventKind::puckPuck ? collisions : bounces);
  }
  EXPECT_EQ(collisions, stepped.collisions);
  EXPECT_EQ(bounces, 2 * stepped.bounces);
  EXPECT_GT(collisions, 3);
}

// A copy is a point of the game: restored and played on it gives the same events again, to the bit.
TEST(CollisionScheduler, ACopyIsAPointToReturnTo) {
  const BilliardSetup setup = mirrored();
  CollisionScheduler game(setup);
  GameHistory history(setup);
  EXPECT_TRUE(game.playUntil(2.0 * kC_m_s, kMany, history));
  const CollisionScheduler copy = game;
  const std::size_t before = history.events().size();
  EXPECT_TRUE(game.playUntil(kPlayed_s * kC_m_s, kMany, history));
  const std::vector<GameEvent> first(history.events().begin(), history.events().end());
  ASSERT_GT(first.size(), before);
  game = copy;
  history.keepEvents(before);
  game.restore(history);
  EXPECT_EQ(history.events().size(), before);
  EXPECT_TRUE(game.playUntil(kPlayed_s * kC_m_s, kMany, history));
  ASSERT_EQ(history.events().size(), first.size());
  for (std::size_t i = 0; i < first.size(); ++i) EXPECT_EQ(history.events()[i].at.t_s, first[i].at.t_s);
}

TEST(CollisionScheduler, StopsAtTheMostEvents) {
  const BilliardSetup setup = mirrored();
  CollisionScheduler game(setup);
  GameHistory history(setup);
  EXPECT_FALSE(game.playUntil(kPlayed_s * kC_m_s, 3, history));
  EXPECT_GE(history.events().size(), 3u);
  EXPECT_LE(history.events().size(), 4u);
  EXPECT_LT(game.clock(), kPlayed_s * kC_m_s);
}

}  // namespace
}  // namespace carom
