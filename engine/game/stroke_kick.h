#pragma once
// The kick of a cue: what a stroke makes of the velocity and the spin of a puck. c = 1.
//
// With the offset d, b to the right of the momentum Δp in the puck's rest frame:
//     J' = J + det(u, d, (ΔE, Δp)),   E' = sqrt(M(J')² + (p + Δp)²),   ΔE = E' − E
// A puck at rest gets J' = J + b |Δp|. The determinant grows with ΔE by b u∥, u∥ the celerity along Δp, and
// E' with J' by less than 1/R, so while b u∥ < R there is one J'. Theory: app/doc/physics.md, Spin.

#include "engine/game/puck_state.h"

namespace carom {

/// A puck after a stroke.
struct StruckPuck {
  Vec21 u;
  double j = 0.0;
};

/// Returns what a stroke leaves of a puck with the four-velocity `u` and the spin `j`. One that would grip
/// farther out than 0.99 R/u∥ grips there (`Stroke::offset_m`).
StruckPuck struckPuck(const SpinningBody& body, double radius, const PuckStroke& stroke, const Vec21& u,
                      double j);

}  // namespace carom
