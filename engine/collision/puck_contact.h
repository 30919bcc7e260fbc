#pragma once
// Finds where and when two gliding discs touch.
//
// Rigid discs "first touch" at an event that depends on whose simultaneity is used. Here it is that of the
// frame in which both move with equal and opposite speeds ("equal-speed frame", four-velocity U ∝ u1 + u2):
// the centre-of-mass frame of the paper's appendix for equal pucks, and well defined for any masses and
// radii. With u = γ(1, v/c), X an event of each centre, metric (+,−,−), c = 1:
//
//   γrel = u1·u2     γ' = sqrt((γrel+1)/2)     γ'β' = sqrt((γrel−1)/2)
//   U = (u1+u2)/(2γ')     e = (u1−u2)/(2γ'β')     D = X2−X1     a = U·D     d = −e·D     perp = D − aU − d e
//   b² = −perp·perp     Dpar = d + aβ'     dmin = sqrt((R1+R2)² − b²)/γ'     Δt' = (Dpar − dmin)/(2β')
//   contact event  C = X1 + (Δt'/γ') u1 + R1/(R1+R2) (dmin e + perp)
//
// Own proper time of puck i from X_i to the contact: (Δt'_i)/γ' by the equal-speed frame's simultaneity
// (Δt'_1 = Δt', Δt'_2 = Δt' − a), and u_i·(C − X_i) by its own: the signal from C is at its centre R_i later.
// Theory: app/doc/physics.md, The frame of a contact.

#include <array>
#include <optional>

#include "engine/spacetime/minkowski.h"

namespace carom {

/// The event at which a puck's centre turns: see `CollisionEvent` in billiard_setup.h.
enum class TurnConvention { signalAtCentre, simultaneousWithContact };

/// A disc in straight flight from `start` on. Fills a cache line.
struct alignas(64) Disc {
  Vec21 start;
  Vec21 u{1.0, 0.0, 0.0};
  double radius = 0.0;
  double turnsAt = 0.0;  ///< board time from which this flight no longer holds; for the caller's use
};

/// The meeting of two discs: the part of it that is needed to decide whether and in which order contacts
/// happen.
struct Meeting {
  /// Board time of each centre at its own moment of the contact. Where turns wait for the signal, this moment
  /// precedes the turn, and the order of these moments is the order of the turns. It lies
  /// before the start of the flight if the rim was in contact by then.
  std::array<double, 2> ownTime{};
  bool withoutDelay = false;  ///< already in contact and approaching when the later flight began
};

/// A quick test that excludes most pairs. Returns false if the flights certainly do not meet, because b > R1
/// + R2, because they have one velocity or, where turns are simultaneous with the contact, because they
/// recede.
inline bool mayMeet(const Disc& first, const Disc& second, TurnConvention convention) {
  const Vec21 D = second.start - first.start;
  const double reach = first.radius + second.radius;
  const double gammaRel = dot(first.u, second.u);
  const double triple = dot(cross(first.u, second.u), D);
  const double rounding =
      1e-9;  // far above what rounding does to these sums, far below what matters for speed
  const double s2 = gammaRel * gammaRel * (1.0 + rounding) - 1.0;  // γrel² − 1
  const bool differ = (first.u.x != second.u.x) | (first.u.y != second.u.y);
  const bool near = differ & !(triple * triple > reach * reach * s2);
  if (convention == TurnConvention::signalAtCentre) return near;
  // Dpar at the later start, times γ'β' (γrel + 1): see findMeeting.
  const double towards = dot(second.u - first.u, D) * (gammaRel + 1.0);
  const double spent = std::abs(dot(first.u + second.u, D)) * (gammaRel - 1.0);
  return near & (towards - spent > -rounding * (std::abs(towards) + std::abs(spent)) - rounding * reach);
}

/// Returns the meeting of two flights, if they meet. They do iff b < R1 + R2 and both turns come after the
/// starts of the flights; or, `withoutDelay`, if the discs overlap and approach each other in the equal-speed
/// frame at the later of the two starts. A contact that would lie before the start in the puck's own frame
/// and behind the closest approach does not count: the pucks recede. Pucks whose flights both begin at board
/// time 0 meet only after it.
std::optional<Meeting> findMeeting(const Disc& first, const Disc& second, TurnConvention convention);

/// The contact of two flights for which `findMeeting` has found one.
struct PairContact {
  Vec21 event;  ///< C
  Vec21 U;      ///< four-velocity of the equal-speed frame
  Vec21 n;      ///< normal of the touching rims, from the first towards the second: γ'² dmin e + perp
  std::array<double, 2> simultaneous{};  ///< own proper time from the start to C by U's simultaneity
  bool central = false;                  ///< the kick acts through both centres, whatever the place
  std::array<double, 2> signal{};  ///< own proper time from the start to the signal's arrival at the centre
};
PairContact contactOf(const Disc& first, const Disc& second, bool withoutDelay);

}  // namespace carom
