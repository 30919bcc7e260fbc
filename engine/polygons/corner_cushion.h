#pragma once
// Finds where and when a gliding body with corners touches a cushion, and where its centre then turns. c = 1.
//
// As for a disc (cushion_contact.h) the contact is taken in the body's own rest frame, the earliest by its
// own time s: with y the distance of the centre from the cushion, towards which it moves with u_n, and K =
// (u_n γ, n + u_n u), corner d is there when
//     y = u_n s + Rot(φ + Ω s) d · K,   at   C = X + E Rot(φ + Ω s) d + u s.
// The centre turns |d| later on its own clock. Where turns do not wait for the signal, the earliest corner by
// board time counts, and the centre turns at that board time. Corners that touch at one time, those of a
// side, touch in their middle.
//
// The signal from the end of a long side can come after the centre has crossed the cushion. Then the contact
// is that of the point of the outline straight ahead of the centre, along K, which comes there later, but
// whose signal reaches the centre before it is there itself: so no centre leaves the table. Theory:
// app/doc/physics.md, Polygons.

#include <optional>
#include <vector>

#include "engine/collision/cushion_contact.h"
#include "engine/polygons/corner_contact.h"

namespace carom {

/// A contact of a body with a cushion.
struct CornerCushionContact {
  CushionContact contact;  ///< its own time as in `meetingOf`
  bool sideOnSide = false;
};

/// Returns the contact of a flight with a cushion; none if no corner comes to it. `properTime` is that of the
/// start. A body with a corner beyond the cushion as the leg begins, and goes on, touches it then, without
/// delay.
std::optional<CornerCushionContact> findCornerContact(const MovingShape& flight, double properTime,
                                                      const CushionPlane& cushion, TurnConvention convention);

/// Returns the corners that touch a cushion, nearer than `within`, or are beyond it as the leg begins.
std::vector<Vec21> touchedPlaces(const MovingShape& flight, const CushionPlane& cushion, double within);

}  // namespace carom
