#pragma once
// Computes how a contact changes the momenta and the spins where rims are rough. c = 1; e is the
// coefficient of restitution along the normal.
//
// The patch of contact is a massless piece of straight wall that takes no energy in its own rest frame. In
// that frame, with n from the puck into the wall and t the direction n turned anticlockwise by 90°, a puck
// of spin j (spinning_body.h) has the energy E and the momentum p_n > 0, p_t = E sin χ:
//   normal      p_n' = −e p_n
//   tangential  each part of the impulse at the rim turns the puck by dj = γ_t dp_t, γ_t = 1/cos χ, and E
//   stays
//               (heat included):  j(χ) = j + E (χ' − χ)
//   heat        h(χ') = m' − M(j(χ')),  m'² = E² − p_n'² − E² sin² χ':  concave in χ'
//   no slip     where h is greatest: E sin χ' cos χ'/m' + f = 0, with f the speed of the rim; the point of
//   the
//               rim that touches then rests
//   elastic     where h is what it was at χ' = χ
//   result      χ' = χ_no slip + e_t (χ_elastic − χ_no slip), unless |E (sin χ' − sin χ)| would exceed
//   Coulomb's
//               limit μ (1 + e) p_n; then the impulse is that limit
// after which the puck keeps its velocity p'/E and has the mass M(j'): the rest of m' is heat.
// A cushion is such a wall at rest on the board. Two pucks press on one wall from both sides: in their
// centre-of-mass frame it rests along the normal and slides along it at the speed w at which both get the
// same tangential impulse.
// Theory: app/doc/physics.md, Spin.

#include <array>
#include <optional>

#include "engine/collision/kick.h"
#include "engine/collision/spinning_body.h"

namespace carom {

/// The laws of a rim's contact.
struct RimRules {
  double restitution = 1.0;            ///< e
  double friction = 0.0;               ///< Coulomb's μ; infinite: rims never slide
  double tangentialRestitution = 0.0;  ///< e_t: 0, they rest on each other afterwards; 1, elastic
};

/// A puck as its contact finds it.
struct SpinningPuck {
  SpinningBody body;
  double j = 0.0;  ///< J/(R c), positive anticlockwise seen from +z
  Vec21 u;         ///< four-velocity of the centre
};

struct SpinningPairKick {
  PairKick centres;
  std::array<double, 2> j{};
};

/// Returns the kick that two pucks give each other; none if their momenta recede from each other along the
/// normal. Without friction it is kickPair with the masses M(j), to the bit.
std::optional<SpinningPairKick> kickSpinningPair(const Vec21& U, const Vec21& n,
                                                 const std::array<SpinningPuck, 2>& pucks,
                                                 const RimRules& rules);

struct SpinningCushionKick {
  CushionKick centre;
  double j = 0.0;
};

/// Returns the kick that a cushion gives; none if the puck does not move towards it. Without friction it is
/// kickOffCushion with the mass M(j), to the bit.
std::optional<SpinningCushionKick> kickSpinningOffCushion(const CushionPlane& cushion,
                                                          const SpinningPuck& puck, const RimRules& rules);

}  // namespace carom
