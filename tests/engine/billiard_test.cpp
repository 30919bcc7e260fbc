#include "engine/billiard/billiard.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <sstream>

#include "engine/balance.h"
#include "engine/gas.h"
#include "sanitized.h"

namespace carom {
namespace {

constexpr double kRounding = 1e-12;  // metres, seconds: a thousand roundings of a table's coordinates

double gammaOf(const Vec2& beta) { return 1.0 / std::sqrt(1.0 - glm::dot(beta, beta)); }

BilliardSetup table(double length_m, double width_m) {
  BilliardSetup setup;
  setup.lightSpeed_m_s = 1.42;
  setup.board = Board{length_m, width_m};
  return setup;
}

BilliardSetup threePucks() {
  BilliardSetup setup = table(2.84, 1.42);
  setup.pucks = {{"white", 0.0305, 0.02, 0.2, {-0.9, 0.0}, {0.8, 0.01}},
                 {"yellow", 0.0305, 0.02, 0.2, {0.3, 0.1}, {0.0, 0.0}},
                 {"red", 0.0305, 0.02, 0.2, {0.6, -0.02}, {-0.3, 0.1}}};
  return setup;
}

// Everything a game delivered, as text of all digits.
std::string transcript(const Billiard& billiard, const std::vector<Puck>& pucks) {
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < pucks.size(); ++i) {
    std::ostringstream line;
    line << std::hexfloat << pucks[i].name;
    for (const Knot& k : billiard.worldLines()[i].knots()) {
      line << ' ' << k.turn.t_s << ' ' << k.turn.r_m.x << ' ' << k.turn.r_m.y << ' ' << k.u.x << ' ' << k.u.y
           << ' ' << k.properTime_s << ' ' << k.signal.t_s << ' ' << k.signal.r_m.x << ' ' << k.signal.r_m.y;
    }
    lines.push_back(line.str());
  }
  std::sort(lines.begin(), lines.end());
  std::string all;
  for (const std::string& line : lines) all += line + '\n';
  return all;
}

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

BilliardSetup withStroke(BilliardSetup setup, const Stroke& stroke) {
  setup.strokes.push_back(stroke);
  return setup;
}

// A stroke acts where its light meets the puck, and changes nothing outside the future of that.
TEST(BilliardStroke, actsWhereItsLightArrives) {
  BilliardSetup setup = threePucks();
  const Stroke stroke{1, 1.0, Vec3(0.0, -0.9, 0.3), {0.1, -0.05}};
  Billiard without(setup), with(withStroke(setup, stroke));
  without.advanceTo(0.7);
  with.advanceTo(6.0);
  const auto struck = [&](const Knot& knot) {
    const Vec3 path = knot.turn.r_m - *stroke.from_m;
    return std::abs(glm::length(path) - setup.lightSpeed_m_s * (knot.turn.t_s - stroke.at_s)) < kRounding &&
           knot.signal.r_m == knot.turn.r_m;
  };
  const std::span<const Knot> knots = with.worldLines()[1].knots();
  const auto knot = std::find_if(knots.begin(), knots.end(), struck);
  ASSERT_NE(knot, knots.end());
  const Motion before = motionOnLeg(*(knot - 1), knot->turn.t_s, setup.lightSpeed_m_s);
  const double mc = 0.2 * setup.lightSpeed_m_s;
  EXPECT_TRUE(glm::length(mc * (knot->u - before.u) - Vec3(stroke.momentum_kg_m_s, 0.0)) <= kRounding);
  // Without `from_m` it acts at at_s itself.
  Billiard direct(withStroke(setup, {2, 0.125, std::nullopt, {0.0, 0.2}}));
  direct.advanceTo(1.0);
  EXPECT_EQ(direct.worldLines()[2].knots()[1].turn.t_s, 0.125);
}

void expectSame(const GameEvent& a, const GameEvent& b) {
  EXPECT_EQ(a.number, b.number);
  EXPECT_EQ(a.kind, b.kind);
  EXPECT_EQ(a.cushion, b.cushion);
  EXPECT_EQ(a.which, b.which);
  EXPECT_EQ(a.at.t_s, b.at.t_s);
  EXPECT_EQ(a.at.r_m, b.at.r_m);
  EXPECT_EQ(a.withoutDelay, b.withoutDelay);
  EXPECT_EQ(a.heat_j, b.heat_j);
  ASSERT_EQ(a.turns.size(), b.turns.size());
  for (std::size_t i = 0; i < a.turns.size(); ++i) {
    EXPECT_EQ(a.turns[i].puck, b.turns[i].puck);
    EXPECT_EQ(a.turns[i].event.t_s, b.turns[i].event.t_s);
    EXPECT_EQ(a.turns[i].event.r_m, b.turns[i].event.r_m);
    EXPECT_EQ(a.turns[i].betaBefore, b.turns[i].betaBefore);
    EXPECT_EQ(a.turns[i].betaAfter, b.turns[i].betaAfter);
    EXPECT_EQ(a.turns[i].properTime_s, b.turns[i].properTime_s);
  }
}

// A stroke is an event at the hand, whose turn is the arrival of its light; a flash is one without turns.
// Both stand in the list where the game comes to them.
TEST(BilliardEvents, strokesAndFlashesAreAmongThem) {
  BilliardSetup setup = threePucks();
  const Stroke stroke{1, 1.0, Vec3(0.0, -0.9, 0.3), {0.1, -0.05}};
  setup.strokes = {{2, 0.125, std::nullopt, {0.0, 0.2}}, stroke};
  setup.flashes = {{"late", {0.5, {0.0, 0.1, 0.2}}}, {"early", {0.0, {0.3, 0.0, 0.0}}}};
  Billiard billiard(setup);
  billiard.advanceTo(6.0);
  std::vector<const GameEvent*> strokes, flashes;
  for (const GameEvent& event : billiard.events()) {
    if (event.kind == EventKind::stroke) strokes.push_back(&event);
    if (event.kind == EventKind::flash) flashes.push_back(&event);
  }
  ASSERT_EQ(flashes.size(), 2u);
  EXPECT_EQ(flashes[0]->which, 1u);
  EXPECT_EQ(flashes[0]->number, 0u);
  EXPECT_EQ(flashes[0]->at.r_m, Vec3(0.3, 0.0, 0.0));
  EXPECT_EQ(flashes[1]->at.t_s, 0.5);
  EXPECT_TRUE(flashes[1]->turns.empty());
  ASSERT_EQ(strokes.size(), 2u);
  EXPECT_EQ(strokes[0]->which, 0u);
  EXPECT_EQ(strokes[0]->at.t_s, 0.125);
  EXPECT_EQ(strokes[0]->at.r_m, billiard.worldLines()[2].at(0.125).event.r_m) << "at the centre itself";
  EXPECT_EQ(strokes[1]->at.t_s, stroke.at_s);
  EXPECT_TRUE(glm::length(strokes[1]->at.r_m - *stroke.from_m) <= kRounding) << "at the hand";
  ASSERT_EQ(strokes[1]->turns.size(), 1u);
  const Turn& turn = strokes[1]->turns[0];
  EXPECT_EQ(turn.puck, 1u);
  EXPECT_TRUE(std::abs(interval_m2(turn.event - strokes[1]->at, setup.lightSpeed_m_s)) <= kRounding);
  const double mc = 0.2 * setup.lightSpeed_m_s;
  const Vec2 given =
      mc * (gammaOf(turn.betaAfter) * turn.betaAfter - gammaOf(turn.betaBefore) * turn.betaBefore);
  EXPECT_TRUE(glm::length(given - stroke.momentum_kg_m_s) <= kRounding);
}

TEST(BilliardEvents, doNotDependOnTheStepsInWhichOneAdvances) {
  BilliardSetup setup = test::gasSetup(12, 0.1, 1.6, 31);
  std::mt19937_64 random(7);
  const auto unit = [&] { return static_cast<double>(random() >> 11) * 0x1.0p-53; };
  for (int i = 0; i < 60; ++i) setup.flashes.push_back({"", {20.0 * unit(), {0.0, 0.0, 0.1}}});
  setup.strokes = {{3, 5.0, Vec3(0.1, 0.1, 0.4), {0.5, 0.0}}};
  Billiard straight(setup), stepped(setup);
  straight.advanceTo(20.0);
  for (double t_s = 0.0; t_s < 20.0;) stepped.advanceTo(t_s = std::min(20.0, t_s + 0.1 * unit()));
  ASSERT_EQ(straight.events().size(), stepped.events().size());
  EXPECT_GT(straight.events().size(), 200u);
  for (std::size_t i = 0; i < straight.events().size(); ++i) {
    SCOPED_TRACE(i);
    expectSame(straight.events()[i], stepped.events()[i]);
  }
  Billiard alone({1.0, {}, {}, {}, {}, {{"", {2.0, {}}}}});  // without pucks
  alone.advanceTo(1.0);
  EXPECT_EQ(alone.events().size(), 0u);
  alone.advanceTo(2.0);
  EXPECT_EQ(alone.events().size(), 1u);
}

// Strokes that come while the game has long been played ahead give the same bits as the same strokes written
// in the setup, whatever was rewound.
TEST(BilliardStroke, rewindingGivesTheBitsOfAScriptedGame) {
  for (const CollisionEvent convention : {CollisionEvent::centre, CollisionEvent::contact}) {
    BilliardSetup setup = test::gasSetup(20, 0.1, 1.6, 21);
    setup.rules.collisionEvent = convention;
    std::mt19937_64 random(5);
    const auto in = [&](double low, double high) {
      return low + (high - low) * static_cast<double>(random() >> 11) * 0x1.0p-53;
    };
    for (int i = 0; i < 40; ++i) setup.flashes.push_back({"", {in(0.0, 40.0), {0.1, 0.2, 0.3}}});
    Billiard live(setup);
    BilliardSetup scripted = setup;
    for (int i = 0; i < 30; ++i) {
      live.advanceTo(2.0 + i);  // far ahead of the stroke
      Stroke stroke{
          static_cast<std::size_t>(in(0.0, 20.0)), 0.2 + i, std::nullopt, {in(-1.0, 1.0), in(-1.0, 1.0)}};
      if (i % 2 == 0) stroke.from_m = Vec3(in(-0.1, 0.1), in(-0.1, 0.1), in(0.0, 0.1));
      live.strike(stroke);
      scripted.strokes.push_back(stroke);
    }
    live.advanceTo(40.0);
    Billiard whole(scripted);
    const Ledger start = whole.ledger();
    whole.advanceTo(40.0);
    EXPECT_GT(whole.events().size(), 1000u);
    EXPECT_EQ(transcript(live, setup.pucks), transcript(whole, setup.pucks));
    ASSERT_EQ(live.events().size(), whole.events().size());
    for (std::size_t i = 0; i < live.events().size(); ++i) {
      SCOPED_TRACE(i);
      expectSame(live.events()[i], whole.events()[i]);
      EXPECT_EQ(live.events()[i].number, i);
    }
    test::expectBalanced(whole, start, 1e-10);
    test::expectBalanced(live, start, 1e-10);
  }
}

// The heat of a bounce on its way is changed by a stroke, and is again what it was when the stroke is
// rewound.
TEST(BilliardStroke, rewindingGivesTheHeatOfAScriptedGame) {
  BilliardSetup setup = test::gasSetup(60, 0.3, 1.6, 22);
  setup.rules.collisionEvent = CollisionEvent::centre;
  setup.rules.cushionRestitution = 0.98;
  Billiard live(setup);
  live.advanceTo(4.0);
  BilliardSetup scripted = setup;
  // Three strokes on each of the pucks whose bounce is on its way around a snapshot: each goes back to that.
  // In the order of time, as going back further would make the bounce anew.
  for (std::size_t i = 0; i < live.events().size(); ++i) {
    const GameEvent event = live.events()[i];
    if (event.kind != EventKind::puckCushion || event.number % 480 < 460) continue;
    const Turn& turn = event.turns[0];
    for (const double part : {0.99, 0.98, 0.97}) {
      const double at_s = event.at.t_s + part * (turn.event.t_s - event.at.t_s);
      const Stroke stroke{turn.puck, at_s, std::nullopt, {0.01 * part, -0.02}};
      live.strike(stroke);
      scripted.strokes.push_back(stroke);
    }
  }
  EXPECT_GT(scripted.strokes.size(), 20u);
  live.advanceTo(5.0);
  Billiard whole(scripted);
  whole.advanceTo(5.0);
  ASSERT_EQ(live.events().size(), whole.events().size());
  double heat_j = 0.0;
  for (std::size_t i = 0; i < live.events().size(); ++i) {
    SCOPED_TRACE(i);
    expectSame(live.events()[i], whole.events()[i]);
    heat_j += live.events()[i].heat_j;
  }
  EXPECT_NEAR(heat_j, live.ledger().heat_j, 1e-10 * heat_j) << "the events' heat is the ledger's";
}

// While a kick is on its way to the centre, a stroke changes where it arrives, not its impulse.
TEST(BilliardStroke, duringAPendingTurn) {
  BilliardSetup setup;
  setup.lightSpeed_m_s = 1.0;
  setup.pucks = {{"a", 0.1, 0.02, 1.0, {-0.5, 0.0}, {0.5, 0.0}},
                 {"b", 0.1, 0.02, 2.0, {0.5, 0.0}, {0.0, 0.0}}};
  Billiard undisturbed(setup);
  undisturbed.advanceTo(3.0);
  ASSERT_EQ(undisturbed.events().size(), 1u);
  const GameEvent before = undisturbed.events()[0];
  const double between_s = 0.5 * (before.at.t_s + before.turns[1].event.t_s);
  const Stroke stroke{1, between_s, std::nullopt, {0.3, 0.4}};
  Billiard billiard(withStroke(setup, stroke));
  const Ledger start = billiard.ledger();
  billiard.advanceTo(3.0);
  ASSERT_EQ(billiard.events().size(), 2u) << "the collision and the stroke";
  const GameEvent& after = billiard.events()[0];
  EXPECT_EQ(after.at.t_s, before.at.t_s);
  EXPECT_EQ(after.turns[0].betaAfter, before.turns[0].betaAfter);
  const Turn &was = before.turns[1], &is = after.turns[1];
  // On the future cone of the contact still.
  const Displacement signal =
      is.event - Event{after.at.t_s, {after.at.r_m.x, after.at.r_m.y, is.event.r_m.z}};
  EXPECT_TRUE(std::abs(interval_m2(signal, 1.0)) <= kRounding);
  const auto impulse = [](const Turn& turn) {
    return 2.0 * (gammaOf(turn.betaAfter) * turn.betaAfter - gammaOf(turn.betaBefore) * turn.betaBefore);
  };
  EXPECT_TRUE(glm::length(impulse(was) - impulse(is)) <= kRounding);
  EXPECT_TRUE(glm::length(2.0 * gammaOf(is.betaBefore) * is.betaBefore - stroke.momentum_kg_m_s) <=
              kRounding);
  test::expectBalanced(billiard, start, 1e-12);
  EXPECT_TRUE(glm::length(billiard.ledger().givenByStrokes.momentum_kg_m_s - stroke.momentum_kg_m_s) <=
              kRounding);
}

// The same of strokes that are known from the beginning: they, too, change turns that were told while their
// signal was on its way.
TEST(BilliardStroke, changesAreEnoughToFollowStrokesOfTheSetup) {
  BilliardSetup setup = test::gasSetup(12, 0.1, 1.6, 3);
  setup.rules.collisionEvent = CollisionEvent::centre;
  for (int i = 0; i < 200; ++i)
    setup.strokes.push_back({static_cast<std::size_t>(i % 12), 0.13 * i, Vec3(0.3, -0.2, 0.4), {0.5, 0.1}});
  Billiard billiard(setup);
  std::vector<WorldLine> copy(billiard.worldLines().begin(), billiard.worldLines().end());
  int truncated = 0;
  for (int frame = 1; frame <= 3000; ++frame) {
    billiard.advanceTo(0.01 * frame);
    const Changes changes = billiard.takeChanges();
    if (changes.truncatedFrom_s) {
      ++truncated;
      for (WorldLine& line : copy) line.truncateFrom(*changes.truncatedFrom_s);
    }
    for (const Changes::NewKnot& added : changes.knots) copy[added.puck].append(added.knot);
    for (std::size_t i = 0; i < copy.size(); ++i) {
      const std::span<const Knot> here = copy[i].knots(), there = billiard.worldLines()[i].knots();
      ASSERT_EQ(here.size(), there.size()) << "frame " << frame << " puck " << i;
      ASSERT_EQ(here.back().turn.r_m, there.back().turn.r_m) << "frame " << frame << " puck " << i;
    }
  }
  EXPECT_GT(truncated, 0);
}

// A copy that only follows `takeChanges`, as the nodes of a cluster do, holds the same world lines.
TEST(BilliardStroke, changesAreEnoughToFollow) {
  BilliardSetup setup = test::gasSetup(12, 0.1, 1.6, 3);
  setup.rules.collisionEvent = CollisionEvent::centre;
  Billiard billiard(setup);
  std::vector<WorldLine> copy(billiard.worldLines().begin(), billiard.worldLines().end());
  std::vector<GameEvent> events;
  bool truncated = false, changed = false;
  for (int frame = 1; frame <= 600; ++frame) {
    billiard.advanceTo(0.05 * frame + 1.0);
    if (frame % 37 == 0)
      billiard.strike({static_cast<std::size_t>(frame % 12), 0.05 * frame, std::nullopt, {0.5, 0.1}});
    if (frame % 100 == 0) billiard.forgetBefore(0.05 * frame - 3.0);
    const Changes changes = billiard.takeChanges();
    if (changes.truncatedFrom_s) {
      truncated = true;
      EXPECT_GE(*changes.truncatedFrom_s, 0.05 * frame - 0.1);
      for (WorldLine& line : copy) line.truncateFrom(*changes.truncatedFrom_s);
    }
    for (const Changes::NewKnot& added : changes.knots) copy[added.puck].append(added.knot);
    changed = changed || changes.eventsKept < events.size();
    ASSERT_LE(changes.eventsKept, events.size());
    events.resize(changes.eventsKept);
    events.insert(events.end(), changes.events.begin(), changes.events.end());
    ASSERT_GE(events.size(), billiard.events().size());
    for (const GameEvent& event : billiard.events()) expectSame(events[event.number], event);
    for (std::size_t i = 0; i < copy.size(); ++i) {
      const Motion here = copy[i].at(0.05 * frame + 1.0),
                   there = billiard.worldLines()[i].at(0.05 * frame + 1.0);
      ASSERT_EQ(here.event.r_m, there.event.r_m) << "frame " << frame << " puck " << i;
      ASSERT_EQ(here.u, there.u);
    }
  }
  EXPECT_TRUE(truncated);
  EXPECT_TRUE(changed);
  EXPECT_LT(billiard.events().size(), events.size());
  // What was forgotten is gone, what is needed is not.
  EXPECT_LT(billiard.worldLines()[0].knots().size(), copy[0].knots().size());
  EXPECT_THROW(billiard.strike({0, 1.0, std::nullopt, {0.1, 0.0}}), std::invalid_argument);
}

TEST(BilliardStroke, refusesStrokesThatCannotBe) {
  Billiard billiard(threePucks());
  EXPECT_THROW(billiard.strike({9, 1.0, std::nullopt, {0.1, 0.0}}), std::invalid_argument);
  EXPECT_THROW(billiard.strike({0, -1.0, std::nullopt, {0.1, 0.0}}), std::invalid_argument);
  EXPECT_THROW(billiard.strike({0, std::nan(""), std::nullopt, {0.1, 0.0}}), std::invalid_argument);
  EXPECT_DOUBLE_EQ(billiard.strike({0, 0.5, std::nullopt, {0.1, 0.0}}), 0.5);
}

}  // namespace
}  // namespace carom
