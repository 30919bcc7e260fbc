// A simulated device on the session's clock: its ticks follow the laws that are posted.
#include "devices/force/stepped_force.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

namespace carom {
namespace {

/// A law of a cue that is drawn by a hand that wants to be at x.
ForceLaw drawnTo(double x_m, double now_s) {
  ForceLaw law;
  law.kind = ForceLaw::Kind::cue;
  law.cue = {0.403, 0.08, 1.0};
  law.held = true;
  law.posted_s = now_s;
  law.wish_m = {x_m, 0.0, 0.0};
  return law;
}

// How often the game posts does not matter, and the last tick is not later than the law.
TEST(SteppedForce, TheSameSessionGivesTheSameForcesInAnySteps) {
  SteppedForce often{ForceLimits{}}, seldom{ForceLimits{}};
  for (SteppedForce* force : {&often, &seldom}) force->post(drawnTo(0.0, 2.0));
  for (int i = 1; i <= 32; ++i) often.post(drawnTo(-0.05, 2.0 + 0.015625 * i));
  for (int i = 1; i <= 2; ++i) seldom.post(drawnTo(-0.05, 2.0 + 0.25 * i));
  EXPECT_EQ(often.report().time_s, seldom.report().time_s);
  EXPECT_LE(often.report().time_s, 2.5);
  EXPECT_GT(often.report().time_s, 2.5 - 2.1e-3);
  EXPECT_TRUE(often.report().active);
  EXPECT_GT(often.report().force_n.x, 0.1) << "back to where the draw began";
  EXPECT_EQ(often.report().force_n, seldom.report().force_n);
  EXPECT_EQ(often.report().position_m, seldom.report().position_m);
}

TEST(SteppedForce, WhatIsLongerThanASecondIsNotMadeUpFor) {
  SteppedForce force{ForceLimits{}};
  force.post(drawnTo(0.0, 2.0));
  force.post(drawnTo(-0.05, 2.5));
  force.post(drawnTo(-0.05, 60.0));
  EXPECT_NEAR(force.report().time_s, 60.0 - 1e-3, 1e-9);
}

TEST(SteppedForce, AtItsEndThereIsNoForce) {
  SteppedForce force{ForceLimits{}};
  force.post(drawnTo(0.0, 2.0));
  force.post(drawnTo(-0.05, 2.5));
  ASSERT_GT(glm::length(force.report().force_n), 0.0);
  force.end();
  EXPECT_EQ(force.report().force_n, glm::dvec3(0.0));
  EXPECT_FALSE(force.report().active);
  EXPECT_EQ(force.report().fall, ForceFall::ended);
}

}  // namespace
}  // namespace carom
