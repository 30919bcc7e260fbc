#include "engine/spacetime/world_line.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "engine/base/portable_math.h"
#include "engine/spacetime/catch_up.h"

namespace carom {

namespace {

// Constant proper deceleration a: celerity w falls linearly in board time, w = w0 − a (t − t0), until rest;
// the distance is c² (γ0 − γ)/a and the proper time c (η0 − η)/a, with w = c sinh η  (hyperbolic motion).
Motion glide(Event turn, Vec3 u, double turnProperTime_s, double deceleration_m_s2, double t_s,
             double c_m_s) {
  const double dt_s = t_s - turn.t_s;
  const double gamma0 = gammaFromU(u);
  const double a = deceleration_m_s2 / c_m_s;  // of u, per second
  const double u0 = glm::length(u);
  if (u0 == 0.0) return {{t_s, turn.r_m}, u, turnProperTime_s + dt_s, 0};
  const bool rests = dt_s >= u0 / a;
  const double glide_s = rests ? u0 / a : dt_s;
  const double u1 = rests ? 0.0 : u0 - a * glide_s;
  const double gamma1 = std::sqrt(1.0 + u1 * u1);
  const Vec3 direction = u / u0;
  // γ0 − γ1 = (u0² − u1²)/(γ0 + γ1) and η0 − η1 = asinh((u0² − u1²)/(u0 γ1 + u1 γ0)) do not cancel.
  const double distance_m = c_m_s * glide_s * (u0 + u1) / (gamma0 + gamma1);
  const double rapidityLost = portableAsinh(a * glide_s * (u0 + u1) / (u0 * gamma1 + u1 * gamma0));
  const double properTime_s = rapidityLost / a + (dt_s - glide_s);
  return {{t_s, turn.r_m + direction * distance_m}, direction * u1, turnProperTime_s + properTime_s, 0};
}

// Inertial: r = r0 + β c (t − t0), τ = τ0 + (t − t0)/γ. Inline: only what it needs of the knot is then made.
[[gnu::always_inline]] inline Motion motionFrom(const Knot& knot, double t_s, double c_m_s) {
  const double dt_s = t_s - knot.turn.t_s;
  if (knot.deceleration_m_s2 != 0.0 && !(dt_s <= 0.0))
    return glide(knot.turn, knot.u, knot.properTime_s, knot.deceleration_m_s2, t_s, c_m_s);
  const double gamma0 = gammaFromU(knot.u);
  return {
      {t_s, knot.turn.r_m + knot.u * (c_m_s * dt_s / gamma0)}, knot.u, knot.properTime_s + dt_s / gamma0, 0};
}

}  // namespace

Motion motionOnLeg(const Knot& knot, double t_s, double c_m_s) { return motionFrom(knot, t_s, c_m_s); }

// c = 1, in the rest frame of the turn. In a time T there friction moves the centre by at most a T²/2, and by
// at most β T, and the contraction moves a point's place by at most R (1 − 1/γ) more. With the gap g ≥ 2 R:
// If a g ≤ 0.3, after T = 2 g/0.9 the centre has moved by at most 0.75 g, and γ ≤ 1.21, so the place is at
// most g + 0.75 g + 0.18 R < 2 g away. Else the speed is at least (1 + β)/2, and the gap closes at that less
// β.
double catchUpAtMost_s(const Knot& knot, double gap_m, double radius_m, double c_m_s) {
  const double plain_s = gap_m / (kCatchUpSpeed * c_m_s);
  if (knot.deceleration_m_s2 == 0.0) return plain_s;
  if (knot.deceleration_m_s2 * gap_m <= 0.3 * c_m_s * c_m_s && 2.0 * radius_m <= gap_m) return 2.0 * plain_s;
  const double back = glm::length(betaFromU(knot.u));
  const double speed = std::max(kCatchUpSpeed, 0.5 + 0.5 * back);
  return (gap_m + radius_m) / ((speed - back) * c_m_s);
}

double rimUAfter(const Spin& spin, double own_s) {
  if (spin.slowing_1_s == 0.0 || !(own_s > 0.0)) return spin.rim_u;
  return std::copysign(std::max(std::abs(spin.rim_u) - spin.slowing_1_s * own_s, 0.0), spin.rim_u);
}

double omegaAfter(const Spin& spin, double own_s) {
  const double u = rimUAfter(spin, own_s);
  if (u == spin.rim_u) return spin.omega_rad_s;
  return spin.omega_rad_s * (u / spin.rim_u) * std::sqrt((1.0 + spin.rim_u * spin.rim_u) / (1.0 + u * u));
}

double angleAfter(const Spin& spin, double own_s) {
  double effective_s = own_s;  // in which it would turn as far at its first rate
  if (spin.slowing_1_s > 0.0 && own_s > 0.0 && spin.rim_u != 0.0) {
    const double u0 = std::abs(spin.rim_u), u = std::abs(rimUAfter(spin, own_s));
    const double gamma0 = std::sqrt(1.0 + u0 * u0), gamma = std::sqrt(1.0 + u * u);
    const double slowed_s = std::min(own_s, u0 / spin.slowing_1_s);
    effective_s = slowed_s * (gamma0 / u0) * (u0 + u) / (gamma0 + gamma);
  }
  return std::remainder(spin.angle_rad + spin.omega_rad_s * effective_s, 2.0 * std::numbers::pi);
}

WorldLine::WorldLine(const Knot& first, double c_m_s, double radius_m, double appears_s,
                     std::pmr::memory_resource* memory)
    : c_m_s_(c_m_s),
      radius_m_(radius_m),
      knots_(first, {-std::numeric_limits<double>::infinity(), radius_m, true}, memory),
      appears_s_(appears_s) {}

namespace {

// A displacement as seen from the rest frame of u: its time (of light, in metres) is u·d, and its length
// follows from the interval d² that all frames share.
struct RestFrameSplit {
  double time_m, distance_m;
};

RestFrameSplit inRestFrame(const Vec3& u, const Displacement& d, double c_m_s) {
  const double time_m = gammaFromU(u) * c_m_s * d.dt_s - glm::dot(u, d.dr_m);
  return {time_m, std::sqrt(std::max(0.0, time_m * time_m - interval_m2(d, c_m_s)))};
}

}  // namespace

// c = 1, origin at the turn. A point at x, |x| ≤ ρ, of the old leg's rest frame leaves it at A when the
// signal (t_n, x_n) arrives: t_A = t_n + |x − x_n|, so |t_A| ≤ |t_n + |x_n|| + ρ. Seen from the new leg's
// rest frame, which moves at relative rapidity η, both coordinates of A are at most e^η times the larger of
// the two bounds; from there the point is at most |x_A| + R from its place.
Settling WorldLine::settlingOf(const Knot& next, const Motion& before, double radiusThen_m) const {
  const RestFrameSplit signal = inRestFrame(before.u, next.signal - next.turn, c_m_s_);
  const double reachOld_m = std::abs(signal.time_m + signal.distance_m) + radiusThen_m;
  const double gammaRelative =
      std::max(1.0, gammaFromU(before.u) * gammaFromU(next.u) - glm::dot(before.u, next.u));
  const double expEta = gammaRelative + std::sqrt(gammaRelative * gammaRelative - 1.0);
  const double reach_m = std::max(radius_m_, expEta * reachOld_m);
  const double join_s = reach_m / c_m_s_ + catchUpAtMost_s(next, reach_m + radius_m_, radius_m_, c_m_s_);
  return {join_s, reach_m, true};
}

double WorldLine::noteNext(const Knot& last, const Knot& next) {
  // In the body's rest frame the centre's clock, when it sees the signal made, is at most |x_n|/c ahead of
  // it.
  const Motion then = motionOnLeg(last, next.signal.t_s, c_m_s_);
  const RestFrameSplit signal = inRestFrame(then.u, next.signal - then.event, c_m_s_);
  const double age_s = then.properTime_s - last.properTime_s - signal.distance_m / c_m_s_;
  // A point that has not joined by then would do so by after_s, moving slower than light all the way.
  Settling& settling = knots_.lastSettling();
  const double left_m = c_m_s_ * (settling.after_s - age_s);
  settling.beforeNext = !(left_m > 0.0);
  return left_m > 0.0 ? std::min(settling.reach_m, radius_m_ + left_m) : radius_m_;
}

void WorldLine::append(const Knot& knot) {
  const Knot last = knots_.back();
  const Motion expected = motionOnLeg(last, knot.turn.t_s, c_m_s_);
  const double size_m = glm::length(knot.turn.r_m) + c_m_s_ * std::abs(knot.turn.t_s) + 1.0;
  const bool later = knot.turn.t_s >= last.turn.t_s;
  const bool onLeg = glm::length(knot.turn.r_m - expected.event.r_m) <= 1e-9 * size_m;
  if (!later) throw std::invalid_argument("WorldLine::append: the turn lies before the last one");
  if (!onLeg) throw std::invalid_argument("WorldLine::append: the turn does not lie on the leg it ends");
  const double radiusThen_m = noteNext(last, knot);
  knots_.push_back(knot, settlingOf(knot, expected, radiusThen_m));
}

void WorldLine::settlesAfter(double after_s) {
  Settling& last = knots_.lastSettling();
  if (!(after_s < last.after_s)) return;
  last.after_s = after_s;
  // They join slower than light.
  last.reach_m = std::min(last.reach_m, radius_m_ + c_m_s_ * after_s);
}

void WorldLine::truncateFrom(double t_s) {
  if (forgotten_ && knots_.turn_s(0) >= t_s)
    *this = WorldLine(knots_.origin(), c_m_s_, radius_m_, appears_s_);
  std::size_t kept = knots_.size();
  while (kept > 1 && !(knots_.turn_s(kept - 1) < t_s)) --kept;
  keepFirst(kept);
}

void WorldLine::keepFirst(std::size_t knots) {
  if (knots >= knots_.size()) return;
  knots_.keepFirst(knots);
  knots_.lastSettling().beforeNext = true;
}

std::size_t WorldLine::forgetBefore(double t_s) {
  std::size_t ended = 0;
  while (ended + 1 < knots_.size() && !(knots_.turn_s(ended + 1) > t_s)) ++ended;
  if (ended == 0) return 0;
  knots_.dropFirst(ended);
  forgotten_ = true;
  return ended;
}

std::size_t WorldLine::legAt(double t_s) const {
  std::size_t leg = 0;
  for (std::size_t after = knots_.size(); after - leg > 1;) {
    const std::size_t middle = leg + (after - leg) / 2;
    if (t_s < knots_.turn_s(middle)) {
      after = middle;
    } else {
      leg = middle;
    }
  }
  return leg;
}

Motion WorldLine::at(double t_s) const {
  const std::size_t leg = legAt(t_s);
  Motion motion = motionFrom(knots_[leg], t_s, c_m_s_);
  motion.leg = leg;
  return motion;
}

}  // namespace carom
