// The contact of two pucks against a slow reference that shares no formula with it.

#include "engine/collision/puck_contact.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "engine/billiard/billiard.h"
#include "engine/collision/kick.h"
#include "engine/random_world.h"
#include "reference/pair_reference.h"

namespace carom {
namespace {

constexpr int kPairs = 10000;

using test::Random;

struct Pair {
  std::array<Disc, 2> discs;
  std::array<double, 2> mass;
  std::array<reference::ReferencePuck, 2> slow;
};

std::ostream& operator<<(std::ostream& out, const Pair& pair) {
  out.precision(17);
  for (int k = 0; k < 2; ++k) {
    const Disc& d = pair.discs[k];
    out << "\npuck " << k << ": X (" << d.start.t << ", " << d.start.x << ", " << d.start.y << ") u ("
        << d.u.x << ", " << d.u.y << ") R " << d.radius << " m " << pair.mass[k];
  }
  return out;
}

// Two pucks of any size, mass and speed up to β = 0.99 that aim roughly at each other, from different board
// times.
Pair randomPair(Random& random) {
  Pair pair;
  for (int k = 0; k < 2; ++k) {
    const double angle = random.in(0.0, 2.0 * std::numbers::pi), beta = random.in(0.0, 0.99);
    const double gamma = 1.0 / std::sqrt(1.0 - beta * beta);
    Disc& disc = pair.discs[k];
    disc.radius = random.in(0.1, 1.0);
    disc.u = fourVelocity(gamma * beta * std::cos(angle), gamma * beta * std::sin(angle));
    // Back from a place near the origin at about t = 20, to the board time at which the flight began.
    const double back = random.in(15.0, 20.0);
    disc.start = {20.0 - back, random.in(-1.0, 1.0) - disc.u.x / disc.u.t * back,
                  random.in(-1.0, 1.0) - disc.u.y / disc.u.t * back};
    pair.mass[k] = random.in(0.1, 10.0);
    const reference::Real ux = disc.u.x, uy = disc.u.y, slowGamma = std::sqrt(1 + ux * ux + uy * uy);
    pair.slow[k] = {{disc.start.t, disc.start.x, disc.start.y},
                    ux / slowGamma,
                    uy / slowGamma,
                    disc.radius,
                    pair.mass[k]};
  }
  return pair;
}

double distance(const Vec21& a, const reference::Point& b) {
  return std::max({std::abs(a.t - static_cast<double>(b.t)), std::abs(a.x - static_cast<double>(b.x)),
                   std::abs(a.y - static_cast<double>(b.y))});
}

TEST(PuckContact, agreesWithSlowReference) {
  Random random(20240607);
  int hits = 0;
  for (int i = 0; i < kPairs; ++i) {
    CASE(random, i);
    const Pair pair = randomPair(random);
    SCOPED_TRACE(testing::Message() << "pair " << i << pair);
    const auto slow = reference::slowContact(pair.slow[0], pair.slow[1]);
    // What rounding of the inputs does to an event about 50 m away, at these speeds, and a thousandfold for
    // tubes that just graze.
    const double gammaRel = dot(pair.discs[0].u, pair.discs[1].u);
    const double tolerance = 5e-11 * gammaRel * pair.discs[0].u.t * pair.discs[1].u.t /
                             std::min(1.0, std::sqrt(gammaRel * gammaRel - 1.0));
    const auto fast = findMeeting(pair.discs[0], pair.discs[1], TurnConvention::signalAtCentre);
    if (!slow) {
      EXPECT_FALSE(fast);
      continue;
    }
    // Contacts around the starts of the flights are another matter.
    if (slow->contact.t < std::max(pair.discs[0].start.t, pair.discs[1].start.t) + 5.0) continue;
    ASSERT_TRUE(fast);
    EXPECT_FALSE(fast->withoutDelay);
    ++hits;
    const PairContact contact = contactOf(pair.discs[0], pair.discs[1], false);
    EXPECT_TRUE(distance(contact.event, slow->contact) <= tolerance);
    const auto kick = kickPair(contact.U, contact.n, {pair.discs[0].u, pair.discs[1].u}, pair.mass, 1.0);
    ASSERT_TRUE(kick);
    for (int k = 0; k < 2; ++k) {
      const Disc& disc = pair.discs[k];
      EXPECT_TRUE(distance(disc.start + disc.u * contact.signal[k], slow->turnAtSignal[k]) <= tolerance);
      // Its own moment of the contact is R before the signal, by its own clock.
      const double own = static_cast<double>(slow->turnAtSignal[k].t) - disc.u.t * disc.radius;
      EXPECT_TRUE(std::abs(fast->ownTime[k] - own) <= tolerance) << fast->ownTime[k] - own;
      EXPECT_TRUE(distance(disc.start + disc.u * contact.simultaneous[k], slow->turnAtContact[k]) <=
                  tolerance);
      const reference::Point after{1, slow->after[k][0], slow->after[k][1]};
      EXPECT_TRUE(distance(kick->u[k] * (1.0 / kick->u[k].t), after) <= tolerance);
    }
    if (HasFailure()) return;
  }
  EXPECT_GT(hits, kPairs / 4);
}

// Pucks of nearly one velocity pass each other at the distance that the last digits of their velocities say:
// b is their way apart beside the relative velocity, in the rest frame of either.
TEST(PuckContact, PucksOfNearlyOneVelocityDoNotMeetByRounding) {
  Random random(33);
  int pass = 0;
  for (int i = 0; i < kPairs; ++i) {
    CASE(random, i);
    const double angle = random.in(0.0, 2.0 * std::numbers::pi), size = std::pow(10.0, random.in(-2.0, 1.0));
    const Vec21 u1 = fourVelocity(size * std::cos(angle), size * std::sin(angle));
    const double least = size * std::pow(2.0, random.in(-53.0, -45.0)), way = random.in(0.0, 7.0);
    const Vec21 u2 = fourVelocity(u1.x + least * std::cos(way), u1.y + least * std::sin(way));
    if (u1.x == u2.x && u1.y == u2.y) continue;
    const Disc first{{1.0, 0.0, 0.0}, u1, 0.1, 0.0};
    const Disc second{{1.0, random.in(-0.5, 0.5), random.in(-0.5, 0.5)}, u2, 0.1, 0.0};
    // In the rest frame of the first: the difference of the velocities without their common part, which is
    // exact, along and across u1.
    const double dx = u2.x - u1.x, dy = u2.y - u1.y, gamma = u1.t;
    const double ex = u1.x / size, ey = u1.y / size;
    const double along = (ex * dx + ey * dy) / gamma, across = ex * dy - ey * dx;
    const double alongApart = (ex * second.start.x + ey * second.start.y) * gamma,
                 acrossApart = ex * second.start.y - ey * second.start.x;
    const double b = std::abs(along * acrossApart - across * alongApart) / std::hypot(along, across);
    if (b < 1.0001 * 0.2) continue;
    ++pass;
    for (const auto convention : {TurnConvention::signalAtCentre, TurnConvention::simultaneousWithContact})
      EXPECT_FALSE(findMeeting(first, second, convention)) << b;
  }
  EXPECT_GT(pass, kPairs / 4);
}

// Of flights that both begin at board time 0, contacts after it count and contacts before it do not, even
// where the signal is still on its way to both centres. On the board the discs are apart at 0.
TEST(PuckContact, NothingIsKickedByAContactBeforeBoardTimeZero) {
  Random random(7);
  int before = 0, after = 0;
  for (int i = 0; i < 6000; ++i) {
    CASE(random, i);
    BilliardSetup setup;
    setup.lightSpeed_m_s = 1.0;
    std::array<reference::ReferencePuck, 2> slow;
    for (int k = 0; k < 2; ++k) {
      const double angle = random.in(0.0, 2.0 * std::numbers::pi), beta = random.in(0.5, 0.95);
      const Vec2 way{beta * std::cos(angle), beta * std::sin(angle)};
      const Vec2 place{random.in(-0.12, 0.12), random.in(-0.12, 0.12)};
      setup.pucks.push_back({k == 0 ? "a" : "b", 0.1, 0.02, 1.0, place, way});
      slow[k] = {{0, place.x, place.y}, way.x, way.y, 0.1, 1};
    }
    // The engine's own contact tells which of them are worth the slow search.
    std::array<Disc, 2> discs;
    for (int k = 0; k < 2; ++k) {
      const Vec2 beta = setup.pucks[k].beta, u = beta / std::sqrt(1.0 - glm::dot(beta, beta));
      discs[k] = {
          {0.0, setup.pucks[k].position_m.x, setup.pucks[k].position_m.y}, fourVelocity(u.x, u.y), 0.1, 0.0};
    }
    if (!(std::abs(contactOf(discs[0], discs[1], false).event.t) < 0.1)) continue;
    const auto contact = reference::slowContact(slow[0], slow[1]);
    if (!contact || !(std::abs(contact->contact.t) < 0.1L) || std::abs(contact->contact.t) < 1e-6L) continue;
    if (!(contact->turnAtSignal[0].t > 1e-6L && contact->turnAtSignal[1].t > 1e-6L)) continue;
    std::optional<Billiard> billiard;
    try {
      billiard.emplace(setup);
    } catch (const std::invalid_argument&) {
      continue;  // they overlap on the board
    }
    billiard->advanceTo(1.0);
    SCOPED_TRACE(testing::Message() << "contact at " << contact->contact.t << " s");
    EXPECT_EQ(billiard->events().size(), contact->contact.t > 0 ? 1u : 0u);
    ++(contact->contact.t > 0 ? after : before);
    if (HasFailure()) return;
  }
  EXPECT_GT(before, 5);
  EXPECT_GT(after, 5);
}

// Discs that overlap and approach as the later flight begins are kicked at that moment of the frame of equal
// speeds: here found by boosts of that frame. Where turns wait for light, a moment counts as R before the
// turn on the puck's own clock.
TEST(PuckContact, WithoutDelayEachHasItsOwnMomentInTheFrameOfEqualSpeeds) {
  Random random(8);
  int met = 0;
  for (int i = 0; i < 20000; ++i) {
    CASE(random, i);
    Pair pair = randomPair(random);
    for (Disc& disc : pair.discs)
      disc.start = {random.in(20.0, 20.5), random.in(-0.3, 0.3), random.in(-0.3, 0.3)};
    const Vec21 sum = pair.discs[0].u + pair.discs[1].u;
    const double vx = sum.x / sum.t, vy = sum.y / sum.t;
    std::array<double, 2> moment;  // in the frame
    for (int k = 0; k < 2; ++k) {
      const Vec21& x = pair.discs[k].start;
      moment[k] = static_cast<double>(reference::boosted({x.t, x.x, x.y}, vx, vy).t);
    }
    const double later = std::max(moment[0], moment[1]);
    for (const auto convention : {TurnConvention::signalAtCentre, TurnConvention::simultaneousWithContact}) {
      const auto found = findMeeting(pair.discs[0], pair.discs[1], convention);
      if (!found || !found->withoutDelay) continue;
      ++met;
      for (int k = 0; k < 2; ++k) {
        const Disc& disc = pair.discs[k];
        const Vec21 next = disc.start + disc.u;  // a metre of own time later
        const double rate =
            static_cast<double>(reference::boosted({next.t, next.x, next.y}, vx, vy).t) - moment[k];
        const double own = (later - moment[k]) / rate;
        const double early = convention == TurnConvention::signalAtCentre ? disc.radius : 0.0;
        EXPECT_NEAR(found->ownTime[k], disc.start.t + disc.u.t * (own - early), 1e-10 * disc.u.t)
            << "puck " << k;
      }
    }
    if (HasFailure()) return;
  }
  EXPECT_GT(met, 2000);
}

}  // namespace
}  // namespace carom
