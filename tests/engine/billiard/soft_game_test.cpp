// Soft pucks in a game beside rigid ones: who becomes soft, what is kept, and that nothing depends on how one
// advances.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <limits>
#include <span>
#include <vector>

#include "engine/billiard/billiard.h"
#include "engine/game/soft_puck_mesh.h"
#include "engine/light/vertex_history.h"
#include "engine/random_world.h"
#include "engine/soft/soft_history.h"

namespace carom {
namespace {

constexpr double kC = 1.42, kRadius = 0.0305;

Puck disc(const std::string& name, const Vec2& position_m, const Vec2& beta) {
  Puck puck;
  puck.name = name;
  puck.radius_m = kRadius;
  puck.height_m = 0.02;
  puck.mass_kg = 0.2;
  puck.position_m = position_m;
  puck.beta = beta;
  return puck;
}

Puck soft(const std::string& name, const Vec2& position_m, const Vec2& beta, int cells = 5) {
  Puck puck = disc(name, position_m, beta);
  puck.soft = SoftMatter{0.5, cells, 0.3, {}};
  return puck;
}

/// A soft puck, a rigid one that it meets, and two rigid ones that meet far away; with a stroke.
BilliardSetup mixed() {
  BilliardSetup setup;
  setup.lightSpeed_m_s = kC;
  setup.board = Board{1.2, 0.8};
  setup.pucks = {disc("one", {0.1, 0.01}, {-0.2, 0.0}), soft("jelly", {-0.2, 0.0}, {0.4, 0.0}),
                 disc("far", {0.3, 0.3}, {0.3, 0.0}), disc("off", {0.5, 0.3}, {-0.1, 0.0})};
  setup.strokes = {
      {.puck = 1, .at_s = 0.05, .from_m = Vec3(-0.4, 0.0, 0.1), .momentum_kg_m_s = {0.05, 0.02}}};
  return setup;
}

bool sameLines(const Billiard& a, const Billiard& b, double until_s, std::size_t swapped = 0) {
  for (std::size_t i = 0; i < a.worldLines().size(); ++i) {
    const std::size_t other = swapped ? (i + swapped) % a.worldLines().size() : i;
    for (double t_s = 0.0; t_s <= until_s; t_s += 0.01) {
      const Motion one = a.worldLines()[i].at(t_s), two = b.worldLines()[other].at(t_s);
      if (one.event.r_m != two.event.r_m || one.u != two.u) return false;
    }
  }
  return true;
}

/// L(v) d = d − γ/(γ+1) (v·d) v
Vec2 contracted(const Vec2& d, const Vec2& v) {
  const double gamma = 1.0 / std::sqrt(1.0 - glm::dot(v, v));
  return d - gamma / (gamma + 1.0) * glm::dot(v, d) * v;
}

void expectKept(const Ledger& before, const Ledger& after) {
  const double energy = after.motion.energy_j + after.radiated.energy_j - after.givenByStrokes.energy_j;
  const Vec2 momentum = after.motion.momentum_kg_m_s + after.radiated.momentum_kg_m_s +
                        after.takenByCushions.momentum_kg_m_s - after.givenByStrokes.momentum_kg_m_s;
  const double scale = before.motion.energy_j;
  EXPECT_NEAR(energy, scale, 1e-12 * scale);
  EXPECT_NEAR(momentum.x, before.motion.momentum_kg_m_s.x, 1e-12 * scale / kC);
  EXPECT_NEAR(momentum.y, before.motion.momentum_kg_m_s.y, 1e-12 * scale / kC);
}

TEST(SoftGame, ARigidPuckBecomesSoftWhenASoftOneComesNear) {
  Billiard billiard(mixed());
  const Ledger before = billiard.ledger();
  billiard.advanceTo(0.8);
  const SoftMoment moment = billiard.softAt(0.8, {});
  ASSERT_TRUE(moment.pucks[0] && moment.pucks[1]);
  EXPECT_FALSE(moment.pucks[2] || moment.pucks[3]);
  EXPECT_FALSE(moment.pucks[1]->becameSoft_s.has_value());
  ASSERT_TRUE(moment.pucks[0]->becameSoft_s.has_value());
  EXPECT_GT(moment.pucks[0]->position_m.x, -0.1);
  ASSERT_FALSE(moment.contacts.empty());
  EXPECT_FALSE(moment.contacts[0].cushion.has_value());
  EXPECT_GT(moment.contacts[0].contact.t_s, *moment.pucks[0]->becameSoft_s);
  EXPECT_LT(moment.contacts[0].contact.t_s - *moment.pucks[0]->becameSoft_s, 0.03);
  bool rigidMet = false, softMet = false, struck = false;
  for (const GameEvent& event : billiard.events()) {
    rigidMet = rigidMet || event.kind == EventKind::puckPuck;
    softMet = softMet || event.kind == EventKind::softSoft;
    struck = struck || event.kind == EventKind::stroke;
  }
  EXPECT_TRUE(rigidMet && softMet && struck);
  expectKept(before, billiard.ledger());
  EXPECT_TRUE(billiard.frozen().empty());
  // The lines follow the centres of energy.
  for (const std::size_t i : {0u, 1u}) {
    const Vec2 line(billiard.worldLines()[i].at(0.8).event.r_m);
    EXPECT_NEAR(glm::length(line - moment.pucks[i]->position_m), 0.0, 1e-4);
  }
}

TEST(SoftGame, HasTheSameBitsInAnyStepsAndAnyOrderOfTheFile) {
  const BilliardSetup setup = mixed();
  Billiard atOnce(setup), bySteps(setup);
  atOnce.advanceTo(0.7);
  for (double t_s = 0.0; t_s < 0.7; t_s += 0.013) bySteps.advanceTo(t_s);
  bySteps.advanceTo(0.7);
  EXPECT_TRUE(sameLines(atOnce, bySteps, 0.7));
  EXPECT_EQ(atOnce.softAt(0.7).pucks[1]->heat_j, bySteps.softAt(0.7).pucks[1]->heat_j);

  BilliardSetup turned = setup;
  std::rotate(turned.pucks.begin(), turned.pucks.begin() + 3, turned.pucks.end());
  turned.strokes[0].puck = 2;
  Billiard other(turned);
  other.advanceTo(0.7);
  EXPECT_TRUE(sameLines(atOnce, other, 0.7, 1));
}

// A stroke that comes while the game is ahead of it leads to the same as one that was told at the beginning.
TEST(SoftGame, AStrokeRewindsToTheSameBits) {
  for (const std::size_t puck : {0u, 1u, 2u}) {
    SCOPED_TRACE(puck);
    BilliardSetup setup = mixed();
    const Stroke late{
        .puck = puck, .at_s = 0.25, .from_m = Vec3(0.0, 0.3, 0.2), .momentum_kg_m_s = {0.02, -0.08}};
    Billiard hand(setup);
    hand.advanceTo(0.6);
    const double arrives_s = hand.strike(late);
    EXPECT_GT(arrives_s, 0.25);
    setup.strokes.push_back(late);
    Billiard told(setup);
    told.advanceTo(0.6);
    EXPECT_TRUE(sameLines(hand, told, 0.6));
    EXPECT_EQ(hand.softAt(0.6).pucks[1]->heat_j, told.softAt(0.6).pucks[1]->heat_j);
    ASSERT_EQ(hand.events().size(), told.events().size());
    for (std::size_t k = 0; k < hand.events().size(); ++k) {
      EXPECT_EQ(hand.events()[k].at.t_s, told.events()[k].at.t_s);
      EXPECT_EQ(hand.events()[k].kind, told.events()[k].kind);
    }
  }
}

// What changes is reported as in any game: the receiver's lines are those of the game.
TEST(SoftGame, ReportsItsChanges) {
  Billiard billiard(mixed());
  std::vector<WorldLine> lines(billiard.worldLines().begin(), billiard.worldLines().end());
  const auto take = [&] {
    const Changes changes = billiard.takeChanges();
    if (changes.truncatedFrom_s)
      for (WorldLine& line : lines) line.truncateFrom(*changes.truncatedFrom_s);
    for (const Changes::NewKnot& knot : changes.knots) lines[knot.puck].append(knot.knot);
  };
  for (double t_s = 0.1; t_s < 0.55; t_s += 0.1) billiard.advanceTo(t_s), take();
  billiard.strike({.puck = 1, .at_s = 0.4, .from_m = Vec3(0.0, 0.2, 0.1), .momentum_kg_m_s = {0.0, -0.1}});
  take();
  for (std::size_t i = 0; i < lines.size(); ++i) {
    ASSERT_EQ(lines[i].knots().size(), billiard.worldLines()[i].knots().size()) << i;
    for (double t_s = 0.0; t_s < 0.5; t_s += 0.02)
      EXPECT_EQ(lines[i].at(t_s).event.r_m, billiard.worldLines()[i].at(t_s).event.r_m) << i;
  }
}

// First touch, parting with the heat of the collision, and the far side of each puck, in this order.
TEST(SoftGame, ListsWhatHappensToSoftPucks) {
  BilliardSetup setup = mixed();
  setup.strokes.clear();
  Billiard billiard(setup);
  billiard.advanceTo(0.9);
  const SoftMoment moment = billiard.softAt(0.9);
  ASSERT_FALSE(moment.contacts.empty());
  const SoftContactState& contact = moment.contacts[0];
  std::vector<const GameEvent*> touches, partings, farSides;
  for (const GameEvent& event : billiard.events()) {
    if (event.kind == EventKind::softSoft) touches.push_back(&event);
    if (event.kind == EventKind::parted) partings.push_back(&event);
    if (event.kind == EventKind::farSide) farSides.push_back(&event);
  }
  ASSERT_EQ(touches.size(), 1u);
  ASSERT_GE(partings.size(), 1u);
  ASSERT_GE(farSides.size(), 2u);
  EXPECT_EQ(touches[0]->at.t_s, contact.contact.t_s);
  EXPECT_EQ(touches[0]->heat_j, 0.0);
  EXPECT_EQ(partings[0]->at.t_s, contact.parted_s.value());
  EXPECT_EQ(partings[0]->heat_j, contact.heat_j);
  EXPECT_GT(partings[0]->heat_j, 0.0);
  EXPECT_EQ(partings[0]->which, touches[0]->which);
  EXPECT_EQ(partings[0]->turns.size(), 2u);
  EXPECT_NE(farSides[0]->turns[0].puck, farSides[1]->turns[0].puck);
  for (std::size_t k = 0; k < 2; ++k) {
    const double way_m = glm::distance(farSides[k]->at.r_m, touches[0]->at.r_m);
    EXPECT_GT(kC * (farSides[k]->at.t_s - touches[0]->at.t_s), way_m) << "slower than light";
    EXPECT_GT(way_m, 0.9 * kRadius) << "the far side";
    EXPECT_LT(farSides[k]->at.t_s, partings[0]->at.t_s);
  }
}

/// The rows of a game as a node keeps them.
struct KeptRows {
  std::vector<SoftHistory> bodies = std::vector<SoftHistory>(4);

