#pragma once
// Finds where and when a gliding disc touches a cushion, and where its centre then turns. c = 1.
//
// Convention "centre" (the paper, section 3.3.2.3): the contact is taken in the puck's own rest frame, the
// earliest whose signal can reach the centre. A cushion at distance y from the centre, towards which it moves
// with u_n = γβ_n, is touched when
//     y = R sqrt(1 + u_n²),   at   C = X + R K / sqrt(1 + u_n²),   K = (u_n γ, n + u_n u),
// K being the part of the cushion's normal (0, n) orthogonal to u. The centre turns R later on its own clock,
// at y = R (sqrt(1 + u_n²) − u_n): always inside.
// Convention "contact": when the contracted rim touches on the board, y = R sqrt(1 − β_n²), at the ellipse's
// foremost point, X + R (n − β β_n)/sqrt(1 − β_n²).
// Theory: app/doc/physics.md, The frame of a contact.

#include <optional>

#include "engine/collision/puck_contact.h"
#include "engine/collision/puck_leg.h"
#include "engine/spacetime/minkowski.h"

namespace carom {

/// A straight cushion: the plane sign × coordinate = distance from the board's centre.
struct CushionPlane {
  int axis = 0;           ///< 0: across x, 1: across y
  double sign = 1.0;      ///< which of the two cushions across that axis
  double distance = 0.0;  ///< metres from the board's centre

  /// Returns how far inside the plane an event lies.
  double inside(const Vec21& x) const { return distance - sign * (axis == 0 ? x.x : x.y); }
  /// Returns the component of a four-velocity towards the plane.
  double towards(const Vec21& u) const { return sign * (axis == 0 ? u.x : u.y); }
};

struct CushionContact {
  double ownTime = 0.0;  ///< as in `Meeting`
  Vec21 event;           ///< C; for `withoutDelay` the place on the cushion beside the centre, when it turns
  LegState turn;         ///< the centre as it turns, still with its incoming velocity
  bool withoutDelay = false;  ///< already in contact when the leg began
};

/// Returns the contact of a leg with a cushion; none if the puck does not move towards it or comes to rest
/// before.
std::optional<CushionContact> findContact(const Leg& leg, double radius, const CushionPlane& cushion,
                                          TurnConvention convention);

}  // namespace carom
