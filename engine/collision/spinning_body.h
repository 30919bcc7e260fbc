#pragma once
// The material of a puck that spins: a core and beads on its rim. c = 1.
//
// No disc stays rigid while its spin changes (Ehrenfest 1909, Herglotz and Noether 1910), so a material
// must be chosen. The share k of the mass m sits as beads on the rim, held by massless spokes; the rest
// sits in the centre. The spokes pull at right angles to the motion of the beads, and so add neither energy
// nor angular momentum in the centre's rest frame:
//     j = J/(R c)      M(j) = (1−k) m + sqrt((k m)² + j²)      f = ωR/c = j/sqrt((k m)² + j²)      dM/dj = f
// M is the mass that moves, p = M u. The rim's rapidity is asinh(j/(k m)), so every J has a rim slower than
// light. For slow rims the moment of inertia is k m R².
// Theory: app/doc/physics.md, Spin.

#include <algorithm>
#include <cmath>

namespace carom {

/// The masses of a puck that does not spin.
struct SpinningBody {
  double mass = 0.0;  ///< m
  double rim = 0.0;   ///< k m, above 0
};

/// Returns the energy of the beads, sqrt((k m)² + j²).
inline double rimEnergy(const SpinningBody& body, double j) { return std::sqrt(body.rim * body.rim + j * j); }

/// Returns the rest mass M of a body with the spin j; exactly m without spin.
inline double restMass(const SpinningBody& body, double j) {
  return body.mass + j * j / (rimEnergy(body, j) + body.rim);
}

/// Returns the speed f of the rim, over c, with the sign of the spin: below 1 also where its digits would
/// say 1.
inline double rimBeta(const SpinningBody& body, double j) {
  constexpr double kFastest = 1.0 - 0x1p-50;
  return std::clamp(j / rimEnergy(body, j), -kFastest, kFastest);
}

/// Returns the spin j with which the rim has the speed f, |f| < 1.
inline double spinOfRim(const SpinningBody& body, double f) {
  return body.rim * f / std::sqrt((1.0 - f) * (1.0 + f));
}

}  // namespace carom
