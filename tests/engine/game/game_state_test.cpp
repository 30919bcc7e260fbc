// Strokes at bad moments, on pucks that spin, are rough and are slowed by the cloth: while signals are on
// their way to them. The ledger is what the events and the legs between them say; kicks keep what they give;
// and whoever has forgotten the past plays the same game.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>
#include <string>

#include "engine/billiard/billiard.h"
#include "engine/gas.h"
#include "engine/random_world.h"

namespace carom {
namespace {

using Account = Ledger::Account;

class Random : public test::Random {
 public:
  using test::Random::Random;
  Vec2 way() {
    const double angle = in(0.0, 2.0 * std::numbers::pi);
    return {std::cos(angle), std::sin(angle)};
  }
};

std::string text(const BilliardSetup& setup) {
  std::ostringstream out;
  out.precision(17);
  for (const Puck& puck : setup.pucks)
    out << "\npuck R " << puck.radius_m << " m " << puck.mass_kg << " at " << puck.position_m.x << ' '
        << puck.position_m.y << " beta " << puck.beta.x << ' ' << puck.beta.y << " spin " << puck.spin_kg_m2_s
        << " inertia " << puck.inertia;
  for (const Stroke& stroke : setup.strokes)
    out << "\nstroke on " << stroke.puck << " at " << stroke.at_s << " s, momentum "
        << stroke.momentum_kg_m_s.x << ' ' << stroke.momentum_kg_m_s.y << ", offset " << stroke.offset_m
        << " m";
  return out.str();
}

Account operator+(const Account& a, const Account& b) {
  return {a.energy_j + b.energy_j, a.momentum_kg_m_s + b.momentum_kg_m_s};
}
Account operator-(const Account& a, const Account& b) {
  return {a.energy_j - b.energy_j, a.momentum_kg_m_s - b.momentum_kg_m_s};
}

/// The four-momentum of a mass.
Account moving(double mass_kg, const Vec2& beta, double c) {
  const double m = mass_kg / std::sqrt(1.0 - glm::dot(beta, beta));
  return {m * c * c, m * c * beta};
}

/// The accounts of one puck, from its turns in the list of events, in the order of its knots.
struct Books {
  Account motion, taken, slowed;
};

Books booksOf(const Billiard& billiard, const BilliardSetup& setup, std::size_t which) {
  const double c = setup.lightSpeed_m_s;
  const Puck& puck = setup.pucks[which];
  const auto carried = [&](const Vec2& beta, double spin) {
    return moving(restMass_kg(puck, spin, c), beta, c);
  };
  Books books;
  books.motion = carried(puck.beta, puck.spin_kg_m2_s);
  const Knots knots = billiard.worldLines()[which].knots();
  for (std::size_t k = 1; k < knots.size(); ++k) {
    const Knot knot = knots[k];
    const GameEvent* made = nullptr;
    const Turn* turn = nullptr;
    for (const GameEvent& event : billiard.events()) {
      for (const Turn& one : event.turns) {
        const bool same = one.puck == which && one.event.t_s == knot.turn.t_s &&
                          one.betaBefore != one.betaAfter &&
                          glm::length(one.betaAfter - Vec2(betaFromU(knot.u))) < 1e-14;
        if (same) made = &event, turn = &one;
      }
    }
    EXPECT_TRUE(turn != nullptr) << "nothing says why it turns at " << knot.turn.t_s << " s";
    if (turn == nullptr) return books;
    const Account before = carried(turn->betaBefore, turn->spinBefore_kg_m2_s);
    const Account after = carried(turn->betaAfter, turn->spinAfter_kg_m2_s);
    books.slowed = books.slowed + (books.motion - before);
    if (made->cushion)
      books.taken = books.taken + (before - after - moving(made->heat_j / (c * c), turn->betaAfter, c));
    books.motion = after;
  }
  return books;
}

void expectNear(const Account& account, const Account& expected, double within_j, double c,
                const char* name) {
  EXPECT_NEAR(account.energy_j, expected.energy_j, within_j) << name;
  EXPECT_NEAR(account.momentum_kg_m_s.x * c, expected.momentum_kg_m_s.x * c, within_j) << name;
  EXPECT_NEAR(account.momentum_kg_m_s.y * c, expected.momentum_kg_m_s.y * c, within_j) << name;
}

void expectBooksOfTheEvents(const Billiard& billiard, const BilliardSetup& setup) {
  Books all;
  for (std::size_t puck = 0; puck < setup.pucks.size(); ++puck) {
    const Books one = booksOf(billiard, setup, puck);
    all = {all.motion + one.motion, all.taken + one.taken, all.slowed + one.slowed};
  }
  double heat_j = 0.0;
  for (const GameEvent& event : billiard.events()) heat_j += event.heat_j;
  const Ledger ledger = billiard.ledger();
  const double within_j = 1e-10 * all.motion.energy_j, c = setup.lightSpeed_m_s;
  expectNear(ledger.motion, all.motion, within_j, c, "motion");
  expectNear(ledger.takenByCushions, all.taken, within_j, c, "cushions");
  expectNear(ledger.lostToFriction, all.slowed, within_j, c, "friction");
  EXPECT_NEAR(ledger.heat_j, heat_j, within_j);
}

BilliardSetup roughTable(Random& random) {
  BilliardSetup setup;
  setup.lightSpeed_m_s = 1.42;
  setup.board = Board{1.0, 0.7};
  setup.rules.collisionEvent = CollisionEvent::centre;
  setup.rules.cushionRestitution = random.in(0.8, 1.0);
  setup.rules.puckRestitution = random.in(0.8, 1.0);
  setup.rules.puckFriction = random.in(0.1, 1.0);
  setup.rules.cushionFriction = random.in(0.1, 1.0);
  setup.rules.tangentialRestitution = random.in(0.0, 1.0);
  setup.rules.friction_m_s2 = random.in(0.02, 0.2);
  setup.rules.spinDeceleration_m_s2 = random.in(0.05, 0.5);
  return setup;
}

void addPuck(Random& random, BilliardSetup& setup, const Vec2& place_m, const Vec2& beta) {
  Puck puck{
      std::to_string(setup.pucks.size()), random.in(0.02, 0.06), 0.02, random.in(0.1, 1.0), place_m, beta};
  puck.inertia = random.in(0.2, 1.0);
  puck.spin_kg_m2_s =
      spinAt_kg_m2_s(puck, random.in(-0.8, 0.8) * setup.lightSpeed_m_s / puck.radius_m, setup.lightSpeed_m_s);
  setup.pucks.push_back(puck);
}

Stroke strokeOn(Random& random, const BilliardSetup& setup, std::size_t puck, double at_s) {
  const Puck& struck = setup.pucks[puck];
  const double size = random.in(0.1, 2.0) * struck.mass_kg * setup.lightSpeed_m_s;
  return {puck, at_s, std::nullopt, size * random.way(), random.in(-0.5, 0.5) * struck.radius_m};
}

// Pucks among others, each struck while the signal of its next contact is on its way.
TEST(StrokeBooks, TheLedgerIsWhatTheEventsAndTheLegsSay) {
  Random random(41);
  int strokes = 0;
  for (int game = 0; game < 30; ++game) {
    CASE(random, game);
    BilliardSetup setup = roughTable(random);
    for (int i = 0; i < 4; ++i)
      addPuck(random, setup, {i % 2 == 0 ? 0.25 : -0.25, i < 2 ? 0.15 : -0.15},
              random.in(0.3, 0.9) * random.way());
    for (double t_s = 0.2; t_s < 3.0; t_s += 0.3) {
      Billiard live(setup);
      live.advanceTo(t_s + 1.0);
      const auto next = std::find_if(live.events().begin(), live.events().end(), [&](const GameEvent& event) {
        return event.kind != EventKind::stroke && event.at.t_s >= t_s;
      });
      if (next == live.events().end()) break;
      const Turn& turn = next->turns[0];
      const double share = random.in(0.1, 0.9);
      setup.strokes.push_back(
          strokeOn(random, setup, turn.puck, next->at.t_s + share * (turn.event.t_s - next->at.t_s)));
      ++strokes;
    }
    SCOPED_TRACE(text(setup));
    Billiard billiard(setup);
    billiard.advanceTo(5.0);
    expectBooksOfTheEvents(billiard, setup);
    if (HasFailure()) return;
  }
  EXPECT_GT(strokes, 150);
}

// Of a kick on its way a stroke, here beside the centre, changes where it arrives. The momentum and the
// angular momentum that it gives are the same.
TEST(StrokeBooks, AKickOnItsWayGivesWhatItWouldHaveGiven) {
  Random random(42);
  int kicks = 0;
  for (int game = 0; game < 300; ++game) {
    CASE(random, game);
    BilliardSetup setup = roughTable(random);
    setup.board.reset();
    if (game % 2 == 0) setup.rules.friction_m_s2 = setup.rules.spinDeceleration_m_s2 = 0.0;
    addPuck(random, setup, {-0.3, random.in(-0.03, 0.03)}, {random.in(0.3, 0.9), 0.0});
    addPuck(random, setup, {0.0, 0.0}, 0.3 * random.way());
    Billiard before(setup);
    before.advanceTo(1.0);
    if (before.events().empty()) continue;
    const GameEvent& kick = before.events()[0];
    const Turn& was = kick.turns[1];
    const double at_s = kick.at.t_s + random.in(0.1, 0.9) * (was.event.t_s - kick.at.t_s);
    if (!(at_s < std::min(kick.turns[0].event.t_s, was.event.t_s))) continue;
    setup.strokes = {strokeOn(random, setup, was.puck, at_s)};
    SCOPED_TRACE(text(setup));
    Billiard after(setup);
    after.advanceTo(1.0);
    const GameEvent& still = after.events()[0];
    if (still.kind != EventKind::puckPuck || still.at.t_s != kick.at.t_s)
      continue;  // struck before it touched
    const Turn& is = still.turns[1];
    ASSERT_EQ(is.puck, was.puck);
    if (is.event.t_s == was.event.t_s) continue;  // too late
    const double c = setup.lightSpeed_m_s;
    const auto given = [&](const Turn& turn) {
      const Puck& puck = setup.pucks[turn.puck];
      const Account from = moving(restMass_kg(puck, turn.spinBefore_kg_m2_s, c), turn.betaBefore, c);
      return (moving(restMass_kg(puck, turn.spinAfter_kg_m2_s, c), turn.betaAfter, c) - from).momentum_kg_m_s;
    };
    EXPECT_LT(glm::length(given(is) - given(was)), 1e-12);
    EXPECT_NEAR(is.spinAfter_kg_m2_s - is.spinBefore_kg_m2_s, was.spinAfter_kg_m2_s - was.spinBefore_kg_m2_s,
                1e-14);
    ++kicks;
    if (HasFailure()) return;
  }
  EXPECT_GT(kicks, 50);
}

// One that forgets what is past, as a session does, and is struck just after what it has forgotten: its game
// is that of one that forgets nothing.
TEST(StrokeBooks, AStrokeJustAfterWhatIsForgottenPlaysTheSameGame) {
  Random random(43);
  int strokes = 0;
  for (int game = 0; game < 12; ++game) {
    CASE(random, game);
    BilliardSetup setup =
        test::gasSetup(10, 0.15, random.in(2.0, 5.0), 300 + static_cast<std::uint64_t>(game));
    setup.rules.collisionEvent = CollisionEvent::centre;
    for (Puck& puck : setup.pucks) puck.radius_m *= random.in(0.3, 1.0);
    Billiard whole(setup), forgetful(setup);
    const double step_s = 0.002;
    double forgotten_s = 0.0;
    for (int step = 1; step <= 300; ++step) {
      const double now_s = step * step_s;
      whole.advanceTo(now_s), forgetful.advanceTo(now_s);
      forgetful.forgetBefore(now_s - step_s);
      forgotten_s = now_s - step_s;
      if (step % 3 != 0) continue;
      const Stroke stroke =
          strokeOn(random, setup, static_cast<std::size_t>(random.in(0.0, 10.0)), forgotten_s + 1e-9);
      whole.strike(stroke), forgetful.strike(stroke);
      ++strokes;
      for (std::size_t puck = 0; puck < setup.pucks.size(); ++puck) {
        const Knots all = whole.worldLines()[puck].knots(), kept = forgetful.worldLines()[puck].knots();
        ASSERT_LE(kept.size(), all.size());
        ASSERT_LE(kept[0].turn.t_s, std::max(forgotten_s, all[0].turn.t_s))
            << "needed at " << forgotten_s << " s";
        for (std::size_t k = 0; k < kept.size(); ++k) {
          const Knot &one = all[all.size() - kept.size() + k], &other = kept[k];
          ASSERT_EQ(one.turn.t_s, other.turn.t_s) << "puck " << puck << " at step " << step;
          ASSERT_EQ(one.turn.r_m, other.turn.r_m);
          ASSERT_EQ(one.u, other.u);
        }
      }
    }
  }
  EXPECT_GT(strokes, 500);
}

}  // namespace
}  // namespace carom
