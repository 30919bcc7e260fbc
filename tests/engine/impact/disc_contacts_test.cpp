// Discs that meet head on, and straight at a cushion: closed forms.
#include "engine/impact/disc_contacts.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>

#include "engine/impact/contact_finder.h"

namespace carom {
namespace {

constexpr double kDiscRadius_m = 0.05, kMass_kg = 0.2, kApart_m = 0.6;

/// Two discs that come towards each other with ±beta.
GameState headOn(double beta, CollisionEvent event) {
  BilliardSetup setup;
  setup.lightSpeed_m_s = 1.0;
  setup.board = Board{2.0, 2.0};
  setup.rules.collisionEvent = event;
  setup.pucks = {Puck{"a", kDiscRadius_m, 0.02, kMass_kg, {-0.5 * kApart_m, 0.0}, {beta, 0.0}},
                 Puck{"b", kDiscRadius_m, 0.02, kMass_kg, {0.5 * kApart_m, 0.0}, {-beta, 0.0}}};
  return GameState(setup);
}

// The rims are at R/γ before the centres, and the rims' light needs R of the centre's own time to it.
TEST(DiscPair, MeetsWhereTheContractedRimsDo) {
  for (const double beta : {0.1, 0.5, 0.9, 0.99}) {
    SCOPED_TRACE(beta);
    const GameState game = headOn(beta, CollisionEvent::centre);
    const double gamma = 1.0 / std::sqrt(1.0 - beta * beta);
    const GameContact found = kDiscPair.contactOf(game, {0, 1}, false);
    EXPECT_NEAR(found.contact.event.t, (0.5 * kApart_m - kDiscRadius_m / gamma) / beta, 1e-11);
    EXPECT_NEAR(found.contact.event.x, 0.0, 1e-11);
    EXPECT_NEAR(found.contact.event.y, 0.0, 1e-11);
    EXPECT_EQ(found.jam, JamLaw::plastic);
    const auto meeting = kDiscPair.meetingOf(game, {0, 1});
    ASSERT_TRUE(meeting);
    EXPECT_FALSE(meeting->withoutDelay);
    EXPECT_NEAR(meeting->ownTime[0], meeting->ownTime[1], 1e-11);
    EXPECT_FALSE(kDiscPair.haveMet(game, 0, 1));
    GameContact touched = found;
    EXPECT_FALSE(kDiscPair.recede(game, {0, 1}, false, touched));
  }
  EXPECT_FALSE(kDiscPair.meetingOf(headOn(-0.5, CollisionEvent::centre), {0, 1})) << "they recede";
}

// Equal discs that meet head on: elastic ones turn round, plastic ones stop, and their energy is their heat.
TEST(DiscPair, KicksByItsRestitution) {
  const double beta = 0.6, gamma = 1.25;
  const GameState game = headOn(beta, CollisionEvent::centre);
  const GameContact found = kDiscPair.contactOf(game, {0, 1}, false);
  const std::array<Vec21, 2> u{game.discs[0].u, game.discs[1].u};
  const auto elastic = kDiscPair.kick(game, {0, 1}, found.contact, u, {0.0, 0.0}, 1.0);
  const auto plastic = kDiscPair.kick(game, {0, 1}, found.contact, u, {0.0, 0.0}, 0.0);
  ASSERT_TRUE(elastic && plastic);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_NEAR(elastic->centres.u[k].x, -u[k].x, 1e-11);
    EXPECT_NEAR(elastic->centres.heat[k], 0.0, 1e-11);
    EXPECT_NEAR(plastic->centres.u[k].x, 0.0, 1e-11);
    EXPECT_NEAR(plastic->centres.heat[k], (gamma - 1.0) * game.massOf(static_cast<int>(k), 0.0), 1e-11);
  }
  EXPECT_FALSE(kDiscPair.kick(game, {0, 1}, found.contact, {u[1], u[0]}, {0.0, 0.0}, 1.0)) << "they recede";
}

// The cushion lies R from the centre in the disc's own frame, which is R/γ on the board; the centre turns
// R of its own time later.
TEST(DiscAtCushion, TouchesWithItsContractedRim) {
  for (const double beta : {0.1, 0.5, 0.9}) {
    SCOPED_TRACE(beta);
    const GameState game = headOn(beta, CollisionEvent::centre);
    const double gamma = 1.0 / std::sqrt(1.0 - beta * beta), wall_m = game.rules.cushions[0].distance,
                 way_m = wall_m + 0.5 * kApart_m;
    const auto found = kDiscAtCushion.touchOf(game, 0, game.legOf(0), {}, 0);
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->event.t, (way_m - kDiscRadius_m / gamma) / beta, 1e-11);
    EXPECT_NEAR(found->event.x, wall_m, 1e-11);
    EXPECT_NEAR(found->event.y, 0.0, 1e-11);
    const double own = (way_m - gamma * kDiscRadius_m) / (gamma * beta) + kDiscRadius_m;
    EXPECT_NEAR(found->turn.properTime, own, 1e-11);
    EXPECT_NEAR(found->turn.x.t, gamma * own, 1e-11);
    const auto kick = kDiscAtCushion.kick(game, 0, 0, found->event, found->turn, 0.0, 1.0);
    ASSERT_TRUE(kick);
    EXPECT_NEAR(kick->centre.u.x, -gamma * beta, 1e-11);
    EXPECT_FALSE(kDiscAtCushion.touchOf(game, 1, game.legOf(1), {}, 0)) << "it moves away";
  }
}

}  // namespace
}  // namespace carom
