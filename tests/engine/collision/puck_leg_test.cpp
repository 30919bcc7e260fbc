#include "engine/collision/puck_leg.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/random_world.h"
#include "engine/spacetime/world_line.h"

namespace carom {
namespace {

using test::Random;

constexpr double kLegRounding = 1e-11;  // metres, over legs of some ten metres

Leg randomLeg(Random& random, double brake) {
  const auto in = [&](double low, double high) { return random.in(low, high); };
  return {{in(-1.0, 1.0), in(-1.0, 1.0), in(-1.0, 1.0)},
          fourVelocity(in(-2.0, 2.0), in(-2.0, 2.0)),
          in(0.0, 5.0),
          brake};
}

// The physics' leg and the world line's are one motion.
TEST(PuckLeg, movesAsTheWorldLineDoes) {
  Random random(3);
  const double c = 1.42;
  for (int i = 0; i < 1000; ++i) {
    CASE(random, i);
    const Leg leg = randomLeg(random, i % 2 == 0 ? 0.0 : random.in(0.1, 1.0));
    const Knot knot{{leg.start.t / c, {leg.start.x, leg.start.y, 0.0}},
                    {leg.u.x, leg.u.y, 0.0},
                    leg.properTime / c,
                    {},
                    leg.brake * c * c};
    const double t = leg.start.t + random.in(-1.0, 12.0);
    const LegState moment = momentAt(leg, t);
    const Motion motion = motionOnLeg(knot, t / c, c);
    EXPECT_TRUE(glm::length(motion.event.r_m - Vec3(moment.x.x, moment.x.y, 0.0)) <= kLegRounding);
    EXPECT_TRUE(glm::length(motion.u - Vec3(moment.u.x, moment.u.y, 0.0)) <= kLegRounding);
    EXPECT_TRUE(std::abs(motion.properTime_s * c - moment.properTime) <= kLegRounding);
  }
}

// Each solver's answer, put back into what it was to solve.
// γβ falls by the friction in a unit of board time: a moment before it rests a puck creeps, and it does not
// move after.
TEST(PuckLeg, restsWhenFrictionHasTakenAllOfItsCelerity) {
  for (const double u : {1e-3, 0.75, 10.0}) {
    const Leg leg{{3.0, 0.1, 0.2}, fourVelocity(0.6 * u, 0.8 * u), 0.0, 0.25};
    EXPECT_NEAR(restsAt(leg), 3.0 + u / 0.25, 1e-14 * u);
    const LegState creeps = momentAt(leg, restsAt(leg) - 1e-6), rests = momentAt(leg, restsAt(leg) + 1.0);
    EXPECT_NEAR(creeps.u.x, 0.6 * 0.25e-6, 1e-14);
    EXPECT_EQ(rests.u.t, 1.0);
    EXPECT_NEAR(rests.x.x, creeps.x.x, 1e-12);
  }
}

TEST(PuckLeg, solversSolve) {
  Random random(3);
  for (int i = 0; i < 1000; ++i) {
    CASE(random, i);
    const Leg leg = randomLeg(random, i % 2 == 0 ? 0.0 : random.in(0.1, 1.0));
    const Vec21 event{leg.start.t + random.in(0.0, 3.0), random.in(-1.0, 1.0), random.in(-1.0, 1.0)};
    const double height = random.in(-1.0, 1.0);
    const LegState signal = signalArrives(leg, event, height);
    const double distance = std::hypot(signal.x.x - event.x, signal.x.y - event.y, height);
    EXPECT_TRUE(std::abs(signal.x.t - event.t - distance) <= kLegRounding);
    EXPECT_TRUE(std::abs(momentAt(leg, signal.x.t).x.x - signal.x.x) <= kLegRounding);

    const Vec21 U = fourVelocity(random.in(-1.0, 1.0), random.in(-1.0, 1.0));
    const LegState simultaneous = simultaneousWith(leg, event, U);
    EXPECT_TRUE(std::abs(dot(U, simultaneous.x - event)) <= kLegRounding);
    EXPECT_TRUE(std::abs(momentAt(leg, simultaneous.x.t).x.y - simultaneous.x.y) <= kLegRounding);

    const double bound = leg.start.x + std::copysign(random.in(0.0, 2.0), leg.u.x);
    const double when = reaches(leg, 0, bound);
    if (std::isfinite(when)) {
      EXPECT_TRUE(std::abs(momentAt(leg, when).x.x - bound) <= kLegRounding);
    } else {
      EXPECT_LT(std::abs(momentAt(leg, restsAt(leg)).x.x - leg.start.x), std::abs(bound - leg.start.x));
    }
  }
}

// Light that reaches a puck on a leg that is up to a day old (122 688 m at 1.42 m/s) arrives on the cone, but
// for the rounding of the time itself.
TEST(PuckLeg, signalArrivesOnTheConeAtAnyAge) {
  Random random(3);
  for (int i = 0; i < 1000; ++i) {
    CASE(random, i);
    Leg leg = randomLeg(random, 0.0);
    if (i % 2 == 0) leg.u = {1.0, 0.0, 0.0};
    for (const double age_m : {10.0, 1000.0, 5112.0, 122688.0}) {
      SCOPED_TRACE(testing::Message() << "leg " << i << " after " << age_m << " m of light");
      const LegState there = momentAt(leg, leg.start.t + age_m);
      const Vec21 event{there.x.t, there.x.x + random.in(-1.0, 1.0), there.x.y + random.in(-1.0, 1.0)};
      const double height = random.in(-1.0, 1.0);
      const LegState signal = signalArrives(leg, event, height);
      const double late =
          signal.x.t - event.t - std::hypot(signal.x.x - event.x, signal.x.y - event.y, height);
      EXPECT_TRUE(std::abs(late) <= 16.0 * 0x1p-52 * leg.u.t * leg.u.t * (age_m + 10.0)) << late;
    }
  }
}

// And on the cone at any speed, whether the signal started before or after the leg. If before, the
// event is as exact as its coordinates; if after, the leg was followed to it, which costs γ².
TEST(PuckLeg, signalArrivesOnTheConeAtAnySpeed) {
  Random random(3);
  int early = 0, arrived = 0;
  for (const double gamma : {1.5, 10.0, 22.0, 200.0, 1000.0}) {
    for (int i = 0; i < 4000; ++i) {
      SCOPED_TRACE(testing::Message() << "gamma " << gamma << ", signal " << i);
      const double angle = random.in(0.0, 6.3), u = std::sqrt(gamma * gamma - 1.0);
      const Leg leg{{}, fourVelocity(u * std::cos(angle), u * std::sin(angle)), 0.0, 0.0};
      const Vec21 event{random.in(-0.5, 0.5), random.in(-0.4, 0.4), random.in(-0.4, 0.4)};
      const double height = i % 2 == 0 ? 0.0 : random.in(-0.1, 0.1);
      const LegState signal = signalArrives(leg, event, height);
      if (signal.x.t < 0.0) continue;
      ++arrived, early += dot(leg.u, event) < 0.0;
      const long double x = static_cast<long double>(signal.x.x) - event.x,
                        y = static_cast<long double>(signal.x.y) - event.y;
      const long double late =
          static_cast<long double>(signal.x.t) - event.t - std::sqrt(x * x + y * y + height * height);
      const double rounding = 64.0 * 0x1p-52 * (dot(leg.u, event) < 0.0 ? 1.0 : gamma * gamma);
      EXPECT_TRUE(std::abs(late) <= rounding * (1.0 + std::abs(signal.x.t))) << late;
    }
  }
  EXPECT_GT(early, 2000);
  EXPECT_GT(arrived, 10000);
}

}  // namespace
}  // namespace carom
