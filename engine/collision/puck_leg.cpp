#include "engine/collision/puck_leg.h"

#include <algorithm>
#include <cmath>

#include "engine/base/never.h"
#include "engine/base/portable_math.h"

namespace carom {

namespace {

// The root of an increasing f on [low, high], f(low) <= 0: Newton's step where it stays inside the bracket,
// halving where it does not. `f` gives value and slope.
template <class Function>
double increasingRoot(double low, double high, Function f) {
  double t = low;
  for (int step = 0; step < 200; ++step) {
    const auto [value, slope] = f(t);
    if (value <= 0.0) {
      low = t;
    } else {
      high = t;
    }
    double next = t - value / slope;
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    if (next == t || next <= low || next >= high) return t;
    t = next;
  }
  return t;
}

// Inertial: X = X0 + u s with s = (t − t0)/γ. With friction u falls linearly in board time, |u| = u0 − a (t −
// t0) until rest, the path is (γ0 − γ)/a and the proper time (asinh u0 − asinh u)/a  (hyperbolic motion, c =
// 1).
LegState momentOf(const Leg& leg, double t, bool clock) {
  const double dt = t - leg.start.t;
  if (leg.brake == 0.0 || dt <= 0.0) {
    const double s = dt / leg.u.t;
    return {{t, leg.start.x + leg.u.x * s, leg.start.y + leg.u.y * s}, leg.u, leg.properTime + s};
  }
  const double u0 = std::sqrt(leg.u.x * leg.u.x + leg.u.y * leg.u.y);
  if (u0 == 0.0) return {{t, leg.start.x, leg.start.y}, leg.u, leg.properTime + dt};
  const double glide = std::min(dt, u0 / leg.brake);
  const double u1 = dt >= u0 / leg.brake ? 0.0 : u0 - leg.brake * glide;
  const double gamma1 = std::sqrt(1.0 + u1 * u1);
  // γ0 − γ1 = (u0² − u1²)/(γ0 + γ1) does not cancel.
  const double path = glide * (u0 + u1) / (leg.u.t + gamma1);
  const double along = path / u0;
  LegState moment{{t, leg.start.x + leg.u.x * along, leg.start.y + leg.u.y * along},
                  {gamma1, leg.u.x * (u1 / u0), leg.u.y * (u1 / u0)},
                  leg.properTime};
  if (!clock) return moment;
  // asinh u0 − asinh u1 = asinh(u0 γ1 − u1 γ0), and u0 γ1 − u1 γ0 = (u0² − u1²)/(u0 γ1 + u1 γ0).
  const double rapidity = portableAsinh(leg.brake * glide * (u0 + u1) / (u0 * gamma1 + u1 * leg.u.t));
  moment.properTime = leg.properTime + rapidity / leg.brake + (dt - glide);
  return moment;
}

}  // namespace

LegState momentAt(const Leg& leg, double t) { return momentOf(leg, t, true); }

LegState placeAt(const Leg& leg, double t) { return momentOf(leg, t, false); }

LegState momentAfter(const Leg& leg, double s) { return {leg.start + leg.u * s, leg.u, leg.properTime + s}; }

double restsAt(const Leg& leg) {
  if (leg.brake == 0.0) return kNever;
  return leg.start.t + std::sqrt(leg.u.x * leg.u.x + leg.u.y * leg.u.y) / leg.brake;
}

// Inertial: with w = signal − X0, τ = u·w and ρ = sqrt(τ² − w·w + h²), the distance in the rest frame, the
// cone is met s = τ + ρ after the start. τ² − w·w cancels on a leg that is old: it is −q·q, q = w − τu. Where
// τ < 0 the sum τ + ρ and −q·q cancel, at high γ by far: there s = (h² − w·w)/(ρ − τ), and ρ² is a sum. With
// friction f(t) = (t − t_signal) − |x(t) − x_signal| rises strictly.
LegState signalArrives(const Leg& leg, const Vec21& signal, double height) {
  const Vec21 w = signal - leg.start;
  if (leg.brake == 0.0) {
    const double tau = dot(leg.u, w), height2 = height * height;
    if (tau < 0.0) {
      const double apart = height2 - dot(w, w);
      return momentAfter(leg, apart / (std::sqrt(std::max(0.0, tau * tau + apart)) - tau));
    }
    const Vec21 q = w - leg.u * tau;
    return momentAfter(leg, tau + std::sqrt(std::max(0.0, height2 - dot(q, q))));
  }
  const auto late = [&](double t) {
    const LegState m = placeAt(leg, t);
    const double dx = m.x.x - signal.x, dy = m.x.y - signal.y;
    const double distance = std::sqrt(dx * dx + dy * dy + height * height);
    const double recession = distance > 0.0 ? (dx * m.u.x + dy * m.u.y) / (distance * m.u.t) : 0.0;
    return std::pair{t - signal.t - distance, 1.0 - recession};
  };
  double high = std::max(signal.t, leg.start.t) + 1e-3;
  for (double step = 1e-3; late(high).first <= 0.0; step *= 2.0) high += step;
  return momentAt(leg, increasingRoot(signal.t, high, late));
}

// U·(X(t) − event) = 0; inertial: s = U·(event − X0)/(U·u).
LegState simultaneousWith(const Leg& leg, const Vec21& event, const Vec21& U) {
  if (leg.brake == 0.0) return momentAfter(leg, dot(U, event - leg.start) / dot(U, leg.u));
  const auto late = [&](double t) {
    const LegState m = placeAt(leg, t);
    return std::pair{dot(U, m.x - event), dot(U, m.u) / m.u.t};
  };
  double low = event.t, high = event.t;
  for (double step = 1e-3; late(low).first > 0.0; step *= 2.0) low -= step;
  for (double step = 1e-3; late(high).first <= 0.0; step *= 2.0) high += step;
  return momentAt(leg, increasingRoot(low, high, late));
}

double reaches(const Leg& leg, int axis, double bound) {
  const double u = axis == 0 ? leg.u.x : leg.u.y;
  const double from = axis == 0 ? leg.start.x : leg.start.y;
  if (u == 0.0) return kNever;
  const double s = std::max(0.0, (bound - from) / u);
  if (leg.brake == 0.0) return leg.start.t + leg.u.t * s;
  // path = s u0 = (γ0 − γ1)/a, so γ1 = γ0 − a u0 s.
  const double u0 = std::sqrt(leg.u.x * leg.u.x + leg.u.y * leg.u.y);
  const double gamma1 = leg.u.t - leg.brake * u0 * s;
  if (!(gamma1 > 1.0)) return kNever;
  return leg.start.t + (u0 - std::sqrt(gamma1 * gamma1 - 1.0)) / leg.brake;
}

}  // namespace carom
