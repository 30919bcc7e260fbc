// The contact of two pucks against a slow reference that shares no formula with it.

#include "engine/puck_contact.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "engine/billiard.h"
#include "engine/kick.h"
#include "reference/pair_reference.h"

namespace carom {
namespace {

constexpr int kPairs = 10000;

class Random {
 public:
  double in(double low, double high) { return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1.0p-53; }

 private:
  std::mt19937_64 engine_{20240607};
};

struct Pair {
  std::array<Disc, 2> discs;
  std::array<double, 2> mass;
  std::array<reference::ReferencePuck, 2> slow;
};

std::ostream& operator<<(std::ostream& out, const Pair& pair) {
  out.precision(17);
  for (int k = 0; k < 2; ++k) {
    const Disc& d = pair.discs[k];
    out << "\npuck " << k << ": X (" << d.start.t << ", " << d.start.x << ", " << d.start.y << ") u (" << d.u.x << ", "
        << d.u.y << ") R " << d.radius << " m " << pair.mass[k];
  }
  return out;
}

// Two pucks of any size, mass and speed up to β = 0.99 that aim roughly at each other, from different board times.
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
    pair.slow[k] = {{disc.start.t, disc.start.x, disc.start.y},
                    static_cast<reference::Real>(disc.u.x) / std::sqrt(1 + static_cast<reference::Real>(disc.u.x) * disc.u.x + static_cast<reference::Real>(disc.u.y) * disc.u.y),
                    static_cast<reference::Real>(disc.u.y) / std::sqrt(1 + static_cast<reference::Real>(disc.u.x) * disc.u.x + static_cast<reference::Real>(disc.u.y) * disc.u.y),
                    disc.radius, pair.mass[k]};
  }
  return pair;
}

double distance(const Vec21& a, const reference::Point& b) {
  return std::max({std::abs(a.t - static_cast<double>(b.t)), std::abs(a.x - static_cast<double>(b.x)),
                   std::abs(a.y - static_cast<double>(b.y))});
}

TEST(PuckContact, agreesWithSlowReference) {
  Random random;
  int hits = 0;
  for (int i = 0; i < kPairs; ++i) {
    const Pair pair = randomPair(random);
    SCOPED_TRACE(testing::Message() << "pair " << i << pair);
    const auto slow = reference::slowContact(pair.slow[0], pair.slow[1]);
    const double relative = std::sqrt(std::pow(dot(pair.discs[0].u, pair.discs[1].u), 2) - 1.0);
    // What rounding of the inputs does to an event far away, at these speeds and where the tubes just graze.
    const double rounding = 1e-15 * 50.0 * dot(pair.discs[0].u, pair.discs[1].u) * pair.discs[0].u.t * pair.discs[1].u.t / std::min(1.0, relative);
    const auto fast = findMeeting(pair.discs[0], pair.discs[1], TurnConvention::newsAtCentre);
    if (!slow) {
      EXPECT_FALSE(fast);
      continue;
    }
    const bool later = slow->turnAtNews[0].t > pair.discs[0].start.t && slow->turnAtNews[1].t > pair.discs[1].start.t;
    const bool inContactAtStart = slow->contact.t < std::max(pair.discs[0].start.t, pair.discs[1].start.t) + 5.0;
    if (inContactAtStart) continue;  // which is another matter
    ASSERT_EQ(static_cast<bool>(fast), later);
    if (!fast) continue;
    ++hits;
    const PairContact contact = contactOf(pair.discs[0], pair.discs[1], false);
    // Distance of the impact from grazing, in terms of which the contact moves by 1/sqrt.
    const double graze = std::sqrt(std::max(1e-12, -dot(contact.n, contact.n))) ;
    (void)graze;
    EXPECT_TRUE(distance(contact.event, slow->contact) <= 1e3 * rounding) << distance(contact.event, slow->contact) << " " << rounding;
    const auto kick = kickPair(contact.U, contact.n, {pair.discs[0].u, pair.discs[1].u}, pair.mass, 1.0);
    ASSERT_TRUE(kick);
    for (int k = 0; k < 2; ++k) {
      const Disc& disc = pair.discs[k];
      EXPECT_TRUE(distance(disc.start + disc.u * contact.news[k], slow->turnAtNews[k]) <= 1e3 * rounding);
      EXPECT_TRUE(distance(disc.start + disc.u * contact.simultaneous[k], slow->turnAtContact[k]) <= 1e3 * rounding);
      EXPECT_TRUE(std::abs(kick->u[k].x / kick->u[k].t - static_cast<double>(slow->after[k][0])) <= 1e3 * rounding) << kick->u[k].x / kick->u[k].t - static_cast<double>(slow->after[k][0]) << " " << rounding;
      EXPECT_TRUE(std::abs(kick->u[k].y / kick->u[k].t - static_cast<double>(slow->after[k][1])) <= 1e3 * rounding);
    }
    if (HasFailure()) return;
  }
  EXPECT_GT(hits, kPairs / 4);
}

}  // namespace
}  // namespace carom
