// Friction: the glide itself, and that the search for contacts of slowing pucks misses none and invents none.

#include "engine/braked_contact.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "engine/billiard.h"
#include "engine/gas.h"

namespace carom {
namespace {

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  double in(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1.0p-53;
  }

 private:
  std::mt19937_64 engine_;
};

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

// Dpar − dmin of the flights that touch the world lines at t, by the definitions in puck_contact.h; positive
// also where b > R1 + R2 or they recede.
double gapAt(const BrakedDisc& first, const BrakedDisc& second, double t) {
  const Disc a = flightAt(first, t), b = flightAt(second, t);
  const double gammaRel = dot(a.u, b.u), reach = a.radius + b.radius;
  const double gamma = std::sqrt(0.5 * (gammaRel + 1.0)), gammaBeta = std::sqrt(0.5 * (gammaRel - 1.0));
  const Vec21 U = (a.u + b.u) * (0.5 / gamma), e = (a.u - b.u) * (0.5 / gammaBeta), D = b.start - a.start;
  const double lead = dot(U, D), d = -dot(e, D);
  const Vec21 perp = D - U * lead - e * d;
  const double b2 = -dot(perp, perp), dpar = d + lead * gammaBeta / gamma;
  if (b2 >= reach * reach || dpar <= 0.0) return 1.0;
  return dpar - std::sqrt(reach * reach - b2) / gamma;
}

TEST(BrakedContact, missesNoneAndInventsNone) {
  Random random(31);
  int met = 0, passed = 0;
  for (int i = 0; i < 1000; ++i) {
    const double brake = random.in(0.05, 1.0);
    const BrakedDisc first = randomDisc(random, brake), second = randomDisc(random, brake);
    const double begin = std::max(first.leg.start.t, second.leg.start.t);
    const double end = std::max(restsAt(first.leg), restsAt(second.leg));
    if (!(gapAt(first, second, begin) > 0.0)) continue;
    SCOPED_TRACE(testing::Message() << "pair " << i);
    // The first sign change, on a fine grid; grazes shorter than a step are left out on both sides.
    constexpr int kSteps = 8000;
    double low = begin, slow = -1.0, least = 1.0;
    for (int step = 1; step <= kSteps; ++step) {
      const double t = begin + (end - begin) * step / kSteps;
      const double gap = gapAt(first, second, t);
      least = std::min(least, gap);
      if (gap <= 0.0) {
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
    const auto fast = findBrakedMeeting(first, second, TurnConvention::newsAtCentre);
    if (slow >= 0.0) {
      ASSERT_TRUE(fast) << "missed one at " << slow;
      EXPECT_TRUE(std::abs(fast->touchAt - slow) <= 1e-9) << fast->touchAt - slow;
      ++met;
    } else if (fast) {
      EXPECT_TRUE(std::abs(gapAt(first, second, fast->touchAt)) <= 1e-9)
          << "invented one at " << fast->touchAt;
    } else {
      ++passed;
    }
    if (HasFailure()) return;
  }
  EXPECT_GT(met, 100);
  EXPECT_GT(passed, 200);
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

// A gas that friction and losses bring to rest: all stand still, apart, with everything accounted for.
TEST(BrakedContact, aGasComesToRest) {
  BilliardSetup setup = test::gasSetup(40, 0.1, 1.5, 12);
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

}  // namespace
}  // namespace carom
