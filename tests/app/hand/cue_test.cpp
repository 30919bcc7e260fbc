// The cue: what holds it, what is refused, and what stroke a pull is on the board.

#include "app/hand/cue.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include <glm/gtc/quaternion.hpp>

#include "app/rig/rig.h"
#include "engine/base/limits.h"
#include "engine/random_world.h"

namespace carom {
namespace {

HandInput handOf(std::string_view device, bool held, const Vec3& pull_m = Vec3(0.0)) {
  HandInput hand;
  hand.device = device;
  hand.along = {0.0, 0.0, -1.0};
  hand.held = held;
  hand.pull_m = pull_m;
  return hand;
}

const PickResult kNothing;
PickResult on(std::size_t puck) {
  PickResult pointed;
  pointed.puck = puck;
  return pointed;
}

TEST(Cue, IsHeldForOnePuckUntilItIsLetGo) {
  Cue cue;
  EXPECT_FALSE(cue.step(handOf("wand", false), on(1)).letGo);
  EXPECT_FALSE(cue.target());
  EXPECT_FALSE(cue.step(handOf("wand", true), on(1)).letGo);
  EXPECT_EQ(cue.target(), 1u);
  cue.step(handOf("wand", true, {0, 0, 0.1}), on(2));  // it points elsewhere
  cue.step(handOf("wand", true, {0, 0, 0.2}), kNothing);
  EXPECT_EQ(cue.target(), 1u);
  const Cue::Outcome outcome = cue.step(handOf("wand", false), on(0));  // its pull is told no more
  EXPECT_EQ(outcome.letGo, 1u);
  EXPECT_EQ(outcome.refused.english(), "");
  EXPECT_EQ(cue.pull_m(), Vec3(0, 0, 0.2));
  EXPECT_FALSE(cue.target());
  EXPECT_FALSE(cue.step(handOf("wand", false), on(0)).letGo) << "once";
}

TEST(Cue, WhatCannotBeIsRefusedOnceAndInWords) {
  PickResult behind;
  behind.behind = true;
  const auto refusalOf = [](const PickResult& pointed, const CueState& state = {}) {
    Cue cue;
    cue.step(handOf("mouse", false), pointed, state);
    const std::string words = cue.step(handOf("mouse", true), pointed, state).refused.english();
    EXPECT_EQ(cue.step(handOf("mouse", true), on(0)).refused.english(), "")
        << "a held button says nothing new";
    EXPECT_FALSE(cue.target()) << "nor does it take hold of what it is moved to";
    EXPECT_FALSE(cue.step(handOf("mouse", false), on(0)).letGo);
    return words;
  };
  EXPECT_EQ(refusalOf(kNothing), "Point at a puck, then drag back");
  EXPECT_EQ(refusalOf(kNothing, {.isRinged = true}), "Point at the ringed puck, then drag back");
  EXPECT_EQ(refusalOf(behind), "The puck is behind your hand: point the other way");
  EXPECT_EQ(refusalOf(on(0), {.frozen = true}), "Nothing can be struck while time stands still");
  EXPECT_EQ(refusalOf(on(0), {.frozen = true, .inLesson = true}),
            "Pucks cannot be struck in a lesson. Enter: explanation");
}

TEST(Cue, ADeviceThatIsLostMidStrokeCancelsIt) {
  for (const HandInput& next : {HandInput(), handOf("mouse", true, {0.3, 0, 0}), handOf("mouse", false)}) {
    Cue cue;
    cue.step(handOf("wand", true), on(0));
    cue.step(handOf("wand", true, {0, 0, 0.2}), on(0));
    const Cue::Outcome outcome = cue.step(next, on(0));
    EXPECT_EQ(outcome.refused.english(), "The wand is lost: no stroke");
    EXPECT_FALSE(outcome.letGo);
    EXPECT_FALSE(cue.target());
    EXPECT_FALSE(cue.step(handOf("wand", false), on(0)).letGo) << "back again, it is let go of nothing";
  }
}

TEST(Cue, TimeThatIsStoppedMidStrokeCancelsIt) {
  Cue cue;
  cue.step(handOf("wand", true), on(0));
  EXPECT_EQ(cue.step(handOf("wand", true, {0, 0, 0.2}), on(0), {.frozen = true}).refused.english(),
            "Time stands still: no stroke");
  EXPECT_FALSE(cue.step(handOf("wand", false), on(0)).letGo);
}

TEST(Cue, APullOfFifteenCentimetresIsTheRestMomentum) {
  const Lorentz still(1.42);
  EXPECT_NEAR(strokeOf({-0.15, 0, 0}, still).u.x, 1.0, 1e-15);
  EXPECT_NEAR(strokeOf({0, 0.3, 0}, still).u.y, -2.0, 1e-15);
  EXPECT_NEAR(glm::length(strokeOf({3.0, 4.0, 0}, still).u), kStrongestU, 1e-15) << "no stronger";
  EXPECT_EQ(strokeOf({0.019, 0, 0}, still).u, Vec2(0.0));
  EXPECT_GT(glm::length(strokeOf({0.021, 0, 0}, still).u), 0.1);
  EXPECT_EQ(strokeOf({0, 0, 0.4}, still).u, Vec2(0.0)) << "straight up is no stroke along the cloth";
  EXPECT_EQ(strokeOf(Vec3(0.0), still).towards, Vec3(0.0));
  EXPECT_FALSE(std::signbit(strokeOf({-0.15, 0, 0}, still).u.y));
  // On a puck at rest: p = m c u, and its cost m c² (γ − 1).
  for (const double u : {0.001, 0.2, 1.0, 3.0}) EXPECT_NEAR(costOf(u), std::hypot(1.0, u) - 1.0, 1e-15);
}

// Where the hand points beside the centre, across the stroke, seen from above; the room's axes here are the
// board's.
TEST(Cue, StrikesWhereTheHandPointsBesideTheCentre) {
  const Lorentz still(1.42);
  const double radius_m = 0.03;
  EXPECT_EQ(sideOf({0.0, -0.01, 0.0}, {2.0, 0.0}, still, radius_m), 0.01) << "right of a stroke along x";
  EXPECT_EQ(sideOf({0.0, 0.01, 0.0}, {2.0, 0.0}, still, radius_m), -0.01);
  EXPECT_EQ(sideOf({0.5, 0.0, 0.2}, {2.0, 0.0}, still, radius_m), 0.0) << "nearer or higher is not beside";
  EXPECT_EQ(sideOf({0.0, 0.003, 0.0}, {2.0, 0.0}, still, radius_m), 0.0) << "a hand trembles";
  EXPECT_EQ(sideOf({0.02, 0.0, 0.0}, {0.0, 1.0}, still, radius_m), 0.015) << "half of the radius at most";
  EXPECT_EQ(sideOf({0.02, 0.0, 0.0}, {0.0, 0.0}, still, radius_m), 0.0) << "no stroke";
}

// A person on a platform points along the table: the stroke goes there, whatever the platform's motion; and
// the way that is shown in the room is the opposite of the pull where that is level.
TEST(Cue, TheWayOfAStrokeIsTurnedWithTheRoomNotBoosted) {
  const double c_m_s = 1.42;
  const RoomAxes axes;  // of a rig: x right, y up, z back
  test::Random random(11);
  for (int i = 0; i < 200; ++i) {
    CASE(random, i);
    const double facing_rad = random.in(-std::numbers::pi, std::numbers::pi);
    const Vec3 forward(std::cos(facing_rad), std::sin(facing_rad), 0.0), up(0.0, 0.0, 1.0);
    const glm::dmat3 board(glm::cross(forward, up), forward, up);
    const glm::dmat3 room(axes.right, axes.forward, axes.up);
    const Vec3 beta = Vec3(std::cos(0.7 * i), std::sin(0.7 * i), 0.0) * random.in(0.0, 0.95);
    const Lorentz boardFromRoom =
        Lorentz::boost(uFromBeta(beta), c_m_s) *
        Lorentz::rotation(glm::normalize(glm::quat_cast(board * glm::transpose(room))), c_m_s);
    SCOPED_TRACE(testing::Message() << "seed 11, case " << i << ", facing " << facing_rad);
    // Back by 0.1 m, up by some, to the right by 0.05 m: the stroke goes forward and to the left.
    const CueStroke stroke =
        strokeOf(-0.1 * axes.forward + random.in(-0.3, 0.3) * axes.up + 0.05 * axes.right, boardFromRoom);
    const Vec3 expected = (0.1 * forward - 0.05 * glm::cross(forward, up)) / kPullForOne_m;
    EXPECT_NEAR(stroke.u.x, expected.x, 1e-12);
    EXPECT_NEAR(stroke.u.y, expected.y, 1e-12);
    const Vec3 shown = glm::normalize(0.1 * axes.forward - 0.05 * axes.right);
    EXPECT_LT(glm::distance(stroke.towards, shown), 1e-12);
  }
}

}  // namespace
}  // namespace carom
