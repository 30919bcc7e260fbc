// Strokes, and the games that they change.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "engine/balance.h"
#include "engine/billiard/billiard.h"
#include "engine/gas.h"
#include "engine/three_pucks.h"

namespace carom {
namespace {

using namespace test;

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
  const Knots knots = with.worldLines()[1].knots();
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

// What is not forgotten can be struck however long the game goes on after it.
TEST(BilliardStroke, reachesTheFirstMomentThatIsNotForgotten) {
  const BilliardSetup setup = test::gasSetup(8, 0.15, 1.6, 22);
  const Stroke stroke{3, 4.001, std::nullopt, {0.4, 0.2}};
  Billiard forgets(setup), scripted(withStroke(setup, stroke));
  forgets.advanceTo(4.0);
  forgets.forgetBefore(4.0);
  const std::size_t known = forgets.events().size();
  forgets.advanceTo(200.0);
  EXPECT_GT(forgets.events().size(), known + 2000);
  forgets.strike(stroke);
  scripted.advanceTo(200.0);
  for (std::size_t i = 0; i < setup.pucks.size(); ++i) {
    const Motion ours = forgets.worldLines()[i].at(200.0), theirs = scripted.worldLines()[i].at(200.0);
    EXPECT_EQ(ours.event.r_m, theirs.event.r_m);
    EXPECT_EQ(ours.u, theirs.u);
    EXPECT_EQ(ours.properTime_s, theirs.properTime_s);
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
      const Knots here = copy[i].knots(), there = billiard.worldLines()[i].knots();
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

// Hands on both sides of a puck at rest: their light arrives at one event.
TEST(BilliardStroke, thoseThatArriveTogetherActInAnOrderOfTheirOwn) {
  BilliardSetup setup = table(2.84, 1.42);
  setup.pucks = {{"white", 0.0305, 0.02, 0.2, {0.0, 0.0}, {0.0, 0.0}},
                 {"red", 0.0305, 0.02, 0.2, {0.6, 0.1}, {0.0, 0.0}}};
  const Stroke left{0, 1.0, Vec3(-0.5, 0.0, 0.25), {0.21, 0.03}, 0.011};
  const Stroke right{0, 1.0, Vec3(0.5, 0.0, 0.25), {0.07, -0.05}, -0.02};
  const auto gameOf = [&](const std::vector<Stroke>& strokes) {
    setup.strokes = strokes;
    Billiard game(setup);
    game.advanceTo(10.0);
    return transcript(game, setup.pucks);
  };
  const std::string game = gameOf({left, right});
  EXPECT_EQ(gameOf({right, left}), game);
  for (const auto& [first, second] : {std::pair(left, right), std::pair(right, left)}) {
    setup.strokes.clear();
    Billiard live(setup);
    live.advanceTo(3.0);
    live.strike(first);
    live.advanceTo(7.0);
    live.strike(second);
    live.advanceTo(10.0);
    EXPECT_EQ(transcript(live, setup.pucks), game);
  }
}

}  // namespace
}  // namespace carom
