// Games of discs and bodies with corners.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <random>
#include <stdexcept>

#include "engine/billiard/billiard.h"
#include "engine/billiard/collision_scheduler.h"
#include "engine/corner_games.h"
#include "engine/light_speed.h"

namespace carom {
namespace {

using test::bodyOf, test::cornerGame, test::kC_m_s, test::rectangle;

/// All numbers of a world line up to a time; a game may know a little more.
std::vector<double> digitsOf(const WorldLine& line, double until_s) {
  std::vector<double> digits;
  for (const Knot& knot : line.knots()) {
    if (knot.turn.t_s > until_s) break;
    digits.insert(digits.end(), {knot.turn.t_s, knot.turn.r_m.x, knot.turn.r_m.y, knot.u.x, knot.u.y,
                                 knot.properTime_s, knot.signal.t_s, knot.signal.r_m.x, knot.signal.r_m.y,
                                 knot.spin.angle_rad, knot.spin.omega_rad_s});
  }
  return digits;
}

// Of pairs that touch once both have turned, none goes on, nor do those that are still in each other since
// they met.
TEST(BilliardCorners, RandomGamesKeepFourMomentumAndTheTableAndPart) {
  test::CornerTally tally;
  for (unsigned seed = 1; seed <= 60; ++seed)
    test::checkCornerGame(cornerGame(seed), 6.0, "seed " + std::to_string(seed), tally);
  for (const std::string& fault : tally.faults) ADD_FAILURE() << fault;
  EXPECT_GT(tally.collisions, 1000u);
  EXPECT_GT(tally.touching, 100u);
  EXPECT_GT(tally.inEachOther, 50u);
  EXPECT_EQ(tally.approaching, 0u) << tally.fastestApproach;
}

// Forty bodies and more are looked for in cells. A game without cushions of which the cells are full of
// bodies at rest far away has the bits of the one without them.
TEST(BilliardCorners, CellsChangeNoBit) {
  for (unsigned seed = 12; seed <= 38; seed += 13) {
    SCOPED_TRACE(seed);
    BilliardSetup setup = cornerGame(seed, 14);
    setup.board.reset();
    for (Puck& puck : setup.pucks) puck.beta = puck.position_m * (-0.7 / glm::length(puck.position_m));
    BilliardSetup crowded = setup;
    for (int k = 0; k < 30; ++k) {
      Puck far = bodyOf("z" + std::to_string(k), rectangle(0.04, 0.04));
      far.position_m = {6.0 + 0.1 * (k % 6), 6.0 + 0.1 * (k / 6)};
      crowded.pucks.push_back(far);
    }
    Billiard game(setup), again(crowded);
    game.advanceTo(4.0), again.advanceTo(4.0);
    EXPECT_GT(game.events().size(), 5u);
    for (std::size_t i = 0; i < setup.pucks.size(); ++i)
      EXPECT_EQ(digitsOf(game.worldLines()[i], 4.0), digitsOf(again.worldLines()[i], 4.0)) << i;
  }
}

TEST(BilliardCorners, ManyBodiesOnOneTableKeepFourMomentum) {
  test::CornerTally tally;
  const BilliardSetup setup = cornerGame(44, 46);
  EXPECT_GT(setup.pucks.size(), 40u);
  test::checkCornerGame(setup, 0.8, "46 bodies", tally);
  for (const std::string& fault : tally.faults) ADD_FAILURE() << fault;
  EXPECT_GT(tally.collisions, 50u);
}

TEST(BilliardCorners, TheOrderInTheSetupAndTheStepsChangeNoBit) {
  for (unsigned seed = 5; seed <= 14; ++seed) {
    SCOPED_TRACE(seed);
    const BilliardSetup setup = cornerGame(seed);
    BilliardSetup other = setup;
    std::reverse(other.pucks.begin(), other.pucks.end());
    Billiard game(setup), again(other);
    game.advanceTo(4.0);
    for (double t_s = 0.25; t_s <= 4.0; t_s += 0.25) again.advanceTo(t_s);
    const std::size_t count = setup.pucks.size();
    for (std::size_t i = 0; i < count; ++i)
      EXPECT_EQ(digitsOf(game.worldLines()[i], 4.0), digitsOf(again.worldLines()[count - 1 - i], 4.0)) << i;
  }
}

TEST(BilliardCorners, AStrokeReplaysTheRest) {
  BilliardSetup setup = cornerGame(7);
  Billiard game(setup);
  game.advanceTo(3.0);
  const Stroke stroke{0, 1.0, std::nullopt, {0.05, 0.1}, 0.005};
  game.strike(stroke);
  setup.strokes.push_back(stroke);
  Billiard known(setup);
  known.advanceTo(3.0);
  for (std::size_t i = 0; i < setup.pucks.size(); ++i)
    EXPECT_EQ(digitsOf(game.worldLines()[i], 3.0), digitsOf(known.worldLines()[i], 3.0)) << i;
}

// Blocks side by side in a corner of the table, into which a bar drives: they come to rest within a few
// kicks.
TEST(BilliardCorners, APileInACornerComesToRest) {
  for (const double restitution : {0.0, 0.3, 0.9, 1.0}) {
    SCOPED_TRACE(restitution);
    BilliardSetup setup;
    setup.lightSpeed_m_s = kC_m_s;
    setup.board = Board{2.84, 1.42};
    setup.rules.puckRestitution = setup.rules.cushionRestitution = restitution;
    for (int k = 0; k < 12; ++k) {
      Puck block = bodyOf(std::string(1, static_cast<char>('a' + k)), rectangle(0.06, 0.06));
      block.position_m = {1.42 - 0.0301 - 0.0602 * (k % 4), 0.71 - 0.0301 - 0.0602 * (k / 4)};
      setup.pucks.push_back(block);
    }
    Puck bar = bodyOf("z", rectangle(0.12, 0.03));
    bar.position_m = {0.5, 0.1}, bar.beta = {0.55, 0.4};
    setup.pucks.push_back(bar);
    test::CornerTally tally;
    test::checkCornerGame(setup, 4.0, "pile", tally);
    for (const std::string& fault : tally.faults) ADD_FAILURE() << fault;
    EXPECT_GT(tally.collisions + tally.jams, 20u);
    EXPECT_LT(tally.collisions + tally.jams, 3000u);
  }
}

// Two places of a U would kick an elastic disc between them without end.
TEST(BilliardCorners, AnElasticDiscThatAHookHoldsIsKickedFewTimes) {
  const BilliardSetup setup = cornerGame(13587);
  ASSERT_EQ(setup.rules.puckRestitution, 1.0);
  Billiard game(setup);
  for (double t_s = 0.0; t_s <= 6.0; t_s += 0.05) {
    game.advanceTo(t_s);
    ASSERT_LT(game.events().size(), 1000u) << "at " << t_s << " s";
  }
  EXPECT_GT(game.events().size(), 100u);
}

// Two rough cushions turn a disc by turns, and slow it each time, at one moment.
TEST(BilliardCorners, ADiscInACornerOfRoughCushionsComesToRest) {
  const BilliardSetup setup = cornerGame(1535);
  CollisionScheduler game(setup);
  GameHistory history(setup);
  EXPECT_TRUE(game.playUntil(6.0 * kC_m_s, 2000, history));
  EXPECT_GT(history.eventCount(), 20u);
}

BilliardSetup twoBars() {
  BilliardSetup setup;
  setup.lightSpeed_m_s = kC_m_s;
  Puck left = bodyOf("left", rectangle(0.04, 0.12)), right = bodyOf("right", rectangle(0.12, 0.02));
  left.position_m = {-0.5, 0.02}, left.beta = {0.6, 0.0};
  right.position_m = {0.5, 0.0}, right.beta = {-0.6, 0.1};
  setup.pucks = {left, right};
  return setup;
}

// To the last bit and to the end of the game.
TEST(BilliardCorners, MirrorImagesAreMirrored) {
  std::size_t events = 0;
  for (unsigned seed = 1; seed <= 60; ++seed) {
    const BilliardSetup setup = cornerGame(seed);
    Billiard game(setup);
    game.advanceTo(3.0);
    events += game.events().size();
    for (const Vec2 signs : {Vec2{1.0, -1.0}, Vec2{-1.0, 1.0}}) {
      SCOPED_TRACE(testing::Message() << "seed " << seed << ", " << (signs.x < 0.0 ? "x" : "y") << " turned");
      Billiard image(test::mirrored(setup, signs));
      image.advanceTo(3.0);
      EXPECT_EQ(test::eventDigits(game, {1.0, 1.0}), test::eventDigits(image, signs));
    }
  }
  EXPECT_GT(events, 1000u);
}

// The corners of a bar pass another body in each turn, a little nearer each time: hundreds of turns later one
// touches.
TEST(BilliardCorners, ABarThatTurnsBesideABodyMeetsItInTheEnd) {
  constexpr double kGap_m = 2e-6, kDrift = 1e-8,
                   kTurning = 8.0;  // metres, over c, radians in a metre of light
  for (const bool disc : {false, true}) {
    SCOPED_TRACE(disc ? "disc" : "square");
    BilliardSetup setup;
    setup.lightSpeed_m_s = kC_m_s;
    Puck bar = bodyOf("bar", rectangle(0.12, 0.02));
    bar.spin_kg_m2_s = spinOfRim_kg_m2_s(bar, kTurning * bar.radius_m, kC_m_s);
    Puck other = bodyOf("other", rectangle(0.08, 0.08));
    if (disc) other = bodyOf("other", {}), other.radius_m = 0.04;
    other.position_m = {bar.radius_m + 0.04 + kGap_m, 0.0}, other.beta = {-kDrift, 0.0};
    setup.pucks = {bar, other};
    Billiard game(setup);
    const double earliest_s = kGap_m / kDrift / kC_m_s, turn_s = 2.0 * M_PI / kTurning / kC_m_s;
    game.advanceTo(earliest_s + 2.0 * turn_s);
    ASSERT_GE(game.events().size(), 1u);
    EXPECT_GE(game.events()[0].at.t_s, earliest_s);
    EXPECT_LE(game.events()[0].at.t_s, earliest_s + turn_s);
  }
}

TEST(BilliardCorners, SquaresFaceToFaceAreJournalledAsSideOnSide) {
  BilliardSetup setup;
  setup.lightSpeed_m_s = kC_m_s;
  Puck left = bodyOf("left", rectangle(0.08, 0.08)), right = bodyOf("right", rectangle(0.08, 0.08));
  left.position_m = {-0.5, 0.0}, left.beta = {0.6, 0.0};
  right.position_m = {0.5, 0.0}, right.beta = {-0.6, 0.0};
  setup.pucks = {left, right};
  Billiard game(setup);
  game.advanceTo(2.0);
  ASSERT_EQ(game.events().size(), 1u);
  EXPECT_TRUE(game.events()[0].sideOnSide);
  EXPECT_NEAR(game.events()[0].at.r_m.x, 0.0, 1e-15);
  EXPECT_NEAR(game.worldLines()[0].knots().back().u.x, -0.75, 1e-14);
  EXPECT_EQ(game.worldLines()[0].knots().back().spin.omega_rad_s, 0.0);
}

TEST(BilliardCorners, WhatCannotBePlayedIsRefused) {
  BilliardSetup setup = twoBars();
  const auto expectRefused = [](const BilliardSetup& wrong, const std::string& part) {
    try {
      const Billiard game(wrong);
      ADD_FAILURE() << "played, expected: " << part;
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
  };
  BilliardSetup wrong = setup;
  std::reverse(wrong.pucks[0].outline_m.begin(), wrong.pucks[0].outline_m.end());
  expectRefused(wrong, "clockwise");
  wrong = setup, wrong.pucks[0].radius_m = 0.01;
  expectRefused(wrong, "farthest corner");
  wrong = setup, wrong.rules.friction_m_s2 = 0.1;
  expectRefused(wrong, "corners");
  wrong = setup, wrong.pucks[0].position_m = {0.45, 0.0};
  expectRefused(wrong, "overlap");
  wrong = setup, wrong.board = Board{1.06, 1.0};
  expectRefused(wrong, "corners reach");
}

}  // namespace
}  // namespace carom
