#include "engine/game/puck_state.h"

#include <gtest/gtest.h>

#include "engine/random_world.h"

namespace carom {
namespace {

constexpr double kRadius = 0.03;
constexpr double kWindow = 1e-6 * kRadius;  // of kicks that follow each other without end

TEST(PuckState, SixtyFourKicksAtOnceMakeFurtherOnesPlastic) {
  test::Random random(21);
  for (int i = 0; i < 100; ++i) {
    CASE(random, i);
    PuckState puck;
    const double begins = random.in(0.0, 10.0);
    double t = begins;
    for (int kick = 1; kick < 64; ++kick) {
      ASSERT_FALSE(puck.noteKick(t, kRadius)) << "kick " << kick;
      t = begins + kick * random.in(0.9, 1.0) * kWindow / 64.0;
    }
    EXPECT_TRUE(puck.noteKick(t, kRadius));
    EXPECT_TRUE(puck.jammed);
    EXPECT_FALSE(puck.noteKick(t, kRadius)) << "told once";
    puck.noteRest(t + 0.9 * kWindow, kRadius);
    EXPECT_TRUE(puck.jammed);
    puck.noteRest(t + 1.1 * kWindow, kRadius);
    EXPECT_FALSE(puck.jammed);
    EXPECT_FALSE(puck.noteKick(t + 1.1 * kWindow, kRadius)) << "the count begins anew";
  }
}

TEST(PuckState, KicksThatAreFartherApartNeverDo) {
  PuckState puck;
  for (int kick = 0; kick < 10000; ++kick) ASSERT_FALSE(puck.noteKick(kick * kWindow / 60.0, kRadius));
}

// Beside a plain list of all impacts: pressed is a puck with a run of 64, none of whose pauses is as long as
// light needs to cross its radius, which began within such a time.
TEST(PuckState, SixtyFourImpactsPress) {
  test::Random random(22);
  int pressed = 0;
  for (int i = 0; i < 200; ++i) {
    CASE(random, i);
    PuckState puck;
    const double mean = kRadius / random.in(20.0, 200.0);
    double t = 0.0, began = 0.0, last = -1.0;
    int run = 0;
    for (int impact = 0; impact < 300; ++impact) {
      t += random.in(0.0, 2.0 * mean);
      if (random.in(0.0, 1.0) < 0.01) t += kRadius;
      if (t - last > kRadius || (run < 64 && t - began > kRadius)) {
        began = t;
        run = 0;
      }
      ++run;
      last = t;
      puck.noteImpact(t, kRadius, 1e-3, false);
      ASSERT_EQ(puck.isPressed(t, kRadius), run >= 64) << "impact " << impact;
      ASSERT_EQ(puck.isPressed(t + 0.99 * kRadius, kRadius), run >= 64);
      ASSERT_FALSE(puck.isPressed(t + 1.01 * kRadius, kRadius));
      pressed += run >= 64 ? 1 : 0;
    }
  }
  EXPECT_GT(pressed, 1000);
}

TEST(PuckState, AnImpactByManyCountsSixteenAndTheHardestIsKept) {
  PuckState puck;
  for (int impact = 0; impact < 3; ++impact) puck.noteImpact(1.0, kRadius, 0.1 * impact, true);
  EXPECT_FALSE(puck.isPressed(1.0, kRadius));
  puck.noteImpact(1.0, kRadius, 0.15, true);
  EXPECT_TRUE(puck.isPressed(1.0, kRadius));
  EXPECT_EQ(puck.hardestImpact, 0.2);
  puck.jams = 5;
  puck.noteImpact(2.0, kRadius, 0.05, false);
  EXPECT_FALSE(puck.isPressed(2.0, kRadius)) << "left in peace";
  EXPECT_EQ(puck.hardestImpact, 0.05);
  EXPECT_EQ(puck.jams, 0);
}

TEST(PuckState, AKickIsPreventedOnlyIfTheContactCameAfterTheStroke) {
  CommittedLeg kick;
  kick.foundOn = 3;
  kick.ownTime = 1.5;
  EXPECT_FALSE(kick.isPrevented(4, 1.0)) << "found on a leg before the one that was struck";
  EXPECT_FALSE(kick.isPrevented(3, 2.0)) << "the puck had it before";
  EXPECT_TRUE(kick.isPrevented(3, 1.0));
  EXPECT_TRUE(kick.isPrevented(2, 9.0)) << "found on a leg after";
}

}  // namespace
}  // namespace carom
