#pragma once
// How a puck turns about its axis while it follows a leg. c = 1.
// Theory: app/doc/physics.md, Spin.

#include "engine/collision/spinning_body.h"
#include "engine/spacetime/world_line.h"

namespace carom {

/// The spin and the angle of a puck at one moment of its own time.
struct Turning {
  double j = 0.0;      ///< J/(R c), positive anticlockwise seen from +z
  double angle = 0.0;  ///< from −π to π, in the axes of the leg
};

/// Returns what they are `s` metres of own time later. The cloth takes the share `slowing` of the rim's mass
/// from j in a metre, until there is none.
inline Turning turningAfter(const Turning& turning, const SpinningBody& body, double radius, double slowing,
                            double s) {
  if (turning.j == 0.0) return turning;
  const Spin spin{turning.angle, rimBeta(body, turning.j) / radius, turning.j / body.rim, slowing};
  return {slowing == 0.0 ? turning.j : body.rim * rimUAfter(spin, s), angleAfter(spin, s)};
}

}  // namespace carom
