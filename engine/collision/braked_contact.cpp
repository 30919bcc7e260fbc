#include "engine/collision/braked_contact.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/base/root.h"

namespace carom {

namespace {

constexpr int kManySteps = 24;  // of a search, before it looks closer

// Dpar = dmin says that the event X1(t) lies R1 + R2 from the second centre in the second's momentary rest
// frame: with r = x1 − x2 on the board at t,   S(t) = r² + (u2·r)² − (R1+R2)² = 0.   S > 0 wherever
// |r| > R1 + R2.
struct Clearance {
  double value, slope;     // S, dS/dt
  double curvature;        // bound of |d²S/dt²| while |r| grows by less than R1 + R2
  double distance, speed;  // |r|, and a bound of how fast it changes from here on
};

Clearance clearanceAt(const BrakedDisc& first, const BrakedDisc& second, double t) {
  const LegState m1 = placeAt(first.leg, t), m2 = placeAt(second.leg, t);
  const double reach = first.radius + second.radius, a = first.leg.brake;
  const double x = m1.x.x - m2.x.x, y = m1.x.y - m2.x.y;
  const double vx = m1.u.x / m1.u.t - m2.u.x / m2.u.t, vy = m1.u.y / m1.u.t - m2.u.y / m2.u.t;
  const double u1 = std::sqrt(m1.u.x * m1.u.x + m1.u.y * m1.u.y),
               u2 = std::sqrt(m2.u.x * m2.u.x + m2.u.y * m2.u.y);
  const double along = m2.u.x * x + m2.u.y * y;  // u2·r
  const double braking = u2 > 0.0 && t >= second.leg.start.t ? a * along / u2 : 0.0;
  const double alongSlope = m2.u.x * vx + m2.u.y * vy - braking;

  Clearance s;
  s.distance = std::sqrt(x * x + y * y);
  s.speed = u1 / m1.u.t + u2 / m2.u.t;
  s.value = x * x + y * y + along * along - reach * reach;
  s.slope = 2.0 * (x * vx + y * vy) + 2.0 * along * alongSlope;
  // |β'| <= a and |u'| <= a give |r''| <= 2a, |(u2·r)'| <= u2 B + a|r|, |(u2·r)''| <= 2aB + 2a u2.
  const double B = s.speed, far = s.distance + reach;
  const double first1 = u2 * B + a * far, second1 = 2.0 * a * (B + u2);
  s.curvature = 2.0 * B * B + 4.0 * a * far + 2.0 * first1 * first1 + 2.0 * u2 * far * second1;
  return s;
}

// A step over which S cannot reach 0 (from either side): |S| + s h − M h²/2 > 0 until then.
double safeStep(const Clearance& s, double reach) {
  if (s.distance > 1.5 * reach) return (s.distance - reach) / s.speed;
  const double away = s.value > 0.0 ? s.slope : -s.slope;
  const double step = (away + std::sqrt(away * away + 2.0 * s.curvature * std::abs(s.value))) / s.curvature;
  return std::min(step, reach / s.speed);
}

// The same from a closer look at t, for pairs that lie on each other for long: over at most `most` the
// curvature is bounded by what it is now and by how fast that can change. Before its start and at rest a leg
// does not brake, and no step goes beyond the moment where that changes.
double closeStep(const BrakedDisc& first, const BrakedDisc& second, double t, const Clearance& s,
                 double most) {
  struct {
    double brake = 0.0, x = 0.0, y = 0.0;  // u' = -brake along its way, and β'
  } slows[2];
  const LegState m[2] = {placeAt(first.leg, t), placeAt(second.leg, t)};
  const Leg* const legs[2] = {&first.leg, &second.leg};
  for (int k = 0; k < 2; ++k) {
    const Vec21& u = m[k].u;
    const double speed = std::sqrt(u.x * u.x + u.y * u.y), rests = restsAt(*legs[k]);
    for (const double stop : {legs[k]->start.t, rests}) {
      if (stop > t) most = std::min(most, stop - t);
    }
    if (t < legs[k]->start.t || !(t < rests) || !(speed > 0.0)) continue;
    const double bend = -legs[k]->brake / (speed * u.t * u.t * u.t);
    slows[k] = {legs[k]->brake, bend * u.x, bend * u.y};
  }
  const Vec21 &u1 = m[0].u, &u2 = m[1].u;
  const double x = m[0].x.x - m[1].x.x, y = m[0].x.y - m[1].x.y;
  const double vx = u1.x / u1.t - u2.x / u2.t, vy = u1.y / u1.t - u2.y / u2.t;
  const double speed2 = std::sqrt(u2.x * u2.x + u2.y * u2.y), a1 = slows[0].brake, a2 = slows[1].brake;
  const double along = u2.x * x + u2.y * y, braking = speed2 > 0.0 ? a2 * along / speed2 : 0.0;
  // |r''| <= A and, as |β''| <= 3a², |r'''| <= J.
  const double A = a1 + a2, J = 3.0 * (a1 * a1 + a2 * a2);
  const double V = std::sqrt(vx * vx + vy * vy) + A * most, far = s.distance + V * most;
  const double bent = std::abs(x * (slows[0].x - slows[1].x) + y * (slows[0].y - slows[1].y)) +
                      most * (V * A + far * J);  // |r·r''|
  const double second1 = 2.0 * a2 * V + speed2 * A;
  const double first1 = std::abs(u2.x * vx + u2.y * vy - braking) + most * second1;
  const double curvature =
      2.0 * (V * V + bent + first1 * first1 + (std::abs(along) + most * first1) * second1);
  const double away = s.value > 0.0 ? s.slope : -s.slope;
  const double root = std::sqrt(away * away + 2.0 * curvature * std::abs(s.value));
  if (away > 0.0) return std::min(most, (away + root) / curvature);
  return root > away ? std::min(most, 2.0 * std::abs(s.value) / (root - away)) : 0.0;
}

// How far back from any moment of the search a contact can lie whose signal reaches both centres after it,
// and how far apart in time two events are at most that are simultaneous for the pair when they are near: R γ
// (γ
// + u) of each, with room to spare.
double spanOf(const Disc& first, const Disc& second) {
  const double gamma = first.u.t + second.u.t;
  return 4.0 * (first.radius + second.radius) * gamma * gamma;
}

// The flight that touches a leg at t, from the leg's start on, or from `span` before t.
Disc flightSince(const BrakedDisc& disc, double t, double span) {
  const Leg& leg = disc.leg;
  if (t <= leg.start.t) return {leg.start, leg.u, disc.radius, 0.0};
  const LegState m = placeAt(leg, t);
  const double begin = std::max(leg.start.t, t - span);
  const double s = (begin - t) / m.u.t;
  return {{begin, m.x.x + m.u.x * s, m.x.y + m.u.y * s}, m.u, disc.radius, 0.0};
}

// A pair in contact is kicked at the later of the two starts in its equal-speed frame, U ∝ u1 + u2. The
// flights are those that touch the legs at that moment: there, and where the other leg is simultaneous with
// it.
std::array<double, 2> touchOfPairInContact(const BrakedDisc& first, const BrakedDisc& second) {
  const Leg* const legs[2] = {&first.leg, &second.leg};
  const double lead = dot(first.leg.u + second.leg.u, second.leg.start - first.leg.start);
  const int earlier = lead > 0.0 ? 0 : 1;
  const Leg &leg = *legs[earlier], &later = *legs[1 - earlier];
  std::array<double, 2> touch{first.leg.start.t, second.leg.start.t};
  if (lead == 0.0) return touch;
  const auto late = [&](double t) {  // U·(X(t) − start): rises, as R a < 1/2
    const LegState m = placeAt(leg, t);
    return dot(m.u + later.u, m.x - later.start);
  };
  const double guess = leg.start.t + std::abs(lead) / dot(leg.u + later.u, leg.u) * leg.u.t;
  touch[earlier] = std::max(leg.start.t, rootOfIncreasing(late, guess, 1e-6));
  return touch;
}

// The meeting of the flights that touch the legs at t; of a pair that is in contact as the later leg begins,
// of those at that moment: only they say whether it approaches.
std::optional<BrakedMeeting> meetingAt(const BrakedDisc& first, const BrakedDisc& second, double t,
                                       double span, bool inContact, TurnConvention convention) {
  std::array<double, 2> touch{t, t};
  const auto found = [&] {
    return findMeeting(flightSince(first, touch[0], span), flightSince(second, touch[1], span), convention);
  };
  std::optional<Meeting> meeting = found();
  if (meeting ? meeting->withoutDelay : inContact) {
    touch = touchOfPairInContact(first, second);
    meeting = found();
  }
  if (!meeting) return std::nullopt;
  return BrakedMeeting{*meeting, touch};
}

// The first meeting, of legs whose times are as small as those of the search. It begins before the later
// start, with that leg continued backwards: a contact can be at the other's moment before that and yet come
// after both starts in the equal-speed frame, or its signal in each puck's own.
std::optional<BrakedMeeting> search(const BrakedDisc& first, const BrakedDisc& second, double span,
                                    TurnConvention convention) {
  const double reach = first.radius + second.radius;
  const double rest = std::max(restsAt(first.leg), restsAt(second.leg));
  const double begin = std::max(first.leg.start.t, second.leg.start.t);
  double t = begin - 2.0 * std::sqrt(reach * span);
  Clearance here = clearanceAt(first, second, t);
  for (int steps = 0; t < rest && here.speed > 0.0; ++steps) {
    // S keeps its sign over a safe step. By a hair further, and it may have changed: then a root lies
    // between.
    const double hair = std::max(1e-12 * reach / here.speed,
                                 4.0 * std::numeric_limits<double>::epsilon() * (std::abs(t) + reach));
    double step = safeStep(here, reach);
    if (steps > kManySteps && here.distance < 1.5 * reach) {
      for (const double most : {16.0 * step, reach / here.speed})
        step = std::max(step, closeStep(first, second, t, here, std::min(most, reach / here.speed)));
    }
    double next = t + std::max(step, hair);
    for (const double stop : {second.leg.start.t, begin}) {  // S bends sharply where the second's leg begins
      if (t < stop && stop < next) next = stop;
    }
    const Clearance there = clearanceAt(first, second, next);
    std::optional<BrakedMeeting> meeting;
    if (here.value > 0.0 && there.value <= 0.0) {
      const double root = std::clamp(t - here.value / here.slope, t, next);
      meeting = meetingAt(first, second, root, span, false, convention);
    }
    if (!meeting && next == begin && there.value <= 0.0)
      meeting = meetingAt(first, second, begin, span, true, convention);
    if (meeting) return meeting;
    t = next;
    here = there;
  }
  return std::nullopt;
}

}  // namespace

Disc flightAt(const BrakedDisc& disc, double t) {
  const LegState m = placeAt(disc.leg, t);
  return {m.x, m.u, disc.radius, 0.0};
}

// Times are counted from shortly before the later start, so that the result, and its accuracy, does not
// depend on the age of the game.
std::optional<BrakedMeeting> findBrakedMeeting(const BrakedDisc& first, const BrakedDisc& second,
                                               TurnConvention convention) {
  const double begin = std::max(first.leg.start.t, second.leg.start.t);
  const double span = spanOf(flightAt(first, begin), flightAt(second, begin));
  const double origin = std::max(0.0, begin - span);
  BrakedDisc one = first, two = second;
  one.leg.start.t -= origin;
  two.leg.start.t -= origin;
  std::optional<BrakedMeeting> found = search(one, two, span, convention);
  if (!found) return std::nullopt;
  for (double& own : found->meeting.ownTime) own += origin;
  const double starts[2] = {first.leg.start.t, second.leg.start.t};
  for (int k = 0; k < 2; ++k) {
    double& touch = found->touchAt[k];
    const bool begins = touch == (k == 0 ? one : two).leg.start.t;
    touch = begins ? starts[k] : touch + origin;
    // A moment simultaneous with the later start must not come after it by rounding.
    const double hair = 8.0 * std::numeric_limits<double>::epsilon() * begin;
    if (found->meeting.withoutDelay && !begins) touch = std::max(starts[k], touch - hair);
  }
  return found;
}

}  // namespace carom