  void take(Billiard& billiard) {
    SoftRows rows;
    billiard.takeSoftRows(rows);
    for (SoftHistory& body : bodies) body.truncateFrom(rows.truncatedFrom);
    std::size_t node = 0;
    for (const SoftRow& row : rows.rows) {
      bodies[row.body].append(row, std::span(rows.nodes).subspan(node, row.nodes));
      node += row.nodes;
    }
  }
};

bool sameRows(const SoftHistory& a, const SoftHistory& b, double until) {
  for (std::size_t k = 0;; ++k) {
    const bool ends = k >= a.rowCount() || a.row(k).time > until;
    if (ends != (k >= b.rowCount() || b.row(k).time > until)) return false;
    if (ends) return k > 1;
    const auto bytes = [](const auto& value) { return std::as_bytes(std::span(&value, 1)); };
    const auto one = bytes(a.row(k)), two = bytes(b.row(k));
    const auto nodes = std::as_bytes(a.nodesOf(k)), others = std::as_bytes(b.nodesOf(k));
    if (!std::equal(one.begin(), one.end(), two.begin(), two.end())) return false;
    if (!std::equal(nodes.begin(), nodes.end(), others.begin(), others.end())) return false;
  }
}

// Rows do not depend on the steps in which one advances, nor on what else was asked for; a stroke takes them
// back.
TEST(SoftGame, RowsHaveTheSameBitsInAnyStepsAndAfterAStroke) {
  const Stroke late{.puck = 1, .at_s = 0.25, .from_m = Vec3(0.0, 0.3, 0.2), .momentum_kg_m_s = {0.02, -0.08}};
  BilliardSetup setup = mixed();
  Billiard hand(setup);
  KeptRows byHand, byText;
  for (double t_s = 0.0; t_s < 0.6; t_s += 0.017) {
    hand.advanceTo(t_s);
    if (t_s > 0.3) hand.softAt(t_s);
    byHand.take(hand);
  }
  hand.advanceTo(0.6);
  hand.strike(late);
  byHand.take(hand);
  setup.strokes.push_back(late);
  Billiard told(setup);
  told.advanceTo(0.6);
  byText.take(told);
  for (const std::size_t puck : {0u, 1u}) {
    SCOPED_TRACE(puck);
    EXPECT_TRUE(sameRows(byHand.bodies[puck], byText.bodies[puck], 0.6 * kC));
    const SoftHistory& rows = byText.bodies[puck];
    EXPECT_GE(rows.row(rows.rowCount() - 1).time, 0.6 * kC);  // as far as eyes can see
  }
  EXPECT_EQ(byText.bodies[2].rowCount() + byText.bodies[3].rowCount(), 0U);
}

// A puck that becomes soft just after a bounce is drawn from where its rim is: that has not heard of it all
// round. Before, between and after, no point moves as fast as light.
TEST(SoftGame, RowsBeginWhereTheRimIs) {
  BilliardSetup setup;
  setup.lightSpeed_m_s = kC;
  setup.board = Board{1.2, 0.8};
  // The rigid puck comes back from the cushion when the soft one is there.
  setup.pucks = {disc("rigid", {0.5, 0.0}, {0.6, 0.0}), soft("jelly", {0.455, 0.06}, {0.3, 0.0})};
  Billiard billiard(setup);
  KeptRows kept;
  billiard.advanceTo(0.5);
  kept.take(billiard);
  const SoftHistory& rows = kept.bodies[0];
  ASSERT_GT(rows.rowCount(), 2U);
  EXPECT_EQ(rows.row(0).wasRigid, 1);
  WorldLine before = billiard.worldLines()[0];
  const double t_s = rows.row(0).time / kC;
  before.truncateFrom(t_s);
  const SoftMesh mesh = softMeshOf(setup.pucks[0]);
  double farthest = 0.0;
  for (std::size_t i = 0; i < mesh.places().size(); ++i) {
    const auto history = vertexHistory(before, {mesh.places()[i], 0.01});
    const Vec2 rim(placeAt(pieceAt(history, t_s), t_s, kC));
    EXPECT_NEAR(glm::length(rim - rows.place(0, i)), 0.0, 1e-7);
    const Motion centre = before.at(t_s);
    const Vec2 along = Vec2(centre.u) / gammaFromU(centre.u);
    farthest =
        std::max(farthest, glm::length(rim - Vec2(centre.event.r_m) - contracted(mesh.places()[i], along)));
  }
  EXPECT_GT(farthest, 1e-3);  // some of it has not heard: the case is one
}

/// Returns the memory of a row with its nodes.
std::size_t bytesOf(const SoftRow& row) { return sizeof(SoftRow) + row.nodes * sizeof(SoftNode); }

// At most 2 MB a metre of light of an awake puck of 12 cells: a bounce at 0.6 c with what rings after it.
TEST(SoftGame, RowsOfAnAwakePuckAreSmall) {
  BilliardSetup setup;
  setup.lightSpeed_m_s = kC;
  setup.board = Board{0.3, 0.3};
  setup.pucks = {soft("jelly", {0.1, 0.0}, {0.6, 0.0}, 12)};
  Billiard billiard(setup);
  billiard.advanceTo(20.0 * kRadius / kC);
  SoftRows rows;
  billiard.takeSoftRows(rows);
  std::size_t bytes = 0;
  double from = 0.0, until = 0.0;
  for (const SoftRow& row : rows.rows) {
    if (row.isStill == 1) continue;
    bytes += bytesOf(row);
    from = from == 0.0 ? row.time : from;
    until = row.time;
  }
  EXPECT_GT(until - from, 15.0 * kRadius);
  EXPECT_LT(static_cast<double>(bytes), 2e6 * (until - from));
  EXPECT_GT(static_cast<double>(bytes), 1e5 * (until - from));
}

// A puck that is struck every second for an hour keeps no more after the first minute. In short, four
// minutes; CAROM_SOFT=1 plays the hour.
TEST(SoftGame, AnHourKeepsNoMoreThanItsFirstMinute) {
  BilliardSetup setup;
  setup.lightSpeed_m_s = kC;
  setup.board = Board{0.3, 0.2};
  setup.pucks = {soft("jelly", {0.0, 0.0}, {0.0, 0.0}, 4)};
  Billiard billiard(setup);
  SoftHistory history;
  std::size_t inFirst = 0, after = 0;
  const int until_s = std::getenv("CAROM_SOFT") != nullptr ? 3600 : 90;
  for (int t_s = 1; t_s <= until_s; ++t_s) {
    const double way = t_s % 2 == 0 ? 1.0 : -1.0;
    billiard.advanceTo(t_s);
    billiard.strike({.puck = 0,
                     .at_s = static_cast<double>(t_s),
                     .from_m = Vec3(0.0, 0.0, 0.1),
                     .momentum_kg_m_s = {0.08 * way, 0.01 * (t_s % 5 - 2)}});
    billiard.advanceTo(t_s + 0.5);
    SoftRows rows;
    billiard.takeSoftRows(rows);
    history.truncateFrom(rows.truncatedFrom);
    std::size_t node = 0;
    for (const SoftRow& row : rows.rows) {
      history.append(row, std::span(rows.nodes).subspan(node, row.nodes));
      node += row.nodes;
    }
    std::size_t& most = t_s <= 60 ? inFirst : after;
    most = std::max(most, history.rowCount());
    billiard.forgetBefore(t_s - 0.5);
    history.forgetBefore((t_s - 0.5) * kC);
  }
  EXPECT_GT(inFirst, 30U);
  EXPECT_LT(static_cast<double>(after), 1.3 * static_cast<double>(inFirst));
}

TEST(SoftGame, ForgetsThePast) {
  BilliardSetup setup = mixed();
  Billiard billiard(setup), whole(setup);
  for (double t_s = 0.05; t_s < 1.0; t_s += 0.05) {
    billiard.advanceTo(t_s);
    billiard.forgetBefore(t_s - 0.2);
  }
  whole.advanceTo(0.95);
  EXPECT_LT(billiard.worldLines()[1].knots().size(), whole.worldLines()[1].knots().size());
  EXPECT_EQ(billiard.worldLines()[1].at(0.94).event.r_m, whole.worldLines()[1].at(0.94).event.r_m);
  EXPECT_THROW(
      billiard.strike({.puck = 1, .at_s = 0.1, .from_m = Vec3(0.0, 0.0, 0.1), .momentum_kg_m_s = {0.1, 0.0}}),
      std::invalid_argument);
}

// A told body that pushes a rod into a cushion crushes it more than can be computed: the game goes on.
TEST(SoftGame, GoesOnWhereATellerCrushes) {
  BilliardSetup setup;
  setup.lightSpeed_m_s = kC;
  setup.board = Board{0.6, 0.4};
  Puck rod = disc("rod", {0.0, 0.0}, {0.0, 0.0});
  rod.outline_m = {{-0.1, -0.05}, {0.1, -0.05}, {0.1, 0.05}, {-0.1, 0.05}};
  rod.radius_m = std::hypot(0.1, 0.05);
  rod.soft = SoftMatter{0.5, 6, 0.15, {{false, {{0.1, {0.5, 0.0}}}}}};
  setup.pucks = {rod};
  Billiard billiard(setup);
  EXPECT_NO_THROW(billiard.advanceTo(1.5));
  for (const Knot& knot : billiard.worldLines()[0].knots()) EXPECT_TRUE(std::isfinite(knot.u.x));
}

TEST(SoftGame, PointsOfTheMatterAreFollowed) {
  BilliardSetup setup;
  setup.lightSpeed_m_s = kC;
  setup.pucks = {soft("jelly", {0.0, 0.0}, {0.6, 0.0})};
  Billiard billiard(setup);
  billiard.advanceTo(0.333);
  const std::vector<SoftPoint> points{{0, {0.02, 0.01}}, {0, {0.0, 0.0}}};
  const SoftMoment moment = billiard.softAt(0.333, points);
  ASSERT_TRUE(moment.points[0] && moment.points[1]);
  const double x_m = 0.6 * kC * 0.333;
  EXPECT_NEAR(moment.points[0]->position_m.x, x_m + 0.8 * 0.02, 1e-14);
  EXPECT_NEAR(moment.points[0]->position_m.y, 0.01, 1e-14);
  EXPECT_NEAR(moment.points[1]->position_m.x, x_m, 1e-14);
  EXPECT_NEAR(moment.points[1]->properTime_s, 0.8 * 0.333, 1e-14);
  EXPECT_NEAR(moment.pucks[0]->beta.x, 0.6, 1e-14);
}

// By hand, too, nothing turns a puck in such a game.
TEST(SoftGame, AStrokeBesideTheCentreTurnsNothing) {
  Billiard billiard(mixed());
  billiard.advanceTo(0.2);
  billiard.strike({.puck = 2,
                   .at_s = 0.2,
                   .from_m = Vec3(0.0, 0.3, 0.2),
                   .momentum_kg_m_s = {0.02, 0.0},
                   .offset_m = 0.02});
  billiard.advanceTo(0.6);
  for (const WorldLine& line : billiard.worldLines())
    for (const Knot& knot : line.knots()) EXPECT_FALSE(spins(knot));
}

TEST(SoftGame, RefusesWhatCannotBePlayed) {
  const auto refused = [](auto change) {
    BilliardSetup setup = mixed();
    change(setup);
    EXPECT_THROW(Billiard{setup}, std::invalid_argument);
  };
  refused([](BilliardSetup& setup) { setup.pucks[1].soft->soundSpeed = 0.8; });
  refused([](BilliardSetup& setup) { setup.pucks[1].soft->soundSpeed = 0.0; });
  refused([](BilliardSetup& setup) { setup.pucks[1].soft->cells = 41; });
  refused([](BilliardSetup& setup) { setup.pucks[1].soft->viscosity = 0.0; });
  refused([](BilliardSetup& setup) { setup.rules.friction_m_s2 = 0.1; });
  refused([](BilliardSetup& setup) { setup.rules.puckFriction = 0.1; });
  refused([](BilliardSetup& setup) { setup.rules.stiffSoundSpeed = 0.9; });
  refused([](BilliardSetup& setup) { setup.pucks[0].spin_kg_m2_s = 1e-5; });
  refused([](BilliardSetup& setup) { setup.strokes[0].offset_m = 0.01; });
}

}  // namespace
}  // namespace carom
