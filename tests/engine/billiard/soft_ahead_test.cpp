// What a thread plays ahead is what would have been played without it, whenever it is asked for.

#include <gtest/gtest.h>

#include <chrono>
#include <cstring>
#include <thread>

#include "engine/billiard/billiard.h"
#include "engine/billiard/soft_row_book.h"

namespace carom {
namespace {

Puck disc(const std::string& name, const Vec2& position_m, const Vec2& beta, bool isSoft) {
  Puck puck;
  puck.name = name;
  puck.radius_m = 0.0305;
  puck.height_m = 0.02;
  puck.mass_kg = 0.2;
  puck.position_m = position_m;
  puck.beta = beta;
  if (isSoft) puck.soft = SoftMatter{0.5, 5, 0.3, {}};
  return puck;
}

BilliardSetup game() {
  BilliardSetup setup;
  setup.lightSpeed_m_s = 1.42;
  setup.board = Board{0.8, 0.6};
  setup.pucks = {disc("one", {0.1, 0.01}, {-0.2, 0.0}, false), disc("jelly", {-0.2, 0.0}, {0.4, 0.0}, true),
                 disc("two", {0.2, -0.1}, {0.0, 0.3}, true), disc("far", {0.3, 0.2}, {0.3, 0.0}, false)};
  return setup;
}

void expectSame(const Billiard& a, const Billiard& b, double t_s) {
  for (std::size_t i = 0; i < a.worldLines().size(); ++i) {
    EXPECT_EQ(a.worldLines()[i].knots().size(), b.worldLines()[i].knots().size()) << i;
    const Motion one = a.worldLines()[i].at(t_s), two = b.worldLines()[i].at(t_s);
    EXPECT_EQ(one.event.r_m, two.event.r_m) << i << ' ' << t_s;
    EXPECT_EQ(one.u, two.u) << i << ' ' << t_s;
  }
  ASSERT_EQ(a.events().size(), b.events().size());
  for (std::size_t k = 0; k < a.events().size(); ++k) {
    EXPECT_EQ(a.events()[k].kind, b.events()[k].kind);
    EXPECT_EQ(a.events()[k].at.t_s, b.events()[k].at.t_s);
    EXPECT_EQ(a.events()[k].heat_j, b.events()[k].heat_j);
  }
  EXPECT_EQ(a.ledger().motion.energy_j, b.ledger().motion.energy_j);
  const SoftMoment one = a.softAt(t_s), two = b.softAt(t_s);
  ASSERT_EQ(one.contacts.size(), two.contacts.size());
  for (std::size_t k = 0; k < one.contacts.size(); ++k) {
    EXPECT_EQ(one.contacts[k].parted_s, two.contacts[k].parted_s);
    EXPECT_EQ(one.contacts[k].heat_j, two.contacts[k].heat_j);
  }
  for (std::size_t i = 0; i < one.pucks.size(); ++i) {
    ASSERT_EQ(one.pucks[i].has_value(), two.pucks[i].has_value());
    if (!one.pucks[i]) continue;
    EXPECT_EQ(one.pucks[i]->heat_j, two.pucks[i]->heat_j);
  }
}

/// The same rows come at the same time, and the same are taken back.
void expectSameRows(Billiard& a, Billiard& b) {
  SoftRows one, two;
  a.takeSoftRows(one), b.takeSoftRows(two);
  EXPECT_EQ(one.truncatedFrom, two.truncatedFrom);
  ASSERT_EQ(one.rows.size(), two.rows.size());
  ASSERT_EQ(one.nodes.size(), two.nodes.size());
  if (one.rows.empty()) return;  // each row has nodes
  EXPECT_EQ(std::memcmp(one.rows.data(), two.rows.data(), one.rows.size() * sizeof(SoftRow)), 0);
  EXPECT_EQ(std::memcmp(one.nodes.data(), two.nodes.data(), one.nodes.size() * sizeof(SoftNode)), 0);
}

// Rigid pucks come in, hands strike now and then: at times that the thread cannot know.
TEST(SoftAhead, PlaysTheSameBits) {
  Billiard ahead(game()), plain(game());
  ahead.playAhead();
  int frame = 0;
  for (double t_s = 0.0; t_s < 1.6; t_s += 0.02, ++frame) {
    if (frame % 10 == 3) std::this_thread::sleep_for(std::chrono::milliseconds(20));
    for (Billiard* one : {&ahead, &plain}) {
      one->advanceTo(t_s);
      if (frame != 12 && frame != 40) continue;
      one->strike({.puck = frame == 12 ? 1u : 2u,
                   .at_s = t_s,
                   .from_m = Vec3(0.0, 0.3, 0.2),
                   .momentum_kg_m_s = {0.02, -0.1}});
    }
    if (frame % 8 == 0) expectSame(ahead, plain, t_s);
    if (frame % 3 == 0) expectSameRows(ahead, plain);
  }
  expectSame(ahead, plain, 1.5);
  EXPECT_GT(plain.events().size(), 8u);
}

// A stroke before anything has been kept takes the game back to its very beginning.
TEST(SoftAhead, BeginsAgainFromTheBeginning) {
  Billiard ahead(game()), plain(game());
  ahead.playAhead();
  for (Billiard* one : {&ahead, &plain}) {
    one->advanceTo(0.3);
    one->strike({.puck = 1, .at_s = 0.001, .from_m = std::nullopt, .momentum_kg_m_s = {0.05, 0.05}});
    one->advanceTo(0.8);
  }
  expectSame(ahead, plain, 0.8);
}

// A game that is given up does not wait for what is played ahead, and leaves no thread.
TEST(SoftAhead, EndsAtOnce) {
  for (int k = 0; k < 20; ++k) {
    Billiard billiard(game());
    billiard.playAhead();
    if (k % 2 == 0) billiard.advanceTo(0.1);
  }
}

}  // namespace
}  // namespace carom
