// Soft bodies beside each other, cushions, strokes and told bodies: what wakes them, what they exchange, how
// they sleep again.

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <memory>

#include "engine/random_world.h"
#include "engine/soft/soft_discs.h"
#include "engine/soft/soft_play.h"
#include "sanitized.h"

namespace carom {
namespace {

using test::kMass, test::kRadius, test::movingWith;

SoftEntry disc(const std::string& name, int cells, const glm::dvec2& centre, const glm::dvec2& beta,
               const SoftMaterial& material = {}) {
  return {name,     std::make_shared<SoftMesh>(softDisc(kRadius, cells)),
          material, kMass,
          centre,   movingWith(beta),
          0.0,      {}};
}

void playTo(SoftPlay& play, double time) {
  while (play.time() < time) play.playSlice();
}

SoftMesh::Inside node(std::size_t i) { return {{i, i, i}, {1.0, 0.0, 0.0}}; }

double speedOf(const SoftTotals& totals) {
  return std::hypot(totals.momentum.x, totals.momentum.y) / totals.momentum.t;
}

// From rest, p = 0.3, 1, 2 m c leave at 0.286, 0.695, 0.875 c with 1.007, 1.035, 1.104 of the mass, by
// another program.
TEST(SoftPlay, AStrokeGivesItsMomentumExactly) {
  struct Case {
    double p, speed, mass;
  };
  for (const Case& one : {Case{0.3, 0.286, 1.007}, Case{1.0, 0.695, 1.035}, Case{2.0, 0.875, 1.104}}) {
    SCOPED_TRACE(one.p);
    SoftPlay play({});
    play.add(disc("disc", 10, {0.0, 0.0}, {0.0, 0.0}));
    SoftStroke stroke;
    stroke.hand.t = 0.0123;
    stroke.momentum = {one.p * kMass, 0.0};
    play.addStroke(stroke);
    playTo(play, 0.01);
    EXPECT_FALSE(play.isAwake(0));
    const std::size_t front = play.body(0).mesh().hull().front();
    playTo(play, 0.0123 + 0.75 * kRadius);
    EXPECT_TRUE(play.isAwake(0));
    EXPECT_NEAR(play.place(0, node(front)).x, kRadius, 0.002 * kRadius) << "the far side waits";
    playTo(play, 0.6);
    const SoftTotals after = play.totals(0);
    EXPECT_NEAR(after.momentum.x, one.p * kMass, 1e-14);
    EXPECT_NEAR(after.momentum.y, 0.0, 1e-14);
    EXPECT_NEAR(speedOf(after), one.speed, 0.002);
    EXPECT_NEAR(after.restMass() / kMass, one.mass, 0.008);
    EXPECT_NEAR(after.momentum.t - kMass, play.accounts().givenByStrokes.t, 1e-14);
    EXPECT_NEAR(play.strokeBegan(0).value_or(0.0), 0.0123, 1e-15);
  }
}

// The force of a hand begins, node by node, where its light arrives: outside of its future nothing moves but
// for the numerical precursor.
TEST(SoftPlay, AStrokeIsNotFeltOutsideTheFutureOfTheHand) {
  SoftPlay play({});
  play.add(disc("disc", 16, {0.0, 0.0}, {0.0, 0.0}));
  SoftStroke stroke;
  stroke.hand = {0.0, -0.1, 0.05};
  stroke.height = 0.08;
  stroke.hasPlace = true;
  stroke.momentum = {0.5 * kMass, -0.2 * kMass};
  play.addStroke(stroke);
  const SoftMesh& mesh = play.body(0).mesh();
  double moved = 0.0;
  while (play.time() < 0.3) {
    play.playSlice();
    const double lit = play.time() + 2.0 * kRadius / 16;
    for (std::size_t i = 0; i < mesh.places().size(); ++i) {
      const glm::dvec2 way = mesh.places()[i] - glm::dvec2(-0.1, 0.05);
      if (std::hypot(glm::length(way), 0.08) < lit) continue;
      moved = std::max(moved, glm::length(play.place(0, node(i)) - mesh.places()[i]));
    }
  }
  EXPECT_LT(moved, 2e-6 * kRadius);
  EXPECT_NEAR(play.totals(0).momentum.x, 0.5 * kMass, 1e-14);
  EXPECT_NEAR(play.totals(0).momentum.y, -0.2 * kMass, 1e-14);
}

// A puck that is awake flies as one that is asleep, for half a metre, and as one that has been woken a second
// earlier.
TEST(SoftPlay, FreeFlightIsTheSameAwakeAndAsleep) {
  constexpr double kWakes = 1.42, kEnds = kWakes + 0.5 / 0.9;
  SoftPlay asleep({}), awake({}), earlier({});
  for (SoftPlay* play : {&asleep, &awake, &earlier})
    play->add(disc("disc", 10, {0.0, 0.0}, {0.9 * 0.8, 0.9 * 0.6}));
  const auto keepAwake = [](SoftPlay& play, double from) {
    SoftStroke none;  // wakes it, and gives nothing
    none.momentum = {1e-30, 0.0};
    for (none.hand.t = from; none.hand.t < kEnds; none.hand.t += 0.1) play.addStroke(none);
  };
  keepAwake(earlier, 0.0);
  keepAwake(awake, kWakes);
  playTo(awake, kWakes - 0.01);
  playTo(earlier, kWakes - 0.01);
  EXPECT_FALSE(awake.isAwake(0));
  EXPECT_TRUE(earlier.isAwake(0));
  for (SoftPlay* play : {&asleep, &awake, &earlier}) playTo(*play, kEnds);
  for (const SoftPlay* play : {&awake, &earlier}) {
    EXPECT_TRUE(play->isAwake(0));
    for (std::size_t i = 0; i < asleep.body(0).size(); ++i) {
      EXPECT_NEAR(play->place(0, node(i)).x, asleep.place(0, node(i)).x, 1e-12);
      EXPECT_NEAR(play->place(0, node(i)).y, asleep.place(0, node(i)).y, 1e-12);
      EXPECT_NEAR(play->clock(0, node(i)), asleep.clock(0, node(i)), 1e-12);
      EXPECT_NEAR(asleep.clock(0, node(i)), asleep.time() * std::sqrt(1.0 - 0.81), 1e-12);
    }
  }
}

TEST(SoftPlay, ACollisionWithACushionIsRecorded) {
  const double offset = 0.1, speed = 0.6;
  SoftPlay play({{{1.0, 0.0}, offset}});
  play.add(disc("disc", 10, {0.0, 0.0}, {speed, 0.0}));
  const Vec21 before = play.totals(0).momentum;
  const double touches = (offset - kRadius * std::sqrt(1.0 - speed * speed)) / speed;
  playTo(play, touches + 0.5 * kRadius);
  ASSERT_EQ(play.collisions().size(), 1u);
  EXPECT_FALSE(play.collisions()[0].isOver);
  playTo(play, touches + 12.0 * kRadius);
  ASSERT_EQ(play.collisions().size(), 1u);
  const SoftCollision& one = play.collisions()[0];
  EXPECT_TRUE(one.isOver);
  EXPECT_EQ(one.body, 0u);
  EXPECT_EQ(one.cushion, 0u);
  EXPECT_NEAR(one.contact.t, touches, 1e-5);
  EXPECT_NEAR(one.contact.x, offset, 1e-12);
  EXPECT_NEAR(one.contact.y, 0.0, 1e-3 * kRadius);
  EXPECT_GT(one.lastTouch, one.contact.t + 2.5 * kRadius);
  EXPECT_LT(one.lastTouch, one.contact.t + 5.0 * kRadius);
  const SoftTotals after = play.totals(0);
  EXPECT_NEAR(one.impulse.x, after.momentum.x - before.x, 1e-14);
  EXPECT_NEAR(play.accounts().taken.x, -one.impulse.x, 1e-14);
  EXPECT_NEAR(one.heat(), after.heat, 0.03 * kMass);
  EXPECT_GT(one.heat(), 0.05 * kMass);
}

// Left alone it falls asleep: the energy stays, all of it that is not motion is heat, and no point jumps.
TEST(SoftPlay, SleepsAgainWithTheMassThatItHasGot) {
  SoftPlay play({{{1.0, 0.0}, 0.05}});
  play.add(disc("disc", 6, {0.0, 0.0}, {0.3, 0.0}, {0.5, 1.0}));
  playTo(play, 0.2);
  ASSERT_TRUE(play.isAwake(0));
  SoftTotals before = play.totals(0);
  std::vector<glm::dvec2> places(play.body(0).size());
  double jump = 0.0;
  while (play.isAwake(0) && play.time() < 20.0) {
    before = play.totals(0);
    for (std::size_t i = 0; i < places.size(); ++i) places[i] = play.place(0, node(i));
    play.playSlice();
  }
  ASSERT_FALSE(play.isAwake(0)) << play.time();
  const SoftTotals after = play.totals(0);
  for (std::size_t i = 0; i < places.size(); ++i)
    jump = std::max(jump, glm::length(play.place(0, node(i)) - places[i]));
  EXPECT_LT(jump, SoftPlay::kSlice);
  EXPECT_NEAR(after.momentum.t, before.momentum.t, 1e-14);
  EXPECT_NEAR(after.momentum.x, before.momentum.x, 1e-14);
  EXPECT_NEAR(after.elastic, 0.0, 1e-14);
  EXPECT_NEAR(after.heat, after.restMass() - kMass, 1e-14);
  EXPECT_GT(after.restMass(), 1.005 * kMass);
  const double from = after.centre.x;
  playTo(play, play.time() + 1.0);
  EXPECT_NEAR(play.totals(0).centre.x, from + 1.0 * after.momentum.x / after.momentum.t,
              2.0 * SoftPlay::kSlice);
  EXPECT_FALSE(play.isAwake(0));
}

// Two that lie beside each other at rest, hardly apart, do not keep each other awake; one that comes near
// wakes them.
TEST(SoftPlay, NeighboursAtRestSleep) {
  SoftPlay play({});
  play.add(disc("a", 4, {0.0, 0.0}, {0.0, 0.0}));
  play.add(disc("b", 4, {2.0001 * kRadius, 0.0}, {0.0, 0.0}));
  play.add(disc("c", 4, {0.5, 0.0}, {-0.5, 0.0}));
  playTo(play, 0.3);
  EXPECT_FALSE(play.isAwake(0) || play.isAwake(1) || play.isAwake(2));
  playTo(play, 0.9);
  EXPECT_TRUE(play.isAwake(0) && play.isAwake(1) && play.isAwake(2));
  EXPECT_LT(play.totals(0).momentum.x, -0.02 * kMass);
}

TEST(SoftPlay, TellsWhichRigidBodiesComeWithinReach) {
  SoftPlay play({});
  play.add(disc("a", 4, {0.0, 0.0}, {0.0, 0.0}));
  const std::vector<RigidNeighbour> rigid{{{2.0 * kRadius + 0.009, 0.0}, kRadius},
                                          {{2.0 * kRadius + 0.011, 0.0}, kRadius}};
  EXPECT_EQ(play.reached(rigid), std::vector<std::size_t>{0});
}

// Several bodies, a cushion and strokes: what one gets another has given, to rounding.
TEST(SoftPlay, KeepsItsBooks) {
  test::Random random(23);
  for (int k = 0; k < 8; ++k) {
    CASE(random, k);
    SoftPlay play({{{1.0, 0.0}, 0.15}, {{0.0, 1.0}, 0.12}});
    double elastic = 0.0;
    for (int i = 0; i < 3; ++i) {
      const glm::dvec2 beta = random.in(0.0, 0.6) * glm::dvec2(random.in(0.3, 0.9), random.in(-0.4, 0.4));
      SoftEntry entry =
          disc(std::string(1, static_cast<char>('a' + i)), 5, {-0.08 + 0.08 * i, random.in(-0.03, 0.03)},
               beta, {random.in(0.3, 0.7), random.in(0.1, 0.5)});
      entry.mass *= random.in(0.5, 2.0);
      play.add(entry);
    }
    SoftStroke stroke;
    stroke.hand = {random.in(0.0, 0.2), random.in(-0.3, 0.3), 0.2};
    stroke.height = 0.1;
    stroke.hasPlace = k % 2 == 0;
    stroke.momentum = {random.in(-0.1, 0.1), random.in(-0.1, 0.1)};
    stroke.body = 1;
    play.addStroke(stroke);
    const SoftAccounts before = play.accounts();
    std::vector<double> heat(3, 0.0);
    while (play.time() < 0.6) {
      play.playSlice();
      for (std::size_t i = 0; i < 3; ++i) {
        const SoftTotals totals = play.totals(i);
        EXPECT_GT(totals.heat, heat[i] - 2e-3 * play.body(i).mass());
        heat[i] = std::max(heat[i], totals.heat);
        elastic = std::max(elastic, totals.elastic);
      }
    }
    const SoftAccounts after = play.accounts();
    const Vec21 lacks = after.motion - before.motion - after.givenByStrokes;
    EXPECT_NEAR(lacks.t, 0.0, 1e-12 * before.motion.t);
    EXPECT_NEAR(lacks.x + after.taken.x, 0.0, 1e-12 * before.motion.t);
    EXPECT_NEAR(lacks.y + after.taken.y, 0.0, 1e-12 * before.motion.t);
    EXPECT_NEAR(after.givenByStrokes.x, stroke.momentum.x, 1e-14);
    EXPECT_NEAR(after.givenByStrokes.y, stroke.momentum.y, 1e-14);
    EXPECT_TRUE(play.frozen().empty());
    EXPECT_FALSE(play.collisions().empty());
    glm::dvec2 byCushions(0.0);
    for (const SoftCollision& one : play.collisions()) {
      if (one.cushion != SoftExchange::kNone) byCushions += one.impulse;
    }
    EXPECT_NEAR(byCushions.x + after.taken.x, 0.0, 1e-13);
    EXPECT_NEAR(byCushions.y + after.taken.y, 0.0, 1e-13);
    EXPECT_GT(after.heat, 0.0);
    EXPECT_GT(elastic, 0.0);
  }
}

/// A play with everything in it, its bodies added in an order.
SoftPlay crowded(const std::vector<int>& order) {
  SoftPlay play({{{1.0, 0.0}, 0.15}});
  std::size_t struck = 0;
  for (const int i : order) {
    if (i == 1) struck = play.size();
    play.add(disc(std::string(1, static_cast<char>('a' + i)), 4, {-0.07 + 0.075 * i, 0.01 * i},
                  {0.5 - 0.3 * i, 0.0}));
  }
  SoftStroke stroke;
  stroke.body = struck;
  stroke.hand = {0.1, 0.0, 0.1};
  stroke.hasPlace = true;
  stroke.height = 0.05;
  stroke.momentum = {0.0, -0.1};
  play.addStroke(stroke);
  return play;
}

SoftBody::State stateOf(const SoftPlay& play, const std::string& name) {
  for (std::size_t k = 0; k < play.size(); ++k) {
    if (play.name(k) == name) return play.body(k).state();
  }
  return {};
}

TEST(SoftPlay, HasTheSameBitsInAnyOrderAndAfterAReturn) {
  SoftPlay one = crowded({0, 1, 2}), other = crowded({2, 0, 1});
  playTo(one, 0.15);
  const auto kept = one.snapshot();
  playTo(one, 0.4);
  const double heat = one.totals(0).heat;
  const std::vector<SoftCollision> collisions(one.collisions().begin(), one.collisions().end());
  one.restore(*kept);
  playTo(one, 0.4);
  EXPECT_EQ(one.totals(0).heat, heat);
  ASSERT_EQ(one.collisions().size(), collisions.size());
  ASSERT_FALSE(collisions.empty());
  for (std::size_t k = 0; k < collisions.size(); ++k) {
    EXPECT_EQ(one.collisions()[k].contact.t, collisions[k].contact.t);
    EXPECT_EQ(one.collisions()[k].heat(), collisions[k].heat());
    EXPECT_EQ(one.collisions()[k].impulse, collisions[k].impulse);
  }
  playTo(other, 0.4);
  for (const char* name : {"a", "b", "c"}) {
    EXPECT_EQ(stateOf(one, name).x, stateOf(other, name).x) << name;
    EXPECT_EQ(stateOf(one, name).e, stateOf(other, name).e) << name;
  }
}

// Bell's string: both ends set off at once and keep their distance on the board; the middle rests until the
// news comes.
TEST(SoftPlay, HoldsTheSidesOfABellString) {
  constexpr double kHalf = 0.04, kSpeed = 0.3, kAt = 0.011;
  SoftPlay play({});
  SoftEntry entry{"string",   std::make_shared<SoftMesh>(softRectangle({kHalf, 0.25 * kHalf}, 20)),
                  {0.5, 0.3}, kMass,
                  {0.0, 0.0}, movingWith({0.0, 0.0}),
                  0.0,        {}};
  for (const bool plus : {false, true}) entry.holds.push_back({plus, {{kAt, {kSpeed, 0.0}}}});
  play.add(entry);
  const SoftMesh& mesh = *entry.mesh;
  const SoftMesh::Inside left = mesh.locate({-kHalf, 0.0}), right = mesh.locate({kHalf, 0.0}),
                         middle = mesh.locate({0.0, 0.0});
  playTo(play, 0.01);
  EXPECT_FALSE(play.isAwake(0));
  playTo(play, 0.04);
  const double moved = kSpeed * (play.time() - kAt);
  EXPECT_NEAR(play.place(0, left).x, -kHalf + moved, 1e-12);
  EXPECT_NEAR(play.place(0, right).x, kHalf + moved, 1e-12);
  EXPECT_NEAR(play.place(0, middle).x, 0.0, 1e-4 * kHalf);
  playTo(play, 2.0);
  EXPECT_NEAR(play.place(0, right).x - play.place(0, left).x, 2.0 * kHalf, 1e-12);
  EXPECT_NEAR(play.velocity(0, middle).x, kSpeed, 0.05);
  const SoftAccounts accounts = play.accounts();
  EXPECT_NEAR(accounts.motion.t - kMass, accounts.givenByHolders.t, 1e-13);
  EXPECT_NEAR(accounts.motion.x, accounts.givenByHolders.x, 1e-13);
}

// A body that cannot be followed goes on in its mean motion, with all of its energy and momentum.
TEST(SoftPlay, FreezesWhatItCannotFollow) {
  SoftPlay play({{{1.0, 0.0}, 0.1}});
  play.add(disc("disc", 4, {0.0, 0.0}, {0.998, 0.0}, {0.7, 0.05}));
  const Vec21 before = play.totals(0).momentum;
  playTo(play, 0.3);
  EXPECT_FALSE(play.frozen().empty());
  EXPECT_NEAR(play.totals(0).momentum.t, before.t, 1e-12 * before.t);
  EXPECT_NEAR(play.totals(0).momentum.x + play.accounts().taken.x, before.x, 1e-12 * before.t);
}

}  // namespace
}  // namespace carom
