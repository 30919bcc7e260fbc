#pragma once
// The knots that make up world lines: each is the beginning of a leg of motion.

#include "engine/spacetime/event.h"

namespace carom {

/// How a body turns about its own z, in the rest frame of its centre; anticlockwise seen from above.
///
/// Where the cloth slows it, its rim's celerity u (γβ) falls linearly in the centre's own time, |u| = |u0| −
/// ν τ until it is 0, and so do the angular momentum and u's share of c/R in the angle: with Γ = sqrt(1 +
/// u²),
///     φ = φ0 + (c/R) (Γ0 − Γ)/ν = φ0 + ω0 (Γ0/u0) τ (u0 + u)/(Γ0 + Γ),      ω = (c/R) u/Γ
struct Spin {
  double angle_rad = 0.0;    ///< at the turn with which the leg begins, in that leg's axes
  double omega_rad_s = 0.0;  ///< there, by the centre's own clock
  double rim_u = 0.0;        ///< γβ of the rim there, with the sign of ω; needed where the cloth slows it
  double slowing_1_s = 0.0;  ///< ν; 0: it turns uniformly

  bool operator==(const Spin&) const = default;
};

/// The beginning of a leg of motion. Board frame.
struct Knot {
  Event turn;                      ///< the centre's event from which the leg's motion holds
  Vec3 u{0.0};                     ///< γβ at the turn
  double properTime_s = 0.0;       ///< the centre's own clock at the turn
  Event signal;                    ///< the event whose signal, at light speed, makes the body's points turn
  double deceleration_m_s2 = 0.0;  ///< constant proper deceleration from here until rest (friction)
  Spin spin{};
};

/// Returns whether a body has ever turned by the leg of this knot.
inline bool spins(const Knot& knot) { return knot.spin.omega_rad_s != 0.0 || knot.spin.angle_rad != 0.0; }

}  // namespace carom
