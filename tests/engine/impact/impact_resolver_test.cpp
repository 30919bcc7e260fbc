// Cushions kick what they touch, and keep it on the table: fast pucks among corners, and strokes on pucks
// that the signal of a cushion has not reached yet.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>
#include <sstream>
#include <string>
#include <vector>

#include "engine/balance.h"
#include "engine/billiard/billiard.h"
#include "engine/random_game.h"
#include "engine/random_world.h"

namespace carom {
namespace {

constexpr double kRounding = 1e-12;  // of the table's length: a thousand roundings of its coordinates

class Random : public test::Random {
 public:
  using test::Random::Random;
  Vec2 way() {
    const double angle = in(0.0, 2.0 * std::numbers::pi);
    return {std::cos(angle), std::sin(angle)};
  }
};

BilliardSetup table(CollisionEvent convention) {
  BilliardSetup setup;
  setup.lightSpeed_m_s = 1.42;
  setup.board = Board{2.84, 1.42};
  setup.rules.collisionEvent = convention;
  return setup;
}

std::string text(const BilliardSetup& setup) {
  std::ostringstream out;
  out.precision(17);
  out << (setup.rules.collisionEvent == CollisionEvent::centre ? "centre" : "contact") << ", restitution "
      << setup.rules.puckRestitution << " and " << setup.rules.cushionRestitution << ", friction "
      << setup.rules.friction_m_s2;
  for (const Puck& puck : setup.pucks) {
    out << "\npuck R " << puck.radius_m << " m " << puck.mass_kg << " at " << puck.position_m.x << ' '
        << puck.position_m.y << " beta " << puck.beta.x << ' ' << puck.beta.y;
  }
  for (const Stroke& stroke : setup.strokes) {
    out << "\nstroke " << stroke.at_s << " s, momentum " << stroke.momentum_kg_m_s.x << ' '
        << stroke.momentum_kg_m_s.y;
  }
  return out.str();
}

double half_m(const Board& board, int axis) { return 0.5 * (axis == 0 ? board.length_m : board.width_m); }

// Did the rim of a puck on this leg, in its own rest frame, pass through the event? Only while the leg lasted
// or, as the rest of a puck follows its centre later, so long before as the signal takes to the centre.
bool rimPasses(const Event& event, const Knot& leg, const Knot* next, double radius_m, double c_m_s) {
  const double gamma = gammaFromU(leg.u);
  const Vec2 d = Vec2(event.r_m - leg.turn.r_m);
  const double ct = c_m_s * (event.t_s - leg.turn.t_s);
  const double own_m = gamma * ct - glm::dot(Vec2(leg.u), d);  // own time to the event's simultaneous moment
  const double distance_m = std::sqrt(std::max(0.0, own_m * own_m + glm::dot(d, d) - ct * ct));
  const double rounding = kRounding * gamma * gamma + 1e-15 * ct * ct / radius_m;
  const bool inTime = own_m >= -radius_m - rounding &&
                      (!next || own_m <= c_m_s * (next->properTime_s - leg.properTime_s) + rounding);
  return inTime && std::abs(distance_m - radius_m) <= rounding;
}

// The cushion's contact, its turn, and the puck's world line agree. `rims`: the puck's rim is checked, too;
// for legs without friction.
void expectTouched(const GameEvent& bounce, const BilliardSetup& setup, const WorldLine& line, bool rims) {
  const Board& board = *setup.board;
  const Turn& turn = bounce.turns[0];
  const Puck& puck = setup.pucks[turn.puck];
  const bool delayed = setup.rules.collisionEvent == CollisionEvent::centre && !bounce.withoutDelay;
  const int axis = *bounce.cushion < Cushion::plusY ? 0 : 1;
  const double sign = *bounce.cushion == Cushion::plusX || *bounce.cushion == Cushion::plusY ? 1.0 : -1.0;
  const double half = half_m(board, axis), across = half_m(board, 1 - axis);
  EXPECT_TRUE(std::abs(sign * bounce.at.r_m[axis] - half) <= kRounding) << "the contact is on the cushion";
  EXPECT_TRUE(std::abs(bounce.at.r_m[1 - axis]) <= across + kRounding) << "and on the table";
  if (turn.betaBefore == turn.betaAfter) return;  // a stroke was before it
  if (!delayed) {
    EXPECT_TRUE(half - sign * turn.event.r_m[axis] <= puck.radius_m + kRounding) << "it touches";
    return;
  }
  const double c_m_s = setup.lightSpeed_m_s;
  const double gamma = 1.0 / std::sqrt(1.0 - glm::dot(turn.betaBefore, turn.betaBefore));
  const double ct = c_m_s * (turn.event.t_s - bounce.at.t_s);
  const double way = glm::length(Vec2(turn.event.r_m - bounce.at.r_m));
  // The contact may have been found on an earlier, faster leg.
  double fastest = gamma;
  for (const Knot& knot : line.knots()) fastest = std::max(fastest, gammaFromU(knot.u));
  EXPECT_TRUE(std::abs(ct - way) <= kRounding * fastest * fastest)
      << "it turns when the signal arrives: " << ct - way;
  if (setup.pucks.size() == 1 && setup.strokes.empty()) {
    EXPECT_TRUE(half - sign * turn.event.r_m[axis] <= puck.radius_m + kRounding) << "it is there";
  }
  if (!rims) return;
  const bool corner = std::abs(bounce.at.r_m[1 - axis]) >= across - kRounding;
  bool touched = corner;
  const std::vector<Knot> knots(line.knots().begin(), line.knots().end());
  for (std::size_t k = 0; k < knots.size() && !touched; ++k) {
    const Knot* next = k + 1 < knots.size() ? &knots[k + 1] : nullptr;
    touched = rimPasses(bounce.at, knots[k], next, puck.radius_m, c_m_s);
  }
  EXPECT_TRUE(touched) << "the rim passes through the contact";
}

void expectInside(const Billiard& billiard, const BilliardSetup& setup) {
  for (const WorldLine& line : billiard.worldLines()) {
    for (const Knot& knot : line.knots()) {
      for (const int axis : {0, 1})
        ASSERT_TRUE(std::abs(knot.turn.r_m[axis]) <= half_m(*setup.board, axis) + kRounding)
            << knot.turn.t_s << " s at " << knot.turn.r_m.x << ' ' << knot.turn.r_m.y;
    }
  }
}

void expectCushionsHold(const Billiard& billiard, const BilliardSetup& setup, bool rims) {
  expectInside(billiard, setup);
  for (const GameEvent& event : billiard.events()) {
    if (event.kind != EventKind::puckCushion) continue;
    SCOPED_TRACE(testing::Message() << "event " << event.number << ", cushion " << nameOf(*event.cushion)
                                    << ", contact " << event.at.t_s << " s at " << event.at.r_m.x << ' '
                                    << event.at.r_m.y << ", turn " << event.turns[0].event.t_s << " s at "
                                    << event.turns[0].event.r_m.x << ' ' << event.turns[0].event.r_m.y);
    expectTouched(event, setup, billiard.worldLines()[event.turns[0].puck], rims);
    if (testing::Test::HasFailure()) return;
  }
}

class FastGames : public testing::TestWithParam<double> {};

TEST_P(FastGames, cushionsKickOnlyWhatTheyTouch) {
  Random random(static_cast<std::uint64_t>(1e4 * GetParam()));
  std::size_t events = 0;
  for (int game = 0; game < 12; ++game) {
    CASE(random, game);
    BilliardSetup setup = table(game % 3 == 2 ? CollisionEvent::contact : CollisionEvent::centre);
    if (game >= 4) setup.rules.cushionRestitution = game >= 8 ? random.in(0.0, 1.0) : random.in(0.9, 1.0);
    if (game >= 8) setup.rules.puckRestitution = random.in(0.3, 1.0);
    const int pucks = game % 2 == 0 ? 1 : 4;
    for (int i = 0; i < pucks; ++i) {
      const Vec2 cell{i % 2 ? 0.7 : -0.7, i / 2 ? 0.35 : -0.35};
      setup.pucks.push_back({std::to_string(i), random.in(0.01, 0.1), 0.02, random.in(0.05, 1.0),
                             cell + Vec2(random.in(-0.1, 0.1), random.in(-0.1, 0.1)),
                             GetParam() * random.way()});
    }
    SCOPED_TRACE(testing::Message() << "game " << game << ": " << text(setup));
    Billiard billiard(setup);
    const Ledger start = billiard.ledger();
    billiard.advanceTo(400.0);
    expectCushionsHold(billiard, setup, true);
    test::expectBalanced(billiard, start, 1e-9);
    if (HasFailure()) return;
    events += billiard.events().size();
  }
  EXPECT_GT(events, 3000u);
}

INSTANTIATE_TEST_SUITE_P(, FastGames, testing::Values(0.9, 0.95, 0.97, 0.99, 0.995, 0.999),
                         [](const auto& beta) { return std::to_string(static_cast<int>(1e3 * beta.param)); });

// The signal that turns a puck in a corner comes from the end of the cushion, as the rim has touched the line
// beyond it. That place is R from the centre in the puck's frame, and the corner nearer than it on the board:
// so the corner is at most (γ (1 + β))² R from the centre. Of what has turned before, and has never come
// there, it can be any distance away; of these games 169 and 221 have such pucks.
TEST(CornersOfTheTable, AreTouchedByRimsAlone) {
  for (const std::uint64_t seed : {169, 221}) {
    const BilliardSetup setup = test::randomGame(seed).setup;
    Billiard billiard(setup);
    test::playAtMost(billiard, setup, 400.0, 3000);
    ASSERT_TRUE(setup.board);
    const double c_m_s = setup.lightSpeed_m_s;
    std::size_t bounces = 0;
    for (const GameEvent& event : billiard.events()) {
      if (event.kind != EventKind::puckCushion || event.withoutDelay) continue;
      ++bounces;
      bool corner = true;
      for (const int axis : {0, 1})
        corner = corner && std::abs(event.at.r_m[axis]) >= half_m(*setup.board, axis) - kRounding;
      if (!corner) continue;
      const Turn& turn = event.turns[0];
      const Displacement way = turn.event - event.at;
      const Vec2& beta = turn.betaBefore;
      const double size = glm::length(beta), gamma = 1.0 / std::sqrt((1.0 - size) * (1.0 + size));
      const double own_m = gamma * (c_m_s * way.dt_s - beta.x * way.dr_m.x - beta.y * way.dr_m.y);
      EXPECT_LE(own_m, std::pow(gamma * (1.0 + size), 2) * setup.pucks[turn.puck].radius_m)
          << "game " << seed << ", event " << event.number;
    }
    EXPECT_GT(bounces, 50u) << seed;
  }
}

// Everything that two games delivered up to a time, to the bit; what each knows beyond depends on how it came
// there.
void expectSameGame(const Billiard& a, const Billiard& b, double until_s) {
  for (std::size_t puck = 0; puck < a.worldLines().size(); ++puck) {
    const Knots ours = a.worldLines()[puck].knots(), theirs = b.worldLines()[puck].knots();
    for (std::size_t k = 0; k < std::max(ours.size(), theirs.size()); ++k) {
      if (k >= std::min(ours.size(), theirs.size())) {
        EXPECT_GT((k < ours.size() ? ours : theirs)[k].turn.t_s, until_s);
        break;
      }
      EXPECT_EQ(ours[k].turn.t_s, theirs[k].turn.t_s);
      EXPECT_EQ(ours[k].turn.r_m, theirs[k].turn.r_m);
      EXPECT_EQ(ours[k].u, theirs[k].u);
      EXPECT_EQ(ours[k].signal.t_s, theirs[k].signal.t_s);
      EXPECT_EQ(ours[k].signal.r_m, theirs[k].signal.r_m);
    }
  }
  for (std::size_t i = 0; i < std::max(a.events().size(), b.events().size()); ++i) {
    if (i >= std::min(a.events().size(), b.events().size())) {
      EXPECT_GT((i < a.events().size() ? a : b).events()[i].turns[0].event.t_s, until_s);
      break;
    }
    const GameEvent &ours = a.events()[i], &theirs = b.events()[i];
    EXPECT_EQ(ours.kind, theirs.kind);
    EXPECT_EQ(ours.at.t_s, theirs.at.t_s);
    EXPECT_EQ(ours.at.r_m, theirs.at.r_m);
    EXPECT_EQ(ours.withoutDelay, theirs.withoutDelay);
    EXPECT_EQ(ours.heat_j, theirs.heat_j);
    ASSERT_EQ(ours.turns.size(), theirs.turns.size());
    for (std::size_t k = 0; k < ours.turns.size(); ++k) {
      EXPECT_EQ(ours.turns[k].event.t_s, theirs.turns[k].event.t_s);
      EXPECT_EQ(ours.turns[k].event.r_m, theirs.turns[k].event.r_m);
      EXPECT_EQ(ours.turns[k].betaAfter, theirs.turns[k].betaAfter);
    }
  }
}

// A stroke, and sometimes a second, in the window before a bounce: while its signal is on its way, and a
// little before that. Of every third game a corner is near.
TEST(StrokesNearCushions, keepThePuckOnTheTable) {
  Random random(61);
  for (int game = 0; game < 600; ++game) {
    CASE(random, game);
    BilliardSetup setup = table(game % 4 == 3 ? CollisionEvent::contact : CollisionEvent::centre);
    if (game % 2 == 1) setup.rules.friction_m_s2 = random.in(0.005, 0.3);
    if (game % 5 == 0) setup.rules.cushionRestitution = random.in(0.0, 1.0);
    const double beta = game % 7 == 0 ? 0.999 : random.in(0.3, 0.99), radius_m = random.in(0.02, 0.1);
    const double angle = game % 3 == 0 ? std::atan2(0.51, 0.52) + random.in(-0.2, 0.2) : random.in(-0.7, 0.7);
    const double y_m = game % 3 == 0 ? 0.1 : 0.0;
    setup.pucks = {
        {"one", radius_m, 0.02, 0.2, {0.8, y_m}, {beta * std::cos(angle), beta * std::sin(angle)}}};
    Billiard live(setup);
    const Ledger start = live.ledger();
    live.advanceTo(8.0);
    SCOPED_TRACE(testing::Message() << "game " << game);
    if (live.events().empty()) continue;  // friction stopped it
    const GameEvent first = live.events()[0];
    BilliardSetup scripted = setup;
    const double window_s =
        std::max(first.turns[0].event.t_s - first.at.t_s, radius_m / setup.lightSpeed_m_s);
    double at_s = first.turns[0].event.t_s - window_s * random.in(-0.1, 1.2);
    for (int stroke = 0; stroke < (game % 3 == 1 ? 2 : 1); ++stroke) {
      const Vec2 momentum = 0.2 * setup.lightSpeed_m_s * random.in(0.1, 4.0) * random.way();
      scripted.strokes.push_back({0, std::max(0.0, at_s), std::nullopt, momentum});
      live.strike(scripted.strokes.back());
      at_s += window_s * random.in(0.01, 0.5);
    }
    live.advanceTo(10.0);
    SCOPED_TRACE(text(scripted));
    Billiard whole(scripted);
    whole.advanceTo(10.0);
    expectCushionsHold(whole, scripted, setup.rules.friction_m_s2 == 0.0);
    expectSameGame(live, whole, 10.0);
    test::expectBalanced(whole, start, 1e-9);
    test::expectBalanced(live, start, 1e-9);
    if (HasFailure()) return;
  }
}

// Strokes on pucks among others, in the windows before their turns, so that kicks of pucks are on their way,
// too.
TEST(StrokesNearCushions, inAGame) {
  Random random(62);
  for (int game = 0; game < 25; ++game) {
    CASE(random, game);
    BilliardSetup setup = table(game % 4 == 3 ? CollisionEvent::contact : CollisionEvent::centre);
    setup.board = Board{1.0, 0.7};
    if (game % 2 == 1) setup.rules.friction_m_s2 = random.in(0.005, 0.1);
    if (game % 5 == 0) setup.rules.cushionRestitution = random.in(0.5, 1.0);
    for (int i = 0; i < 6; ++i) {
      const Vec2 place{0.3 * (i % 3 - 1), i / 3 ? 0.15 : -0.15};
      setup.pucks.push_back({std::to_string(i), random.in(0.02, 0.09), 0.02, random.in(0.05, 1.0), place,
                             random.in(0.3, 0.95) * random.way()});
    }
    Billiard live(setup);
    const Ledger start = live.ledger();
    BilliardSetup scripted = setup;
    for (double t_s = 1.0; t_s < 8.0; t_s += 0.5) {
      live.advanceTo(t_s + 1.0);
      const auto next = std::find_if(live.events().begin(), live.events().end(), [&](const GameEvent& event) {
        return event.kind != EventKind::stroke && event.at.t_s >= t_s;
      });
      if (next == live.events().end()) break;
      const Turn turn = next->turns[0];
      const double before_s = random.in(-0.1, 1.1) * (turn.event.t_s - next->at.t_s);
      const double u = random.in(0.1, 3.0);
      scripted.strokes.push_back({turn.puck, turn.event.t_s - before_s, std::nullopt,
                                  u * setup.pucks[turn.puck].mass_kg * setup.lightSpeed_m_s * random.way()});
      live.strike(scripted.strokes.back());
    }
    live.advanceTo(10.0);
    SCOPED_TRACE(testing::Message() << "game " << game << ": " << text(scripted));
    Billiard whole(scripted);
    whole.advanceTo(10.0);
    expectInside(whole, scripted);
    expectSameGame(live, whole, 10.0);
    test::expectBalanced(whole, start, 1e-9);
    test::expectBalanced(live, start, 1e-9);
    if (HasFailure()) return;
  }
}

// Friction stops a puck between its contact with a cushion and the signal of it, which then kicks nobody: the
// game goes on. The puck is shot softly, by a stroke that comes while the signal of another puck's blow is on
// its way.
TEST(StrokesNearCushions, aSoftOneThatFrictionStopsIsNotKicked) {
  for (int softness = 0; softness < 40; ++softness) {
    BilliardSetup setup = table(CollisionEvent::centre);
    setup.rules.friction_m_s2 = 0.5;
    setup.pucks = {{"p", 0.05, 0.03, 0.2, {1.3699999, 0.0}, {0.0, 0.0}},
                   {"q", 0.05, 0.03, 0.2, {1.1, 0.0}, {0.3, 0.0}}};
    setup.strokes = {{0, 0.58009, std::nullopt, {0.003 + 2e-5 * softness, 0.0}}};
    SCOPED_TRACE(text(setup));
    Billiard billiard(setup);
    billiard.advanceTo(3.0);
    expectInside(billiard, setup);
  }
}

}  // namespace
}  // namespace carom
