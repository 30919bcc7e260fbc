#include "engine/impact/contact_finder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/random_world.h"

namespace carom {
namespace {

constexpr double kRadius_m = 0.05;
constexpr int kCorners = 96;
constexpr double kFastest = 0.3;  // of light: the levers of fast ones are not along the normal
// How far a regular polygon is inside its circle.
const double kSagitta_m = kRadius_m * (1.0 - std::cos(std::numbers::pi / kCorners));

std::vector<Vec2> regularPolygon() {
  std::vector<Vec2> corners;
  for (int k = 0; k < kCorners; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / kCorners;
    corners.push_back(kRadius_m * Vec2{std::cos(angle), std::sin(angle)});
  }
  return corners;
}

Puck puckOf(const char* name, const Vec2& place, const Vec2& beta, bool isPolygon) {
  Puck puck{name, kRadius_m, 0.02, 0.2, place, beta};
  if (isPolygon) puck.outline_m = regularPolygon();
  return puck;
}

BilliardSetup meeting(test::Random& random, bool firstPolygon, bool secondPolygon) {
  BilliardSetup setup;
  setup.lightSpeed_m_s = 1.0;
  setup.board = Board{2.0, 2.0};
  if (random.in(0.0, 1.0) < 0.5) setup.rules.collisionEvent = CollisionEvent::contact;
  const double speed = random.in(0.1, kFastest), offset_m = random.in(-0.8, 0.8) * kRadius_m;
  setup.pucks = {puckOf("a", {-0.3, 0.0}, {speed, 0.0}, firstPolygon),
                 puckOf("b", {0.2, offset_m}, {-random.in(0.0, kFastest), 0.0}, secondPolygon)};
  return setup;
}

TEST(ContactFinder, AsksTheShapesOnce) {
  test::Random random(41);
  const GameState discs(meeting(random, false, false)), mixed(meeting(random, false, true));
  EXPECT_EQ(&contactsOf(discs, 0, 1), &kDiscPair);
  EXPECT_EQ(&contactsOf(mixed, 0, 1), &kPolygonPair);
  EXPECT_EQ(&cushionContactsOf(mixed, 0), &kDiscAtCushion);
  EXPECT_EQ(&cushionContactsOf(mixed, 1), &kPolygonAtCushion);
}

// A regular polygon of many corners meets and kicks as the disc around it does, as far as it is one: two
// implementations that share no line.
TEST(ContactFinder, PolygonsOfManyCornersMeetAsDiscsDo) {
  test::Random random(42);
  int compared = 0;
  for (int i = 0; i < 200; ++i) {
    CASE(random, i);
    const bool both = random.in(0.0, 1.0) < 0.5;
    const BilliardSetup setup = meeting(random, true, both);
    BilliardSetup round = setup;
    for (Puck& puck : round.pucks) puck.outline_m.clear();
    const GameState ofPolygons(setup), ofDiscs(round);
    const PuckPair who{0, 1};
    const auto polygons = kPolygonPair.meetingOf(ofPolygons, who);
    const auto discs = kDiscPair.meetingOf(ofDiscs, who);
    ASSERT_TRUE(polygons && discs);
    // The signal has as far to go from a side as from the rim, but for the sagitta; fast ones show it larger.
    const double near_m = 40.0 * kSagitta_m;
    for (int k = 0; k < 2; ++k) EXPECT_NEAR(polygons->ownTime[k], discs->ownTime[k], near_m);

    GameContact one = kPolygonPair.contactOf(ofPolygons, who, false);
    GameContact other = kDiscPair.contactOf(ofDiscs, who, false);
    EXPECT_FALSE(kPolygonPair.recede(ofPolygons, who, false, one));
    EXPECT_FALSE(kDiscPair.recede(ofDiscs, who, false, other));
    const std::array<Vec21, 2> u{ofDiscs.discs[0].u, ofDiscs.discs[1].u};
    const auto kick = kPolygonPair.kick(ofPolygons, who, one.contact, u, {0.0, 0.0}, 1.0);
    const auto roundKick = kDiscPair.kick(ofDiscs, who, other.contact, u, {0.0, 0.0}, 1.0);
    ASSERT_TRUE(kick && roundKick);
    // A side stands at most half a corner's angle off the rim's normal, and a lever as much as the speed
    // tilts it.
    const double speed = std::max(u[0].x, -u[1].x),
                 near = 2.0 * speed * (std::numbers::pi / kCorners + speed * speed);
    for (int k = 0; k < 2; ++k) {
      EXPECT_NEAR(kick->centres.u[k].x, roundKick->centres.u[k].x, near);
      EXPECT_NEAR(kick->centres.u[k].y, roundKick->centres.u[k].y, near);
    }
    ++compared;
  }
  EXPECT_EQ(compared, 200);
}

TEST(ContactFinder, AtCushionsToo) {
  test::Random random(43);
  for (int i = 0; i < 200; ++i) {
    CASE(random, i);
    BilliardSetup setup = meeting(random, true, false);
    setup.pucks.resize(1);
    setup.pucks[0].beta = {random.in(0.1, kFastest), random.in(-0.1, 0.1)};
    BilliardSetup round = setup;
    round.pucks[0].outline_m.clear();
    const GameState polygon(setup), disc(round);
    const Leg leg = polygon.legOf(0);
    const auto one = kPolygonAtCushion.touchOf(polygon, 0, leg, {}, 0);
    const auto other = kDiscAtCushion.touchOf(disc, 0, leg, {}, 0);
    ASSERT_TRUE(one && other);
    const double near_m = 40.0 * kSagitta_m * leg.u.t / (leg.u.x / leg.u.t);
    EXPECT_NEAR(one->ownTime, other->ownTime, near_m);
    EXPECT_NEAR(one->turn.x.x, other->turn.x.x, near_m);
    const auto kick = kPolygonAtCushion.kick(polygon, 0, 0, one->event, one->turn, 0.0, 1.0);
    const auto roundKick = kDiscAtCushion.kick(disc, 0, 0, other->event, other->turn, 0.0, 1.0);
    ASSERT_TRUE(kick && roundKick);
    EXPECT_NEAR(kick->centre.u.x, roundKick->centre.u.x,
                2.0 * leg.u.x * (std::numbers::pi / kCorners + leg.u.x * leg.u.x));
    EXPECT_LT(kick->centre.u.x, 0.0);
  }
}

// With friction that vanishes the glides become straight flights.
TEST(ContactFinder, DiscsThatTheClothSlowsMeetAlmostAsThoseThatGlideFreely) {
  test::Random random(44);
  for (int i = 0; i < 200; ++i) {
    CASE(random, i);
    const BilliardSetup setup = meeting(random, false, false);
    BilliardSetup slowed = setup;
    slowed.rules.friction_m_s2 = 1e-7;
    const GameState free(setup), braked(slowed);
    const auto one = kDiscPair.meetingOf(free, {0, 1}), other = kDiscPair.meetingOf(braked, {0, 1});
    ASSERT_TRUE(one && other);
    for (int k = 0; k < 2; ++k) EXPECT_NEAR(one->ownTime[k], other->ownTime[k], 1e-4);
    const Vec21 event = kDiscPair.contactOf(free, {0, 1}, false).contact.event;
    const Vec21 slow = kDiscPair.contactOf(braked, {0, 1}, false).contact.event;
    EXPECT_NEAR(event.t, slow.t, 1e-4);
    EXPECT_NEAR(event.x, slow.x, 1e-4);
    EXPECT_NEAR(event.y, slow.y, 1e-4);
  }
}

}  // namespace
}  // namespace carom
