// Friction: the glide itself, and that the search for contacts of slowing pucks misses none and invents none.

#include "engine/collision/braked_contact.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "engine/billiard/billiard.h"
#include "engine/gas.h"
#include "engine/random_world.h"

namespace carom {
namespace {

using test::Random;

BrakedDisc randomDisc(Random& random, double brake) {
  const double beta = random.in(0.0, 0.97), angle = random.in(0.0, 2.0 * std::numbers::pi);
  const double u = beta / std::sqrt(1.0 - beta * beta);
  BrakedDisc disc;
  disc.radius = random.in(0.2, 0.8);
  disc.leg.u = fourVelocity(u * std::cos(angle), u * std::sin(angle));
  disc.leg.brake = brake;
  // Aimed at the neighbourhood of the origin, from where it may or may not get there.
  const double away = random.in(1.0, 3.0);
  disc.leg.start = {random.in(0.0, 1.0), random.in(-0.4, 0.4) - away * std::cos(angle),
                    random.in(-0.4, 0.4) - away * std::sin(angle)};
  return disc;
}

// Dpar − dmin of two flights, at the event at which the first begins, by the definitions in puck_contact.h;
// positive also where b > R1 + R2 or they recede.
double gapOf(const Disc& a, const Disc& b) {
  const double gammaRel = dot(a.u, b.u), reach = a.radius + b.radius;
  const double gamma = std::sqrt(0.5 * (gammaRel + 1.0)), gammaBeta = std::sqrt(0.5 * (gammaRel - 1.0));
  const Vec21 U = (a.u + b.u) * (0.5 / gamma), e = (a.u - b.u) * (0.5 / gammaBeta), D = b.start - a.start;
  const double lead = dot(U, D), d = -dot(e, D);
  const Vec21 perp = D - U * lead - e * d;
  const double b2 = -dot(perp, perp), dpar = d + lead * gammaBeta / gamma;
  if (b2 >= reach * reach || dpar <= 0.0) return 1.0;
  return dpar - std::sqrt(reach * reach - b2) / gamma;
}

// The same of the flights that touch the world lines at t.
double gapAt(const BrakedDisc& first, const BrakedDisc& second, double t) {
  return gapOf(flightAt(first, t), flightAt(second, t));
}

// The later of the two starts in the equal-speed frame: each disc's flight at its own moment, one of them its
// start. By halving.
std::array<Disc, 2> atLaterStart(const BrakedDisc& first, const BrakedDisc& second) {
  const auto lead = [](const Disc& a, const Disc& b) { return dot(a.u + b.u, b.start - a.start); };
  std::array<Disc, 2> at{flightAt(first, first.leg.start.t), flightAt(second, second.leg.start.t)};
  const int waits = lead(at[0], at[1]) > 0.0 ? 0 : 1;  // whose start is the earlier
  const BrakedDisc& moving = waits == 0 ? first : second;
  double low = moving.leg.start.t, high = low + 100.0;
  for (int k = 0; k < 100; ++k) {
    at[waits] = flightAt(moving, 0.5 * (low + high));
    const bool before = (waits == 0 ? 1.0 : -1.0) * lead(at[0], at[1]) > 0.0;
    (before ? low : high) = at[waits].start.t;
  }
  return at;
}

// A pair that is in contact at the later start is kicked there, or its turns wait for signal that comes after
// both starts.
void expectKickedAtLaterStart(const BrakedDisc& first, const BrakedDisc& second, const BrakedMeeting& found) {
  const std::array<Disc, 2> moment = atLaterStart(first, second);
  const std::array<Disc, 2> flight{flightAt(first, found.touchAt[0]), flightAt(second, found.touchAt[1])};
  const PairContact contact = contactOf(flight[0], flight[1], found.meeting.withoutDelay);
  for (int k = 0; k < 2; ++k) {
    const Leg& leg = (k == 0 ? first : second).leg;
    const double t = found.touchAt[k] + flight[k].u.t * contact.simultaneous[k];
    if (found.meeting.withoutDelay) {
      EXPECT_TRUE(std::abs(t - moment[k].start.t) <= 1e-9)
          << "puck " << k << ": " << t << ", but the later start is at " << moment[k].start.t;
    } else {
      EXPECT_TRUE(found.touchAt[k] + flight[k].u.t * contact.signal[k] >= leg.start.t - 1e-9) << "puck " << k;
    }
  }
}

TEST(BrakedContact, missesNoneAndInventsNone) {
  Random random(31);
  int met = 0, passed = 0, inContact = 0;
  for (int i = 0; i < 1000; ++i) {
    CASE(random, i);
    const double brake = random.in(0.05, 1.0);
    const BrakedDisc first = randomDisc(random, brake), second = randomDisc(random, brake);
    const double begin = std::max(first.leg.start.t, second.leg.start.t);
    const double end = std::max(restsAt(first.leg), restsAt(second.leg));
    const auto fast = findBrakedMeeting(first, second, TurnConvention::signalAtCentre);
    const std::array<Disc, 2> start = atLaterStart(first, second);
    if (!(gapOf(start[0], start[1]) > 0.0)) {
      // Where friction changes much within a puck, "in contact" depends on which flights are meant.
      if (brake * (first.radius + second.radius) > 0.2) continue;
      ASSERT_TRUE(fast) << "missed one in contact";
      expectKickedAtLaterStart(first, second, *fast);
      ++inContact;
      if (HasFailure()) return;
      continue;
    }
    if (!(gapAt(first, second, begin) > 0.0)) continue;
    // The first sign change, on a fine grid; grazes shorter than a step are left out on both sides.
    constexpr int kSteps = 8000;
    double low = begin, slow = -1.0;
    for (int step = 1; step <= kSteps; ++step) {
      const double t = begin + (end - begin) * step / kSteps;
      if (gapAt(first, second, t) <= 0.0) {
        double high = t;
        for (int k = 0; k < 100; ++k) {
          const double middle = 0.5 * (low + high);
          (gapAt(first, second, middle) > 0.0 ? low : high) = middle;
        }
        slow = high;
        break;
      }
      low = t;
    }
    if (slow >= 0.0) {
      ASSERT_TRUE(fast) << "missed one at " << slow;
      EXPECT_TRUE(std::abs(fast->touchAt[0] - slow) <= 1e-9) << fast->touchAt[0] - slow;
      ++met;
    } else if (fast) {
      EXPECT_TRUE(std::abs(gapAt(first, second, fast->touchAt[0])) <= 1e-9)
          << "invented one at " << fast->touchAt[0];
    } else {
      ++passed;
    }
    if (HasFailure()) return;
  }
  EXPECT_GT(met, 100);
  EXPECT_GT(passed, 200);
  EXPECT_GT(inContact, 5);
}

double randomU(Random& random) {
  const double beta = random.in(0.0, 1.0) < 0.3 ? random.in(0.9, 0.999) : random.in(0.0, 0.9);
  return beta / std::sqrt(1.0 - beta * beta);
}

// Times are multiples of 2^-20 m, so that later ones are exact up to a day, and a leg moved in time is the
// same leg to the last bit. What is found is then the same but for the rounding of the time itself.
TEST(BrakedContact, doesNotDependOnTheAgeOfTheGame) {
  Random random(32);
  int met = 0, inContact = 0;
  for (int i = 0; i < 600; ++i) {
    CASE(random, i);
    std::array<BrakedDisc, 2> pair;
    const double brake = std::pow(10.0, random.in(-3.0, 0.0));  // to a pull at which R a = 0.1
    for (int k = 0; k < 2; ++k) {
      const double u = randomU(random), angle = random.in(0.0, 2.0 * std::numbers::pi);
      pair[k].radius = random.in(0.02, 0.1);
      pair[k].leg.brake = brake;
      pair[k].leg.u = fourVelocity(u * std::cos(angle), u * std::sin(angle));
      // One may have rested long before the other is struck.
      const double began = k == 1 && i % 3 == 0 ? 0.0 : random.in(300.0, 302.0);
      const double away = i % 4 == 0 ? random.in(0.0, 0.1) : random.in(0.0, 2.0);
      pair[k].leg.start = {std::ldexp(std::floor(std::ldexp(began, 20)), -20),
                           random.in(-0.1, 0.1) - away * std::cos(angle),
                           random.in(-0.1, 0.1) - away * std::sin(angle)};
    }
    for (const TurnConvention convention :
         {TurnConvention::signalAtCentre, TurnConvention::simultaneousWithContact}) {
      const auto young = findBrakedMeeting(pair[0], pair[1], convention);
      if (young) ++(young->meeting.withoutDelay ? inContact : met);
      for (const double age : {1.0, 10.0, 1000.0, 5112.0, 122688.0}) {  // a day at 1.42 m/s
        std::array<BrakedDisc, 2> moved = pair;
        for (BrakedDisc& disc : moved) disc.leg.start.t += age;
        const auto old = findBrakedMeeting(moved[0], moved[1], convention);
        SCOPED_TRACE(testing::Message() << "pair " << i << " moved by " << age << " m of light");
        ASSERT_EQ(old.has_value(), young.has_value());
        if (!young) continue;
        EXPECT_EQ(old->meeting.withoutDelay, young->meeting.withoutDelay);
        const double rounding = 16.0 * 0x1p-52 * (age + 400.0);
        for (int k = 0; k < 2; ++k) {
          EXPECT_TRUE(std::abs(old->touchAt[k] - age - young->touchAt[k]) <= rounding) << old->touchAt[k];
          EXPECT_TRUE(std::abs(old->meeting.ownTime[k] - age - young->meeting.ownTime[k]) <= rounding)
              << "puck " << k << " at " << old->meeting.ownTime[k];
        }
        if (HasFailure()) return;
      }
    }
  }
  EXPECT_GT(met, 100);
  EXPECT_GT(inContact, 20);
}

// A game: one puck rests, one is struck at it at a board time up to a day.
TEST(BrakedContact, aStrokeMeetsItsPuckAtAnyAge) {
  Random random(33);
  for (int i = 0; i < 20; ++i) {
    CASE(random, i);
    const double u = randomU(random) + 0.5, y_m = random.in(-0.05, 0.05);
    const double friction_m_s2 = std::pow(10.0, random.in(-2.0, -0.5));
    for (const CollisionEvent convention : {CollisionEvent::centre, CollisionEvent::contact}) {
      for (const double at_s : {0.0, 1.0, 10.0, 30.0, 100.0, 300.0, 1000.0, 3600.0, 86400.0}) {
        SCOPED_TRACE(testing::Message() << "stroke " << i << " at " << at_s << " s: u " << u << ", y " << y_m
                                        << ", friction " << friction_m_s2);
        BilliardSetup setup;
        setup.lightSpeed_m_s = 1.42;
        setup.rules.friction_m_s2 = friction_m_s2;
        setup.rules.collisionEvent = convention;
        setup.pucks = {{"struck", 0.0305, 0.03, 0.2, {-0.3, 0.0}, {0.0, 0.0}},
                       {"resting", 0.0305, 0.03, 0.2, {0.1, y_m}, {0.0, 0.0}}};
        setup.strokes = {{0, at_s, std::nullopt, {0.2 * 1.42 * u, 0.0}}};
        Billiard billiard(setup);
        billiard.advanceTo(at_s + 3.0);
        ASSERT_EQ(billiard.events().size(), 2u);
        EXPECT_EQ(billiard.events()[1].turns.size(), 2u);
      }
    }
  }
}

// Where friction vanishes, whatever begins when, a pair meets as in straight flight: also one that is in
// contact when the later leg begins.
TEST(BrakedContact, vanishingFrictionIsNone) {
  Random random(34);
  int met = 0, inContact = 0, none = 0;
  for (int i = 0; i < 20000; ++i) {
    std::array<BrakedDisc, 2> pair;
    std::array<Disc, 2> straight;
    for (int k = 0; k < 2; ++k) {
      const double u = randomU(random), angle = random.in(0.0, 2.0 * std::numbers::pi);
      pair[k].radius = random.in(0.02, 0.1);
      pair[k].leg.brake = 1e-14;
      pair[k].leg.u = fourVelocity(u * std::cos(angle), u * std::sin(angle));
      const double away = random.in(0.0, 0.5);
      pair[k].leg.start = {random.in(0.1, 0.6), random.in(-0.1, 0.1) - away * std::cos(angle),
                           random.in(-0.1, 0.1) - away * std::sin(angle)};
      straight[k] = {pair[k].leg.start, pair[k].leg.u, pair[k].radius, 0.0};
    }
    for (const TurnConvention convention :
         {TurnConvention::signalAtCentre, TurnConvention::simultaneousWithContact}) {
      SCOPED_TRACE(testing::Message() << "pair " << i);
      const auto expected = findMeeting(straight[0], straight[1], convention);
      const auto found = findBrakedMeeting(pair[0], pair[1], convention);
      ASSERT_EQ(found.has_value(), expected.has_value());
      ++(!expected ? none : expected->withoutDelay ? inContact : met);
      if (!expected) continue;
      ASSERT_EQ(found->meeting.withoutDelay, expected->withoutDelay);
      const std::array<Disc, 2> flight{flightAt(pair[0], found->touchAt[0]),
                                       flightAt(pair[1], found->touchAt[1])};
      const PairContact contact = contactOf(flight[0], flight[1], expected->withoutDelay);
      const PairContact right = contactOf(straight[0], straight[1], expected->withoutDelay);
      EXPECT_TRUE(std::abs(contact.event.t - right.event.t) <= 1e-8);
      EXPECT_TRUE(std::hypot(contact.event.x - right.event.x, contact.event.y - right.event.y) <= 1e-8);
      for (int k = 0; k < 2; ++k) {
        EXPECT_TRUE(std::abs(found->meeting.ownTime[k] - expected->ownTime[k]) <= 1e-8);
      }
      if (HasFailure()) return;
    }
  }
  EXPECT_GT(met, 1000);
  EXPECT_GT(inContact, 300);
  EXPECT_GT(none, 1000);
}

// The deceleration felt by the puck is a: dw/dt = −a for the celerity w; and it rests for good after c u0/a.
TEST(BrakedContact, glideStopsExactly) {
  BilliardSetup setup;
  setup.lightSpeed_m_s = 1.42;
  setup.rules.friction_m_s2 = 0.3;
  setup.pucks = {{"one", 0.03, 0.02, 0.2, {0.0, 0.0}, {0.48, -0.64}}};
  Billiard billiard(setup);
  const double u0 = 0.8 / 0.6, gamma0 = 1.0 / 0.6, c = 1.42, stop_s = u0 * c / 0.3;
  billiard.advanceTo(stop_s + 1.0);
  // By small steps, celerity and proper time summed.
  const int steps = 200000;
  double path_m = 0.0, proper_s = 0.0;
  for (int i = 0; i < steps; ++i) {
    const double t_s = (i + 0.5) * stop_s / steps, u = u0 - 0.3 / c * t_s, gamma = std::sqrt(1.0 + u * u);
    path_m += u / gamma * c * stop_s / steps;
    proper_s += stop_s / steps / gamma;
  }
  const Motion end = billiard.worldLines()[0].at(stop_s + 1.0);
  EXPECT_EQ(end.u, Vec3(0.0));
  EXPECT_TRUE(std::abs(glm::length(end.event.r_m - Vec3(0.0, 0.0, 0.01)) - path_m) <= 1e-9);
  EXPECT_TRUE(std::abs(glm::length(end.event.r_m - Vec3(0.0, 0.0, 0.01)) - c * c * (gamma0 - 1.0) / 0.3) <=
              1e-12);
  EXPECT_TRUE(std::abs(end.properTime_s - proper_s - 1.0) <= 1e-9);
}

// Vanishing friction is no friction.
TEST(BrakedContact, tendsToStraightFlight) {
  for (const CollisionEvent convention : {CollisionEvent::centre, CollisionEvent::contact}) {
    BilliardSetup setup = test::gasSetup(12, 0.1, 1.7, 8);
    setup.rules.collisionEvent = convention;
    Billiard straight(setup);
    setup.rules.friction_m_s2 = 1e-13;
    Billiard braked(setup);
    straight.advanceTo(0.4);
    braked.advanceTo(0.4);
    ASSERT_GE(straight.events().size(), 10u);
    for (std::size_t i = 0; i < 10; ++i) {
      const GameEvent &a = straight.events()[i], &b = braked.events()[i];
      EXPECT_TRUE(std::abs(a.at.t_s - b.at.t_s) <= 1e-8);
      for (std::size_t k = 0; k < a.turns.size(); ++k) {
        EXPECT_EQ(a.turns[k].puck, b.turns[k].puck);
        EXPECT_TRUE(std::abs(a.turns[k].event.t_s - b.turns[k].event.t_s) <= 1e-8);
        EXPECT_TRUE(glm::length(a.turns[k].betaAfter - b.turns[k].betaAfter) <= 1e-6);
      }
    }
  }
}

// Gases that friction and losses bring to rest: all stand still, apart, with everything accounted for.
TEST(BrakedContact, gasesComeToRest) {
  for (std::uint64_t seed = 1; seed <= 16; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    BilliardSetup setup = test::gasSetup(40, 0.1, 1.5, seed);
    setup.rules.friction_m_s2 = 0.1;
    setup.rules.puckRestitution = setup.rules.cushionRestitution = 0.8;
    Billiard billiard(setup);
    const Ledger start = billiard.ledger();
    billiard.advanceTo(30.0);
    EXPECT_GT(billiard.events().size(), 100u);
    for (std::size_t i = 0; i < setup.pucks.size(); ++i) {
      const Motion a = billiard.worldLines()[i].at(30.0);
      EXPECT_EQ(a.u, Vec3(0.0));
      for (std::size_t k = 0; k < i; ++k) {
        EXPECT_GE(glm::length(a.event.r_m - billiard.worldLines()[k].at(30.0).event.r_m), 0.02 - 1e-9)
            << i << " " << k;
      }
    }
    const Ledger end = billiard.ledger();
    const double all = end.motion.energy_j + end.radiated.energy_j + end.takenByCushions.energy_j +
                       end.lostToFriction.energy_j;
    EXPECT_TRUE(std::abs(all / start.motion.energy_j - 1.0) <= 1e-10);
  }
}

}  // namespace
}  // namespace carom
