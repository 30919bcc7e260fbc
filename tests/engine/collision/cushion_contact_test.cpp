#include "engine/collision/cushion_contact.h"

#include <cmath>
#include <numbers>
#include <optional>

#include <gtest/gtest.h>

#include "engine/random_world.h"

namespace carom {
namespace {

constexpr double kRounding = 1e-8;  // metres; distances are least values, flat to the root of the rounding

/// Distance of the cushion in the puck's rest frame at the centre's event `at`: the least length of
/// displacements to the plane that the puck calls simultaneous, sought among them; negative beyond the plane.
double distanceInRestFrame(const LegState& at, const CushionPlane& cushion) {
  const double y = cushion.inside(at.x);
  const auto length = [&](double along) {
    Vec21 D = cushion.axis == 0 ? Vec21{0.0, cushion.sign * y, along} : Vec21{0.0, along, cushion.sign * y};
    D.t = (D.x * at.u.x + D.y * at.u.y) / at.u.t;  // D·u = 0
    return std::sqrt(-dot(D, D));
  };
  double low = -100.0, high = 100.0;
  for (int step = 0; step < 200; ++step) {
    const double left = low + 0.382 * (high - low), right = low + 0.618 * (high - low);
    (length(left) < length(right) ? high : low) = length(left) < length(right) ? right : left;
  }
  return std::copysign(length(0.5 * (low + high)), y);
}

/// How far the contracted disc reaches towards the cushion on the board, by going round its rim.
double reachOnBoard(const Vec21& u, double radius, const CushionPlane& cushion) {
  double most = 0.0;
  for (int step = 0; step < 4000; ++step) {
    const double angle = 2.0 * std::numbers::pi * step / 4000.0;
    const double x = radius * std::cos(angle), y = radius * std::sin(angle);
    const double shrink =
        (u.x * x + u.y * y) / (u.t * (u.t + 1.0));  // L(v)⁻¹ on the board: d − u (u·d)/(γ(γ+1))
    const Vec21 rim{0.0, x - u.x * shrink, y - u.y * shrink};
    most = std::max(most, cushion.towards(rim));
  }
  return most;
}

struct Approach {
  Leg leg;
  double radius = 0.0;
  CushionPlane cushion;
};

Approach randomApproach(test::Random& random, bool brakes) {
  Approach a;
  const double speed = random.in(0.1, 2.0), angle = random.in(-1.4, 1.4);
  a.cushion = {random.in(0.0, 1.0) < 0.5 ? 0 : 1, random.in(0.0, 1.0) < 0.5 ? 1.0 : -1.0,
               random.in(0.5, 1.0)};
  const double towards = a.cushion.sign * speed * std::cos(angle), beside = speed * std::sin(angle);
  a.leg.u = a.cushion.axis == 0 ? fourVelocity(towards, beside) : fourVelocity(beside, towards);
  a.leg.start = {random.in(-3.0, 3.0), random.in(-0.1, 0.1), random.in(-0.1, 0.1)};
  a.leg.properTime = random.in(0.0, 2.0);
  a.leg.brake = brakes ? random.in(0.05, 0.8) : 0.0;
  a.radius = random.in(0.02, 0.1);
  return a;
}

/// The first board time at which gap(moment) is no more above 0; none up to where friction stops the puck.
template <class Gap>
std::optional<double> firstTime(const Leg& leg, const Gap& gap) {
  const double begin = leg.start.t, end = std::min(restsAt(leg), begin + 100.0);
  double low = begin;
  for (int step = 1; step <= 400; ++step) {
    double high = begin + (end - begin) * step / 400.0;
    if (gap(momentAt(leg, high)) > 0.0) {
      low = high;
      continue;
    }
    for (int halving = 0; halving < 60; ++halving) {
      const double middle = 0.5 * (low + high);
      (gap(momentAt(leg, middle)) > 0.0 ? low : high) = middle;
    }
    return high;
  }
  return std::nullopt;
}

TEST(CushionContact, IsFirstInThePucksRestFrameAndTurnsWhenTheNewsIsThere) {
  test::Random random(1);
  int met = 0, rested = 0;
  for (int i = 0; i < 300; ++i) {
    CASE(random, i);
    const auto [leg, radius, cushion] = randomApproach(random, i % 2 == 0);
    const auto found = findContact(leg, radius, cushion, TurnConvention::signalAtCentre);
    const auto t =
        firstTime(leg, [&](const LegState& m) { return distanceInRestFrame(m, cushion) - radius; });
    ASSERT_EQ(found.has_value(), t.has_value());
    if (!found) {
      ++rested;
      continue;
    }
    ++met;
    ASSERT_FALSE(found->withoutDelay);
    EXPECT_NEAR(found->ownTime, *t, kRounding * 10.0);
    // C is on the cushion, simultaneous with the centre in its rest frame and a radius from it.
    const LegState own = momentAt(leg, found->ownTime);
    const Vec21 D = found->event - own.x;
    EXPECT_NEAR(cushion.inside(found->event), 0.0, kRounding);
    EXPECT_NEAR(dot(D, own.u), 0.0, kRounding);
    EXPECT_NEAR(dot(D, D), -radius * radius, kRounding);
    // The centre turns where the light from C meets it.
    const Vec21 light = found->turn.x - found->event;
    EXPECT_NEAR(dot(light, light), 0.0, kRounding);
    EXPECT_GT(light.t, 0.0);
    const LegState turn = momentAt(leg, found->turn.x.t);
    EXPECT_NEAR(std::hypot(turn.x.x - found->turn.x.x, turn.x.y - found->turn.x.y), 0.0, kRounding);
    EXPECT_GT(cushion.inside(found->turn.x), 0.0);
  }
  EXPECT_TRUE(met > 200 && rested > 10) << met << " met, " << rested << " rested";
}

TEST(CushionContact, OnTheBoardItIsTheContractedRims) {
  test::Random random(2);
  for (int i = 0; i < 100; ++i) {
    CASE(random, i);
    const auto [leg, radius, cushion] = randomApproach(random, false);
    const auto found = findContact(leg, radius, cushion, TurnConvention::simultaneousWithContact);
    ASSERT_TRUE(found);
    const double reach = reachOnBoard(leg.u, radius, cushion);
    const LegState own = momentAt(leg, found->ownTime);
    EXPECT_NEAR(cushion.inside(own.x), reach, 1e-6 * radius) << "the rim in steps of 2π/4000";
    EXPECT_NEAR(found->event.t, found->ownTime, kRounding);
    EXPECT_NEAR(cushion.inside(found->event), 0.0, kRounding);
    EXPECT_EQ(found->turn.x.t, found->ownTime);
    // C is on the rim: in the rest frame a radius away.
    const Vec21 D = found->event - own.x;
    const double alongU = dot(D, own.u);
    EXPECT_NEAR(alongU * alongU - dot(D, D), radius * radius, kRounding);
  }
}

TEST(CushionContact, ThereIsNoneForWhoGoesAway) {
  const CushionPlane right{0, 1.0, 1.0};
  for (const TurnConvention convention :
       {TurnConvention::signalAtCentre, TurnConvention::simultaneousWithContact}) {
    EXPECT_FALSE(findContact({{}, fourVelocity(-0.5, 0.1)}, 0.05, right, convention));
    EXPECT_FALSE(findContact({{}, fourVelocity(0.0, 1.0)}, 0.05, right, convention));
    const auto pressed = findContact({{2.0, 0.999, 0.0}, fourVelocity(0.5, 0.0)}, 0.05, right, convention);
    ASSERT_TRUE(pressed);
    EXPECT_TRUE(pressed->withoutDelay);
    EXPECT_EQ(pressed->turn.x.t, 2.0);
  }
}

// A disc that begins a leg where it would turn, as one does that a cushion and a heavy disc squeeze: on which
// side of that place rounding puts it decides nothing, along x as along y.
TEST(CushionContact, RoundingDoesNotDecideWhetherTheSignalIsThere) {
  constexpr double kRadius = 0.03, kTowards = 0.75;
  const double atTurn = kRadius / (std::sqrt(1.0 + kTowards * kTowards) + kTowards);
  for (const int axis : {0, 1}) {
    for (const double beyond : {-1e-13, 0.0, 1e-13, 1e-6}) {
      const double place = 1.0 - atTurn * (1.0 + beyond);
      const Leg leg{axis == 0 ? Vec21{0.0, place, 0.2} : Vec21{0.0, 0.2, place},
                    axis == 0 ? fourVelocity(kTowards, 0.3) : fourVelocity(0.3, kTowards)};
      const auto contact = findContact(leg, kRadius, {axis, 1.0, 1.0}, TurnConvention::signalAtCentre);
      ASSERT_TRUE(contact);
      EXPECT_EQ(contact->withoutDelay, beyond < 1e-9) << axis << ' ' << beyond;
    }
  }
}

}  // namespace
}  // namespace carom
