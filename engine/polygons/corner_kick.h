#pragma once
// Computes how a contact changes momenta and spins where it lies beside a centre: the kick with levers. c
// = 1.
//
// In the frame of the total momentum P, with k along the normal, from the first to the second, and t along
// the sides, the impulse q = α k + β t changes the momentum of the first by q, that of the second by −q, and
// through their levers the spins
//     j1' = j1 + (α Λ1 + β λ1)/R1     j2' = j2 − (α Λ2 + β λ2)/R2     Λ = det(u, r, k)   λ = det(u, r, t)
// with r from the centre to the contact. The energy H(α, β) = Σ sqrt(M(j')² + p'²) is convex. The bodies
// approach where −k lowers it; H is again what it was at α_e, and
//     α = (1 + e)/2 α_e     β = β_s + e_t (β_e − β_s),  |β| ≤ μ |α|
// with β_s where H(α, β) is least and β_e where it is H(α, 0) again. Four-momentum is conserved exactly; what
// H lacks is heat, shared in proportion to the energies in that frame, which each body radiates in its own
// rest frame: it keeps its velocity. A cushion rests on the board and takes no energy: H is the energy of
// the one body there. The levers of two discs vanish, and it is the kick of kick.h.
// Theory: app/doc/physics.md, Polygons.

#include <array>
#include <optional>

#include "engine/collision/rim_friction.h"

namespace carom {

/// A body as its contact finds it.
struct LeveredBody {
  SpinningPuck puck;
  double radius = 0.0;  ///< the R of j = J/(R c)
  Vec21 lever;          ///< from an event of the centre to the contact
};

/// Returns the kick that two bodies give each other; none if they recede from each other. U and n are those
/// of `PairContact`.
std::optional<SpinningPairKick> kickCorners(const Vec21& U, const Vec21& n,
                                            const std::array<LeveredBody, 2>& bodies, const RimRules& rules);

/// Returns the kick that a cushion gives; none if what touches it does not move towards it.
std::optional<SpinningCushionKick> kickCornerOffCushion(const CushionPlane& cushion, const LeveredBody& body,
                                                        const RimRules& rules);

}  // namespace carom
