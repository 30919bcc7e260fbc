#include "engine/braked_contact.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace carom {

namespace {

// Dpar = dmin says that the event X1(t) lies R1 + R2 from the second centre in the second's momentary rest
// frame: with r = x1 − x2 on the board at t,   S(t) = r² + (u2·r)² − (R1+R2)² = 0.   S > 0 wherever |r| > R1
// + R2.
struct Clearance {
  double value, slope;     // S, dS/dt
  double curvature;        // bound of |d²S/dt²| while |r| grows by less than R1 + R2
  double distance, speed;  // |r|, and a bound of how fast it changes from here on
};

Clearance clearanceAt(const BrakedDisc& first, const BrakedDisc& second, double t) {
  const Moment m1 = momentAt(first.leg, t), m2 = momentAt(second.leg, t);
  const double reach = first.radius + second.radius, a = first.leg.brake;
  const double x = m1.x.x - m2.x.x, y = m1.x.y - m2.x.y;
  const double vx = m1.u.x / m1.u.t - m2.u.x / m2.u.t, vy = m1.u.y / m1.u.t - m2.u.y / m2.u.t;
  const double u1 = std::sqrt(m1.u.x * m1.u.x + m1.u.y * m1.u.y),
               u2 = std::sqrt(m2.u.x * m2.u.x + m2.u.y * m2.u.y);
  const double along = m2.u.x * x + m2.u.y * y;  // u2·r
  const double braking = u2 > 0.0 ? a * along / u2 : 0.0;
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

bool approach(const Disc& first, const Disc& second) {
  // Dpar > 0: with both flights at one board time, −(u1−u2)·D > β'²|U·D|·…, here at X1's own moment.
  const Vec21 D = second.start - first.start, sum = first.u + second.u, difference = first.u - second.u;
  const double q = -dot(difference, difference);
  return -dot(difference, D) + q / (q + 4.0) * dot(sum, D) > 0.0;
}

BrakedMeeting meetingAt(const BrakedDisc& first, const BrakedDisc& second, double t,
                        TurnConvention convention) {
  const Disc flight1 = flightAt(first, t), flight2 = flightAt(second, t);
  const PairContact contact = contactOf(flight1, flight2, false);
  BrakedMeeting found;
  found.touchAt = t;
  const bool delayed = convention == TurnConvention::newsAtCentre;
  for (int k = 0; k < 2; ++k) {
    const BrakedDisc& disc = k == 0 ? first : second;
    const double own = delayed ? contact.news[k] - disc.radius : contact.simultaneous[k];
    found.meeting.ownTime[k] = t + (k == 0 ? flight1 : flight2).u.t * own;
  }
  return found;
}

}  // namespace

Disc flightAt(const BrakedDisc& disc, double t) {
  const Moment m = momentAt(disc.leg, t);
  return {m.x, m.u, disc.radius, 0.0};
}

std::optional<BrakedMeeting> findBrakedMeeting(const BrakedDisc& first, const BrakedDisc& second,
                                               TurnConvention convention) {
  const double reach = first.radius + second.radius;
  const double touching = 1e-13 * reach * reach;
  const double rest = std::max(restsAt(first.leg), restsAt(second.leg));
  double t = std::max(first.leg.start.t, second.leg.start.t);

  if (clearanceAt(first, second, t).value <= touching) {
    const std::optional<Meeting> meeting = findMeeting(flightAt(first, t), flightAt(second, t), convention);
    if (meeting) return BrakedMeeting{*meeting, t};
  }
  while (t < rest) {
    const Clearance s = clearanceAt(first, second, t);
    if (s.speed == 0.0) return std::nullopt;
    if (std::abs(s.value) <= touching && s.slope < 0.0 && approach(flightAt(first, t), flightAt(second, t))) {
      return meetingAt(first, second, t - s.value / s.slope, convention);
    }
    double step = safeStep(s, reach);
    // Past a zero that is no contact, where they recede, by a hair.
    if (std::abs(s.value) <= touching) step = std::max(step, 1e-12 * reach / s.speed);
    t += std::max(step, 4.0 * std::numeric_limits<double>::epsilon() * (t + reach));
  }
  return std::nullopt;
}

}  // namespace carom
