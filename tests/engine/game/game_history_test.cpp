#include "engine/game/game_history.h"

#include <cmath>

#include <gtest/gtest.h>

#include "engine/base/never.h"
#include "engine/light_speed.h"
#include "engine/random_world.h"

namespace carom {
namespace {

using test::kC_m_s;

BilliardSetup twoPucks(double friction_m_s2) {
  BilliardSetup setup;
  setup.lightSpeed_m_s = kC_m_s;
  setup.rules.friction_m_s2 = friction_m_s2;
  setup.pucks = {{"one", 0.05, 0.02, 0.2, {0.0, 0.0}, {0.5, 0.0}},
                 {"two", 0.05, 0.04, 0.2, {1.0, 0.0}, {0.0, 0.1}}};
  return setup;
}

/// Legs of random ways, each from where the last one has come to.
std::vector<Leg> randomLegs(test::Random& random, const BilliardSetup& setup, std::size_t puck, int count) {
  const Puck& from = setup.pucks[puck];
  const double brake = setup.rules.friction_m_s2 / (kC_m_s * kC_m_s);
  const double gamma = 1.0 / std::sqrt(1.0 - glm::dot(from.beta, from.beta));
  std::vector<Leg> legs{{{0.0, from.position_m.x, from.position_m.y},
                         fourVelocity(gamma * from.beta.x, gamma * from.beta.y),
                         0.0,
                         brake}};
  while (static_cast<int>(legs.size()) <= count) {
    const LegState turn = momentAt(legs.back(), legs.back().start.t + random.in(0.1, 1.0));
    legs.push_back(
        {turn.x, fourVelocity(random.in(-1.0, 1.0), random.in(-1.0, 1.0)), turn.properTime, brake});
  }
  return legs;
}

// The world lines are the legs: at any time in SI units where momentAt says in metres of light.
TEST(GameHistory, WorldLinesAreTheLegsInSIUnits) {
  test::Random random(1);
  for (int i = 0; i < 40; ++i) {
    CASE(random, i);
    const BilliardSetup setup = twoPucks(i % 2 == 0 ? 0.0 : 0.3);
    GameHistory history(setup);
    std::vector<std::vector<Leg>> legs;
    for (std::size_t puck = 0; puck < 2; ++puck) {
      legs.push_back(randomLegs(random, setup, puck, 300));  // more than wait to be added at once
      for (std::size_t k = 1; k < legs[puck].size(); ++k)
        history.addLeg(puck, legs[puck][k], {}, legs[puck][k].start);
    }
    for (std::size_t puck = 0; puck < 2; ++puck) {
      ASSERT_EQ(history.legs(puck), legs[puck].size());
      for (int n = 0; n < 50; ++n) {
        const double t = random.in(0.0, legs[puck].back().start.t + 1.0);
        std::size_t k = legs[puck].size() - 1;
        while (k > 0 && legs[puck][k].start.t > t) --k;
        const LegState moment = momentAt(legs[puck][k], t);
        const Motion motion = history.worldLines()[puck].at(t / kC_m_s);
        EXPECT_NEAR(motion.event.r_m.x, moment.x.x, 1e-9);
        EXPECT_NEAR(motion.event.r_m.y, moment.x.y, 1e-9);
        EXPECT_EQ(motion.event.r_m.z, 0.5 * setup.pucks[puck].height_m);
        EXPECT_NEAR(motion.u.x, moment.u.x, 1e-9);
        EXPECT_NEAR(motion.properTime_s * kC_m_s, moment.properTime, 1e-9);
      }
    }
  }
}

TEST(GameHistory, ForgetsFromEitherEndAndKeepsCount) {
  test::Random random(2);
  const BilliardSetup setup = twoPucks(0.0);
  GameHistory history(setup);
  const std::vector<Leg> legs = randomLegs(random, setup, 0, 9);
  for (std::size_t k = 1; k < legs.size(); ++k) history.addLeg(0, legs[k], {}, legs[k].start);
  EXPECT_EQ(history.legs(0), 10u);
  history.forgetBefore((legs[4].start.t + 1e-6) / kC_m_s);  // legs 0 to 3 have ended
  EXPECT_EQ(history.legs(0), 10u) << "counted from the start of the game";
  EXPECT_EQ(history.worldLines()[0].knots().size(), 6u);
  EXPECT_NEAR(history.worldLines()[0].knots()[0].turn.t_s * kC_m_s, legs[4].start.t, 1e-12);
  history.keepLegs(0, 7);
  EXPECT_EQ(history.legs(0), 7u);
  EXPECT_NEAR(history.worldLines()[0].knots().back().turn.t_s * kC_m_s, legs[6].start.t, 1e-12);
  history.addLeg(0, legs[7], {}, legs[7].start);
  EXPECT_EQ(history.legs(0), 8u);
}

TEST(GameHistory, EventsAreNumberedChangedAndForgotten) {
  const BilliardSetup setup = twoPucks(0.0);
  GameHistory history(setup);
  const LegState before{{2.84, 0.1, 0.2}, fourVelocity(0.75, 0.0), 1.0};
  EXPECT_EQ(history.addCollision({}, {1.42, 0.3, 0.4}, false, 0.5), 0u);
  history.addTurn(0, 1, before, fourVelocity(0.0, -0.75), {});
  EXPECT_EQ(history.addCollision(Cushion::minusY, {2.84, 0.0, 0.0}, true, 0.0), 1u);
  EXPECT_EQ(history.addStroke(3, {4.26, 0.0, 0.0}, 0.3), 2u);
  EXPECT_EQ(history.addFlash(4, {5.0, {1.0, 2.0, 3.0}}), 3u);
  EXPECT_EQ(history.addJam({7.1, 0.0, 0.0}, 0.25), 4u);
  ASSERT_EQ(history.eventCount(), 5u);

  const GameEvent& met = history.events()[0];
  EXPECT_EQ(met.kind, EventKind::puckPuck);
  EXPECT_NEAR(met.at.t_s, 1.0, 1e-15);
  EXPECT_EQ(met.at.r_m.x, 0.3);
  EXPECT_EQ(met.at.r_m.z, 0.5 * setup.pucks[1].height_m) << "as high as the centre that turns";
  ASSERT_EQ(met.turns.size(), 1u);
  EXPECT_NEAR(met.turns[0].event.t_s, 2.0, 1e-15);
  EXPECT_NEAR(met.turns[0].betaBefore.x, 0.6, 1e-15);  // u = 0.75 is β = 0.6
  EXPECT_NEAR(met.turns[0].betaAfter.y, -0.6, 1e-15);
  EXPECT_EQ(history.events()[1].cushion, Cushion::minusY);
  EXPECT_EQ(history.events()[2].which, 3u);
  EXPECT_EQ(history.events()[3].at.r_m.z, 3.0);
  EXPECT_EQ(history.events()[4].heat_j, 0.25);

  EXPECT_EQ(history.takeUnchangedEvents(), 0u);
  EXPECT_EQ(history.takeUnchangedEvents(), 5u);
  history.changeTurn(0, 1, before, fourVelocity(0.75, 0.0), {});
  EXPECT_NEAR(history.events()[0].turns[0].betaAfter.x, 0.6, 1e-15);
  EXPECT_EQ(history.takeUnchangedEvents(), 0u) << "the first was changed";
  history.keepEvents(3);
  EXPECT_EQ(history.eventCount(), 3u);
  EXPECT_EQ(history.takeUnchangedEvents(), 3u);

  EXPECT_EQ(history.takeChangedFrom_s(), kNever);
  history.noteChange({2.84, 0.0, 0.0});
  history.noteChange({4.26, 0.0, 0.0});
  EXPECT_NEAR(history.takeChangedFrom_s(), 2.0, 1e-15);
  EXPECT_EQ(history.takeChangedFrom_s(), kNever);

  history.forgetBefore(1.5);
  EXPECT_EQ(history.forgottenEvents(), 0u) << "the turn of the first is to come";
  history.forgetBefore(2.5);
  EXPECT_EQ(history.forgottenEvents(), 2u);
  EXPECT_EQ(history.eventCount(), 3u) << "counted from the start of the game";
  EXPECT_EQ(history.events()[0].which, 3u);
}

}  // namespace
}  // namespace carom
