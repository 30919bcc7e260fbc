#pragma once
// A puck's leg for those who check the game: made from a knot, in long doubles and by other formulas than the
// engine's, so that what is found is the engine's rounding. The board's plane in 2+1 dimensions, (c t, x, y),
// all in metres, metric (+,−,−); four-velocities are (γ, γβx, γβy).

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "engine/spacetime/world_line.h"

namespace carom::test {

using Real = long double;
constexpr Real kEndless = std::numeric_limits<Real>::infinity();
/// A rounding of the engine's numbers.
constexpr Real kUlp = std::numeric_limits<double>::epsilon();

/// An event or a four-vector.
struct Four {
  Real t = 0, x = 0, y = 0;
};

inline Four operator+(const Four& a, const Four& b) { return {a.t + b.t, a.x + b.x, a.y + b.y}; }
inline Four operator-(const Four& a, const Four& b) { return {a.t - b.t, a.x - b.x, a.y - b.y}; }
inline Four operator*(const Four& a, Real s) { return {a.t * s, a.x * s, a.y * s}; }
inline Real product(const Four& a, const Four& b) { return a.t * b.t - a.x * b.x - a.y * b.y; }
inline Real lengthInPlane(const Four& a) { return std::hypot(a.x, a.y); }

inline Four fourFrom(const Event& e, double c_m_s) { return {Real(e.t_s) * c_m_s, e.r_m.x, e.r_m.y}; }
inline Four velocityFrom(const Vec3& u) {
  return {std::sqrt(1 + Real(u.x) * u.x + Real(u.y) * u.y), u.x, u.y};
}

/// An event in the frame that moves with four-velocity U, its axes by a rotation-free boost.
inline Four inFrame(const Four& U, const Four& a) {
  const Real along = U.x * a.x + U.y * a.y;
  const Real k = along / (1 + U.t) - a.t;
  return {U.t * a.t - along, a.x + k * U.x, a.y + k * U.y};
}
inline Four fromFrame(const Four& U, const Four& a) { return inFrame({U.t, -U.x, -U.y}, a); }

struct CheckedLeg {
  Four start;
  Four u{1, 0, 0};
  Real brake = 0;       ///< proper deceleration over c², 1/m
  Real properTime = 0;  ///< c τ at the start
  Real end = kEndless;  ///< when the next leg begins

  struct LegState {
    Four x, u;
    Real properTime = 0;
  };
  Real restsAt() const { return brake > 0 ? start.t + lengthInPlane(u) / brake : kEndless; }

  /// |u| falls by `brake` a metre of light; the way is (γ0 − γ)/brake, the proper time (η0 − η)/brake.
  LegState at(Real t) const {
    const Real u0 = lengthInPlane(u), dt = t - start.t;
    if (brake == 0 || dt <= 0 || u0 == 0)
      return {{t, start.x + u.x * dt / u.t, start.y + u.y * dt / u.t}, u, properTime + dt / u.t};
    const Real glide = std::min(dt, u0 / brake);
    const Real u1 = std::max(Real(0), u0 - brake * glide), gamma1 = std::sqrt(1 + u1 * u1);
    const Real way = (u.t - gamma1) / brake / u0;
    const Real clock = (std::asinh(u0) - std::asinh(u1)) / brake + (dt - glide);
    return {{t, start.x + u.x * way, start.y + u.y * way},
            {gamma1, u.x * (u1 / u0), u.y * (u1 / u0)},
            properTime + clock};
  }

  /// The board time at which f(moment), which rises along the leg, becomes positive; looked for from `from`
  /// on, both ways.
  template <class Function>
  Real whenRises(Real from, const Function& f) const {
    Real low = from, high = from, step = Real(1e-3);
    for (; f(at(low)) > 0 && step < 1e12L; step *= 2) low -= step;
    for (step = Real(1e-3); !(f(at(high)) > 0) && step < 1e12L; step *= 2) high += step;
    for (int halving = 0; halving < 200; ++halving) {
      const Real middle = (low + high) / 2;
      if (!(middle > low && middle < high)) break;
      (f(at(middle)) > 0 ? high : low) = middle;
    }
    return high;
  }
  /// When the centre is simultaneous with an event in the frame of U.
  Real whenSimultaneous(const Four& U, const Four& event) const {
    if (brake == 0) return start.t + u.t * product(U, event - start) / product(U, u);
    return whenRises(event.t, [&](const LegState& m) { return product(U, m.x - event); });
  }
  /// When light from an event, at the height of the centres, meets the centre.
  Real whenHeard(const Four& event) const {
    if (brake == 0) {
      const Four w = event - start;
      const Real tau = product(u, w);
      return start.t + u.t * (tau + std::sqrt(std::max(Real(0), tau * tau - product(w, w))));
    }
    return whenRises(event.t,
                     [&](const LegState& m) { return m.x.t - event.t - lengthInPlane(m.x - event); });
  }
};

inline CheckedLeg legFrom(Knots knots, std::size_t k, double c_m_s) {
  CheckedLeg leg;
  leg.start = fourFrom(knots[k].turn, c_m_s);
  leg.u = velocityFrom(knots[k].u);
  leg.brake = Real(knots[k].deceleration_m_s2) / (Real(c_m_s) * c_m_s);
  leg.properTime = Real(knots[k].properTime_s) * c_m_s;
  if (k + 1 < knots.size()) leg.end = Real(knots[k + 1].turn.t_s) * c_m_s;
  return leg;
}

/// What roundings of the engine's coordinates there come to, in metres.
inline Real roundingAt(const Four& x) { return 8 * kUlp * (std::abs(x.t) + lengthInPlane(x) + 1); }

}  // namespace carom::test
