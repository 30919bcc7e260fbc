#include "engine/linked/final_digest.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "engine/billiard/billiard.h"
#include "engine/three_pucks.h"

namespace carom {
namespace {

std::vector<std::string> namesOf(const BilliardSetup& setup) {
  std::vector<std::string> names;
  for (const Puck& puck : setup.pucks) names.push_back(puck.name);
  return names;
}

std::uint64_t digestAt(const Billiard& game, const BilliardSetup& setup, double final_s) {
  FinalDigest digest(namesOf(setup));
  digest.add(game.worldLines(), final_s);
  return digest.value();
}

Billiard played(const BilliardSetup& setup) {
  Billiard game(setup);
  game.advanceTo(20.0);
  return game;
}

TEST(FinalDigest, IsTheSameInAnyStepsAndAfterForgetting) {
  const BilliardSetup setup = test::threePucks();
  const std::uint64_t whole = digestAt(played(setup), setup, 15.5);
  Billiard game(setup);
  FinalDigest digest(namesOf(setup));
  for (double t_s = 0.0; t_s <= 15.5; t_s += 0.7) {
    game.advanceTo(t_s + 2.0);
    digest.add(game.worldLines(), t_s);
    game.forgetBefore(digest.second() - 0.5);
  }
  digest.add(game.worldLines(), 15.5);
  EXPECT_EQ(digest.second(), 15U);
  EXPECT_EQ(digest.value(), whole);
}

TEST(FinalDigest, TakesPucksByTheirNames) {
  const BilliardSetup setup = test::threePucks();
  BilliardSetup turned = setup;
  std::reverse(turned.pucks.begin(), turned.pucks.end());
  EXPECT_EQ(digestAt(played(turned), turned, 15.0), digestAt(played(setup), setup, 15.0));
}

// One bit of one turn: from the second of that turn on, and not before.
TEST(FinalDigest, NoticesOneBitFromItsSecondOn) {
  const BilliardSetup setup = test::threePucks();
  const Billiard game = played(setup);
  const Knots knots = game.worldLines()[2].knots();
  ASSERT_GT(knots.size(), 3U);
  std::vector<WorldLine> changed(game.worldLines().begin(), game.worldLines().end());
  changed[2] = WorldLine(knots.front(), setup.lightSpeed_m_s, setup.pucks[2].radius_m);
  const std::size_t which = 3;
  for (std::size_t i = 1; i < knots.size(); ++i) {
    Knot knot = knots[i];
    if (i == which) knot.u.x = std::nextafter(knot.u.x, 2.0);
    changed[2].append(knot);
  }
  FinalDigest before(namesOf(setup)), after(namesOf(setup));
  const auto second = static_cast<std::uint32_t>(knots[which].turn.t_s) + 1;
  for (std::uint32_t k = 1; k <= 15; ++k) {
    before.add(game.worldLines(), k);
    after.add(changed, k);
    EXPECT_EQ(before.value() == after.value(), k < second) << k << ", the turn is before " << second;
  }
}

// The same on every machine and with every compiler; a change of the physics changes it, and this number.
TEST(FinalDigest, TheFingerprintOfTheArithmetic) { EXPECT_EQ(arithmeticFingerprint(), 5896099606358761563U); }

}  // namespace
}  // namespace carom
