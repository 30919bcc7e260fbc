#include "engine/billiard/billiard.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "engine/balance.h"
#include "engine/gas.h"
#include "engine/three_pucks.h"
#include "sanitized.h"

namespace carom {
namespace {

using namespace test;

std::string refusal(const std::function<void(BilliardSetup&)>& spoil) {
  BilliardSetup setup = threePucks();
  spoil(setup);
  try {
    Billiard billiard(setup);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(Billiard, refusesWhatCannotBePlayed) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(refusal([](BilliardSetup&) {}), "");
  const auto names = [](const std::string& text, const std::string& part) {
    EXPECT_NE(text.find(part), std::string::npos) << '"' << text << "\" does not say " << part;
  };
  names(refusal([](BilliardSetup& s) { s.pucks[1].position_m = {-0.9, 0.05}; }), "\"white\" at (-0.9");
  names(refusal([](BilliardSetup& s) { s.pucks[2].position_m.x = 1.41; }), "\"red\"");
  names(refusal([](BilliardSetup& s) { s.pucks[2].position_m.x = 1.41; }), "+x cushion");
  names(refusal([](BilliardSetup& s) { s.pucks[0].beta = {0.8, 0.6}; }), "speed of 1");
  names(refusal([](BilliardSetup& s) { s.pucks[0].radius_m = 0.0; }), "radius 0");
  names(refusal([](BilliardSetup& s) { s.pucks[0].mass_kg = -1.0; }), "mass -1");
  names(refusal([&](BilliardSetup& s) { s.pucks[0].mass_kg = nan; }), "mass nan");
  names(refusal([&](BilliardSetup& s) { s.pucks[0].position_m.y = nan; }), "position");
  names(refusal([&](BilliardSetup& s) { s.pucks[0].beta.y = nan; }), "beta");
  names(refusal([](BilliardSetup& s) { s.pucks[1].name = "red"; }), "named \"red\"");
  names(refusal([](BilliardSetup& s) { s.lightSpeed_m_s = 0.0; }), "light speed 0");
  names(refusal([](BilliardSetup& s) { s.rules.puckRestitution = 1.5; }), "restitution 1.5");
  names(refusal([](BilliardSetup& s) { s.rules.friction_m_s2 = 40.0; }), "c²/2");
  names(refusal([](BilliardSetup& s) { s.board->width_m = -1.0; }), "board");
  names(refusal([](BilliardSetup& s) { s.strokes = {{7, 0.0, std::nullopt, {0.1, 0.0}}}; }), "no puck 7");
}

// Contraction makes room: two pucks side by side along their motion overlap at rest, not at γ = 2.
TEST(Billiard, pucksOverlapAsTheBoardShowsThem) {
  BilliardSetup setup = threePucks();
  setup.pucks = {{"a", 0.03, 0.02, 0.2, {0.0, 0.0}, {0.0, 0.0}},
                 {"b", 0.03, 0.02, 0.2, {0.05, 0.0}, {0.0, 0.0}}};
  EXPECT_THROW(Billiard{setup}, std::invalid_argument);
  for (Puck& puck : setup.pucks) puck.beta = {std::sqrt(0.75), 0.0};
  EXPECT_NO_THROW(Billiard{setup});
  setup.pucks[1].position_m = {0.0, 0.05};
  EXPECT_THROW(Billiard{setup}, std::invalid_argument);
}

TEST(Billiard, orderOfPucksAndStepsChangeNoBit) {
  for (const CollisionEvent convention : {CollisionEvent::centre, CollisionEvent::contact}) {
    BilliardSetup setup = test::gasSetup(40, 0.15, 1.5, 9);
    setup.rules.collisionEvent = convention;
    setup.rules.puckRestitution = 0.98;
    Billiard straight(setup);
    straight.advanceTo(8.0);
    BilliardSetup shuffled = setup;
    std::shuffle(shuffled.pucks.begin(), shuffled.pucks.end(), std::mt19937_64(4));
    Billiard stepped(shuffled);
    for (int i = 1; i <= 800; ++i) stepped.advanceTo(0.01 * i);
    EXPECT_GT(straight.events().size(), 500u);
    EXPECT_EQ(straight.events().size(), stepped.events().size());
    EXPECT_EQ(transcript(straight, setup.pucks), transcript(stepped, shuffled.pucks));
  }
}

// The cells that keep a puck from looking at every other change no bit: with a puck so large that all the
// others share a cell, far from them, these do just the same.
TEST(Billiard, cellsChangeNoBit) {
  for (const CollisionEvent convention : {CollisionEvent::centre, CollisionEvent::contact}) {
    BilliardSetup setup = test::gasSetup(150, 0.1, 2.0, 17);
    setup.board.reset();
    setup.rules.collisionEvent = convention;
    // Towards the middle, faster from farther away, so that many meet.
    for (Puck& puck : setup.pucks) puck.beta = -puck.position_m * 1.2 + 0.3 * puck.beta;
    BilliardSetup oneCell = setup;
    oneCell.pucks.push_back({"zz", 10.0, 0.02, 1.0, {100.0, 0.0}, {0.0, 0.0}});
    Billiard with(setup), without(oneCell);
    const double until_s = 2.0;
    with.advanceTo(until_s);
    without.advanceTo(until_s);
    EXPECT_GT(with.events().size(), 300u);
    for (std::size_t i = 0; i < setup.pucks.size(); ++i) {
      const Motion a = with.worldLines()[i].at(until_s), b = without.worldLines()[i].at(until_s);
      EXPECT_EQ(a.event.r_m, b.event.r_m);
      EXPECT_EQ(a.u, b.u);
      EXPECT_EQ(a.properTime_s, b.properTime_s);
      EXPECT_EQ(a.leg, b.leg);
    }
  }
}

// As fast as that, pucks touch across more than the next cell: in small cells, and in one that holds all.
TEST(Billiard, cellsChangeNoBitOfTheFastest) {
  for (const CollisionEvent convention : {CollisionEvent::centre, CollisionEvent::contact}) {
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
      SCOPED_TRACE(testing::Message() << "seed " << seed);
      BilliardSetup setup = test::gasSetup(100, 0.02, 7.0, seed);  // 0.99 c
      setup.board.reset();
      setup.rules.collisionEvent = convention;
      for (Puck& puck : setup.pucks) {
        const double speed = glm::length(puck.beta), share = puck.name.size() == 1 ? 0.1 : 1.0;
        const Vec2 way = -puck.position_m + 0.2 * puck.beta;  // past the middle, slow ones among them
        puck.beta = share * speed / glm::length(way) * way;
      }
      BilliardSetup oneCell = setup;
      oneCell.pucks.push_back({"zz", 10.0, 0.02, 1.0, {100.0, 0.0}, {0.0, 0.0}});
      Billiard with(setup), without(oneCell);
      for (const double until_s : {0.5, 1.0, 2.0}) {
        with.advanceTo(until_s), without.advanceTo(until_s);
        for (std::size_t i = 0; i < setup.pucks.size(); ++i) {
          const Motion a = with.worldLines()[i].at(until_s), b = without.worldLines()[i].at(until_s);
          ASSERT_EQ(a.u, b.u) << "puck " << i << " at " << until_s << " s";
          ASSERT_EQ(a.properTime_s, b.properTime_s);
          ASSERT_EQ(a.leg, b.leg);
        }
      }
      EXPECT_GT(with.events().size(), 60u);
    }
  }
}

// Where light and heavy, slow and fast pucks meet, the next event of a puck that others have waited for lies
// in the past of the present by more than it takes to cross a cell: the others that it can meet have gone on.
// In the game of the last seed that decides who meets.
TEST(Billiard, cellsChangeNoBitOfPucksThatOthersWaitFor) {
  for (const std::uint64_t seed : {3U, 9U, 27U}) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937_64 engine(seed);
    const auto in = [&](double low, double high) {
      return low + (high - low) * static_cast<double>(engine() >> 11) * 0x1.0p-53;
    };
    const double energy = in(1.05, 10.0), coverage = in(0.02, 0.4);
    const int count = 40 + static_cast<int>(in(0.0, 60.0));
    BilliardSetup setup = test::gasSetup(count, coverage, energy, seed);
    setup.board.reset();
    const double slow = in(0.0, 1.0);
    for (Puck& puck : setup.pucks) {
      puck.beta *= in(0.0, 1.0) < slow ? in(0.0, 0.3) : 1.0;
      puck.mass_kg = std::pow(10.0, in(-2.0, 2.0));
      puck.radius_m *= in(0.2, 1.0);
      const Vec2 way = -puck.position_m + 0.2 * puck.beta;
      puck.beta = glm::length(puck.beta) / glm::length(way) * way;
    }
    BilliardSetup oneCell = setup;
    oneCell.pucks.push_back({"zz", 10.0, 0.02, 1.0, {100.0, 0.0}, {0.0, 0.0}});
    Billiard with(setup), without(oneCell);
    const double until_s = 1.5;
    with.advanceTo(until_s), without.advanceTo(until_s);
    EXPECT_GT(with.events().size(), 30u);
    for (std::size_t i = 0; i < setup.pucks.size(); ++i) {
      const Motion a = with.worldLines()[i].at(until_s), b = without.worldLines()[i].at(until_s);
      ASSERT_EQ(a.u, b.u) << "puck " << i;
      ASSERT_EQ(a.properTime_s, b.properTime_s);
    }
  }
}

// For a target at rest, tan θ1 tan θ2 = 2/(γ+1).
TEST(Billiard, anglesOfTwoEqualPucks) {
  for (const double gamma : {1.25, 2.0, 7.0, 70.0}) {
    for (const double impact : {-1.6, -0.3, 0.7, 1.9}) {
      SCOPED_TRACE(testing::Message() << "gamma " << gamma << " b/R " << impact);
      BilliardSetup setup;
      setup.lightSpeed_m_s = 1.42;
      const double beta = std::sqrt(1.0 - 1.0 / (gamma * gamma));
      setup.pucks = {{"a", 0.03, 0.02, 0.2, {-1.0, 0.03 * impact}, {beta, 0.0}},
                     {"b", 0.03, 0.02, 0.2, {0.0, 0.0}, {0.0, 0.0}}};
      Billiard billiard(setup);
      billiard.advanceTo(3.0);
      ASSERT_EQ(billiard.events().size(), 1u);
      const Vec2 one = billiard.events()[0].turns[0].betaAfter, two = billiard.events()[0].turns[1].betaAfter;
      const double product = -(one.y / one.x) * (two.y / two.x);
      EXPECT_TRUE(std::abs(product - 2.0 / (gammaOf({beta, 0.0}) + 1.0)) <= 1e-9 * gamma) << product;
      EXPECT_TRUE(std::abs(std::atan2(std::abs(two.y), two.x) -
                           std::atan(2.0 * std::tan(std::asin(std::abs(impact) / 2.0)) / (gamma + 1.0))) <=
                  1e-9 * gamma);
    }
  }
}

// At a cushion the centre turns y = R (sqrt(1 + γ²β_n²) − γβ_n) inside ("centre") or R sqrt(1 − β_n²)
// ("contact").
TEST(Billiard, cushionTurnsTheCentreInside) {
  for (const double beta : {0.1, 0.5, 0.9, 0.99, 0.9999}) {
    for (const CollisionEvent convention : {CollisionEvent::centre, CollisionEvent::contact}) {
      BilliardSetup setup = table(2.0, 1.0);
      setup.rules.collisionEvent = convention;
      setup.pucks = {{"one", 0.05, 0.02, 1.0, {0.1, 0.0}, {0.8 * beta, 0.6 * beta}}};
      Billiard billiard(setup);
      billiard.advanceTo(50.0);
      for (const GameEvent& collision : billiard.events()) {
        const Turn& turn = collision.turns[0];
        const bool alongX = *collision.cushion == Cushion::plusX || *collision.cushion == Cushion::minusX;
        const double betaN = std::abs(alongX ? turn.betaBefore.x : turn.betaBefore.y),
                     un = gammaOf(turn.betaBefore) * betaN;
        const double y = alongX ? 1.0 - std::abs(turn.event.r_m.x) : 0.5 - std::abs(turn.event.r_m.y);
        const double expected = convention == CollisionEvent::centre ? 0.05 * (std::sqrt(1.0 + un * un) - un)
                                                                     : 0.05 * std::sqrt(1.0 - betaN * betaN);
        // Near a corner the signal meets a leg that has turned meanwhile, farther inside.
        EXPECT_TRUE(y >= expected - 1e-9) << y << " " << expected;
        if (&collision == &billiard.events()[0] || convention == CollisionEvent::contact) {
          EXPECT_TRUE(std::abs(y - expected) <= 1e-9) << y << " " << expected;
        }
      }
      EXPECT_GT(billiard.events().size(), beta > 0.3 ? 20u : 2u);
    }
  }
}

// One elastic puck among cushions: played back from where it ends, with its velocity reversed, it returns to
// where it began. (The signal delay does not break it: each turn's place depends on the speed alone.)
TEST(Billiard, onePuckAmongCushionsIsReversible) {
  for (const CollisionEvent convention : {CollisionEvent::centre, CollisionEvent::contact}) {
    BilliardSetup setup = table(2.84, 1.42);
    setup.rules.collisionEvent = convention;
    setup.pucks = {{"one", 0.0305, 0.02, 0.2, {0.123, -0.321}, {0.71, 0.43}}};
    Billiard forth(setup);
    double until_s = 0.0;
    while (forth.events().size() < 50) forth.advanceTo(until_s += 0.5);
    const Motion end = forth.worldLines()[0].at(until_s);
    BilliardSetup reversed = setup;
    reversed.pucks[0].position_m = Vec2(end.event.r_m);
    const Vec3 beta = betaFromU(end.u);
    reversed.pucks[0].beta = {-beta.x, -beta.y};
    Billiard back(reversed);
    back.advanceTo(until_s);
    const Motion start = back.worldLines()[0].at(until_s);
    EXPECT_TRUE(glm::length(Vec2(start.event.r_m) - setup.pucks[0].position_m) <= 1e-9);
    EXPECT_TRUE(glm::length(Vec2(betaFromU(start.u)) + setup.pucks[0].beta) <= 1e-9);
  }
}

// Into the exact corner: two collisions at one event, the second beginning with what the first left.
TEST(Billiard, exactCorner) {
  for (const double e : {1.0, 0.5}) {
    for (const CollisionEvent convention : {CollisionEvent::centre, CollisionEvent::contact}) {
      SCOPED_TRACE(testing::Message()
                   << e << (convention == CollisionEvent::centre ? " centre" : " contact"));
      BilliardSetup setup = table(2.0, 2.0);
      setup.rules.collisionEvent = convention;
      setup.rules.cushionRestitution = e;
      setup.pucks = {{"one", 0.05, 0.02, 1.0, {0.25, 0.25}, {0.6, 0.6}}};
      Billiard billiard(setup);
      billiard.advanceTo(1.5);
      ASSERT_EQ(billiard.events().size(), 2u);
      const GameEvent &first = billiard.events()[0], &second = billiard.events()[1];
      EXPECT_EQ(*first.cushion, Cushion::plusX);
      EXPECT_EQ(*second.cushion, Cushion::plusY);
      EXPECT_EQ(second.turns[0].betaBefore, first.turns[0].betaAfter);
      EXPECT_TRUE(std::abs(second.turns[0].betaAfter.x + e * 0.6) <= kRounding);
      EXPECT_TRUE(std::abs(second.turns[0].betaAfter.y + e * 0.6) <= kRounding);
      if (e == 1.0) {
        EXPECT_TRUE(std::abs(second.turns[0].event.t_s - first.turns[0].event.t_s) <= kRounding);
      }
      const Event& turn = second.turns[0].event;
      EXPECT_LT(turn.r_m.x, 1.0);
      EXPECT_LT(turn.r_m.y, 1.0);
    }
  }
}

void expectInside(const Billiard& billiard, const Board& board) {
  for (const WorldLine& line : billiard.worldLines()) {
    for (const Knot& knot : line.knots()) {
      ASSERT_LT(std::abs(knot.turn.r_m.x), 0.5 * board.length_m);
      ASSERT_LT(std::abs(knot.turn.r_m.y), 0.5 * board.width_m);
    }
  }
}

// Corners, heavy and light pucks, high speeds: no centre ever leaves the table, and all is balanced.
TEST(Billiard, noCentreLeavesTheTable) {
  std::mt19937_64 random(77);
  const auto in = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random() >> 11) * 0x1.0p-53;
  };
  for (int game = 0; game < 300; ++game) {
    BilliardSetup setup = table(in(0.4, 1.0), in(0.4, 1.0));
    setup.rules.collisionEvent = game % 2 == 0 ? CollisionEvent::centre : CollisionEvent::contact;
    setup.rules.puckRestitution = game % 3 == 0 ? in(0.0, 1.0) : 1.0;
    setup.rules.cushionRestitution = game % 3 == 0 ? in(0.0, 1.0) : 1.0;
    if (game % 5 == 0) setup.rules.friction_m_s2 = in(0.0, 0.5);
    const double x = 0.25 * setup.board->length_m, y = 0.25 * setup.board->width_m;
    for (int i = 0; i < 4; ++i) {
      const double angle = in(0.0, 2.0 * std::numbers::pi),
                   beta = game % 7 == 0 ? in(0.99, 0.9999) : in(0.0, 0.99);
      setup.pucks.push_back({std::to_string(i),
                             in(0.01, 0.09),
                             0.02,
                             std::pow(10.0, in(-2.0, 1.0)),
                             {(i % 2 ? x : -x), (i / 2 ? y : -y)},
                             {beta * std::cos(angle), beta * std::sin(angle)}});
    }
    SCOPED_TRACE(testing::Message() << "game " << game);
    Billiard billiard(setup);
    const Ledger start = billiard.ledger();
    for (double t_s = 0.5; t_s <= 20.0 && billiard.events().size() < 3000; t_s += 0.5)
      billiard.advanceTo(t_s);
    expectInside(billiard, *setup.board);
    test::expectBalanced(billiard, start, 1e-9);
    if (HasFailure()) return;
  }
}

