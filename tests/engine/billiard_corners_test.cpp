// Games of discs and bodies with corners.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <random>
#include <stdexcept>

#include "engine/billiard/billiard.h"
#include "engine/billiard/setup_check.h"

namespace carom {
namespace {

constexpr double kC_m_s = 1.42;

std::vector<Vec2> rectangle(double length_m, double width_m) {
  const double x = 0.5 * length_m, y = 0.5 * width_m;
  return {{-x, -y}, {x, -y}, {x, y}, {-x, y}};
}

std::vector<Vec2> regular(int corners, double radius_m, double angle_rad) {
  std::vector<Vec2> outline_m;
  for (int k = 0; k < corners; ++k) {
    const double at = angle_rad + 2.0 * M_PI * k / corners;
    outline_m.push_back({radius_m * std::cos(at), radius_m * std::sin(at)});
  }
  return outline_m;
}

Puck bodyOf(const std::string& name, const std::vector<Vec2>& outline_m) {
  Puck puck;
  puck.name = name;
  puck.outline_m = outline_m;
  puck.radius_m = radiusOf_m(outline_m);
  puck.height_m = 0.02, puck.mass_kg = 0.2, puck.inertia = 0.3;
  return puck;
}

/// Discs, bars, regular polygons and U shapes, with spin, with and without friction, elastic and not.
BilliardSetup randomSetup(unsigned seed) {
  std::mt19937_64 random(seed);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  BilliardSetup setup;
  setup.lightSpeed_m_s = kC_m_s;
  setup.board = Board{2.84, 1.42};
  PhysicsRules& rules = setup.rules;
  if (seed % 3 != 0) rules.puckRestitution = uniform(0.0, 1.0), rules.cushionRestitution = uniform(0.0, 1.0);
  if (seed % 2 != 0) rules.puckFriction = uniform(0.0, 1.0), rules.cushionFriction = uniform(0.0, 1.0);
  rules.tangentialRestitution = uniform(0.0, 1.0);
  if (seed % 5 == 4) rules.collisionEvent = CollisionEvent::contact;
  const int count = 2 + static_cast<int>(seed % 12);
  for (int tries = 0; tries < 1000 && static_cast<int>(setup.pucks.size()) < count; ++tries) {
    const int kind = static_cast<int>(uniform(0.0, 4.0));
    std::vector<Vec2> outline_m;
    if (kind == 1) outline_m = rectangle(uniform(0.06, 0.12), uniform(0.01, 0.03));
    if (kind == 2)
      outline_m = regular(3 + static_cast<int>(uniform(0, 6)), uniform(0.02, 0.06), uniform(0, 6));
    if (kind == 3)
      outline_m = {{0.05, -0.04},  {0.05, 0.04},  {0.03, 0.04},  {0.03, -0.02},
                   {-0.03, -0.02}, {-0.03, 0.04}, {-0.05, 0.04}, {-0.05, -0.04}};
    Puck puck = bodyOf(std::string(1, static_cast<char>('a' + setup.pucks.size())), outline_m);
    if (kind == 0) puck.radius_m = uniform(0.02, 0.05);
    puck.mass_kg = uniform(0.05, 0.5), puck.inertia = uniform(0.2, 1.0);
    puck.position_m = {uniform(-1.3, 1.3), uniform(-0.6, 0.6)};
    const double at = uniform(0.0, 2.0 * M_PI), speed = uniform(0.0, 0.8);
    puck.beta = {speed * std::cos(at), speed * std::sin(at)};
    puck.spin_kg_m2_s = spinOfRim_kg_m2_s(puck, uniform(-1.0, 1.0), kC_m_s);
    setup.pucks.push_back(puck);
    try {
      checkSetup(setup);
    } catch (const std::invalid_argument&) {
      setup.pucks.pop_back();
    }
  }
  return setup;
}

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

TEST(BilliardCorners, RandomGamesKeepFourMomentumAndTheTable) {
  std::size_t collisions = 0;
  for (unsigned seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE(seed);
    const BilliardSetup setup = randomSetup(seed);
    Billiard game(setup);
    const Ledger before = game.ledger();
    game.advanceTo(6.0);
    const Ledger now = game.ledger();
    const double energy_j =
        now.motion.energy_j + now.radiated.energy_j + now.takenByCushions.energy_j - before.motion.energy_j;
    const Vec2 momentum = now.motion.momentum_kg_m_s + now.radiated.momentum_kg_m_s +
                          now.takenByCushions.momentum_kg_m_s - before.motion.momentum_kg_m_s;
    EXPECT_LE(std::abs(energy_j), 1e-10 * before.motion.energy_j);
    EXPECT_LE(glm::length(momentum) * kC_m_s, 1e-10 * before.motion.energy_j);
    for (const WorldLine& line : game.worldLines()) {
      for (const Knot& knot : line.knots()) {
        EXPECT_LE(std::abs(knot.turn.r_m.x), 1.42 + 1e-9);
        EXPECT_LE(std::abs(knot.turn.r_m.y), 0.71 + 1e-9);
      }
    }
    for (const GameEvent& event : game.events()) EXPECT_GE(event.heat_j, -1e-15);
    collisions += game.events().size();
  }
  EXPECT_GT(collisions, 1000u);
}

TEST(BilliardCorners, TheOrderInTheSetupAndTheStepsChangeNoBit) {
  for (unsigned seed = 5; seed <= 14; ++seed) {
    SCOPED_TRACE(seed);
    const BilliardSetup setup = randomSetup(seed);
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
  BilliardSetup setup = randomSetup(7);
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

// Two of its bodies hook into each other while a third pushes them: if every kick at one corner sent the next into
// the other to the last digit, there would be 1800 events.
TEST(BilliardCorners, HookedBodiesComeToRestWithinAFewKicks) {
  Billiard game(randomSetup(1030));
  game.advanceTo(4.0);
  EXPECT_GT(game.events().size(), 50u);
  EXPECT_LT(game.events().size(), 500u);
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

TEST(BilliardCorners, MirrorImagesAreMirrored) {
  const BilliardSetup setup = twoBars();
  BilliardSetup mirrored = setup;
  for (Puck& puck : mirrored.pucks) {
    puck.position_m.y *= -1.0, puck.beta.y *= -1.0;
    for (Vec2& corner : puck.outline_m) corner.y *= -1.0;
    std::reverse(puck.outline_m.begin(), puck.outline_m.end());
  }
  Billiard game(setup), image(mirrored);
  game.advanceTo(3.0), image.advanceTo(3.0);
  ASSERT_EQ(game.events().size(), image.events().size());
  ASSERT_GE(game.events().size(), 1u);
  for (std::size_t i = 0; i < 2; ++i) {
    const Knot &one = game.worldLines()[i].knots().back(), &other = image.worldLines()[i].knots().back();
    EXPECT_NEAR(one.turn.t_s, other.turn.t_s, 1e-13);
    EXPECT_NEAR(one.u.x, other.u.x, 1e-13);
    EXPECT_NEAR(one.u.y, -other.u.y, 1e-13);
    EXPECT_NEAR(one.spin.omega_rad_s, -other.spin.omega_rad_s, 1e-11);
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