// A puck that fits between two cushions only while it is contracted: elastic, it goes on; losing speed, it
// jams, which is noted, and then moves along the gap alone.
TEST(Billiard, squeezedPuck) {
  for (const CollisionEvent convention : {CollisionEvent::centre, CollisionEvent::contact}) {
    for (const double e : {1.0, 0.9}) {
      SCOPED_TRACE(testing::Message()
                   << e << (convention == CollisionEvent::centre ? " centre" : " contact"));
      BilliardSetup setup = table(2.0, 0.09);
      setup.rules.collisionEvent = convention;
      setup.rules.cushionRestitution = e;
      setup.pucks = {{"one", 0.05, 0.02, 1.0, {0.0, 0.0}, {0.1, 0.8}}};
      Billiard billiard(setup);
      const Ledger start = billiard.ledger();
      billiard.advanceTo(30.0);
      expectInside(billiard, *setup.board);
      test::expectBalanced(billiard, start, 1e-10);
      EXPECT_EQ(billiard.jams().empty(), e == 1.0);
      if (e < 1.0) {
        EXPECT_TRUE(std::abs(billiard.worldLines()[0].at(30.0).u.y) <= kRounding);
      }
    }
  }
}

// A gap so narrow that a puck bounces a million times a second is played through, and is no jam.
TEST(Billiard, aMillionCollisionsInASecond) {
  const double beta = 1e-3, gap_m = test::kSanitized ? 1e-8 : 1e-9;
  BilliardSetup setup = table(2.0, 2.0 * 0.05 * std::sqrt(1.0 - beta * beta) + gap_m);
  setup.lightSpeed_m_s = 1.0;
  setup.rules.collisionEvent = CollisionEvent::contact;
  setup.pucks = {{"one", 0.05, 0.02, 1.0, {0.0, 0.0}, {0.0, beta}}};
  Billiard billiard(setup);
  billiard.advanceTo(1.0);
  const auto until = std::count_if(billiard.events().begin(), billiard.events().end(),
                                   [](const GameEvent& collision) { return collision.at.t_s <= 1.0; });
  EXPECT_NEAR(static_cast<double>(until), beta / gap_m, 1.0);
  EXPECT_TRUE(billiard.jams().empty());
}

// A light puck between a heavy one and a cushion, all inelastic: collapses, and ends.
TEST(Billiard, inelasticCollapseEnds) {
  for (const CollisionEvent convention : {CollisionEvent::centre, CollisionEvent::contact}) {
    BilliardSetup setup = table(2.0, 1.0);
    setup.rules.collisionEvent = convention;
    setup.rules.puckRestitution = setup.rules.cushionRestitution = 0.1;
    setup.pucks = {{"light", 0.05, 0.02, 0.01, {0.8, 0.0}, {0.0, 0.0}},
                   {"heavy", 0.05, 0.02, 1.0, {0.0, 0.0}, {0.5, 0.0}}};
    Billiard billiard(setup);
    const Ledger start = billiard.ledger();
    billiard.advanceTo(20.0);
    expectInside(billiard, *setup.board);
    test::expectBalanced(billiard, start, 1e-10);
    EXPECT_LT(billiard.events().size(), 10000u);
  }
}

}  // namespace
}  // namespace carom
