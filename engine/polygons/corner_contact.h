#pragma once
// Finds where and when two gliding bodies touch, if at least one has corners. c = 1.
//
// Two bodies with corners: a corner's world line pierces a side of the other. This is an event on which all
// frames agree; they disagree on which of several piercings is the first. Here that is decided, as for two
// discs (puck_contact.h), in the frame in which both move with equal and opposite speeds, U ∝ u1 + u2. In the
// axes of b, a boost of the board's, and back by the angle of b, corner d of a at its own time s is at
//     z(s) = Rot(−φ_b − Ω_b τ_b) [X_a − X_b + E_a Rot(φ_a + Ω_a s) d + u_a s]   in the components along E_b,
// τ_b being b's own time of that event. Without spin z is linear and the piercing closed; with spin it is
// found by conservative advancement: per metre of s the distance between a corner and an outline falls by at
// most
//     γrel (1 + βrel f_a) (min(1, βrel + f_a) + f_b),    f the speed of the farthest corner.
// Contacts of two curved sides between corners, which are rarer than their sagitta is large, do not count.
//
// A disc and a body with corners: in the frame of U the disc is an ellipse. A stretch along its velocity
// makes it a circle; the sides join the corners' simultaneous events and stay straight, but for those of a
// body that turns. They touch where the circle's centre is R from the stretched outline.
//
// A flight holds from its start on: a contact counts from the moment on at which both have begun, in the
// frame of U, or, of two that begin at board time 0, after board time 0. Bodies that overlap by then and
// approach are in contact at that moment, without delay. Bodies that have not parted since an earlier
// contact: see persistent_contact.h. Theory: app/doc/physics.md, Polygons.

#include <limits>
#include <optional>
#include <vector>

#include "engine/collision/puck_contact.h"
#include "engine/polygons/moving_shape.h"
#include "engine/polygons/persistent_contact.h"

namespace carom {

/// A contact of such bodies.
struct CornerContact {
  PairContact contact;
  bool withoutDelay = false;  ///< in contact and approaching when the later flight began
  /// A side lies on a side: several piercings happen at one time. The contact is in their middle.
  bool sideOnSide = false;
  /// No contact, but how far the search has come: there is none before, and it goes on `after` this time.
  bool unfinished = false;
  double time = 0.0;  ///< in the frame of U, from the first one's start on
};

/// Returns the first contact of two flights, at least one with an outline; none if they do not meet. With
/// `after`, the time of a contact of these flights, the next one: of a corner that comes in, or goes deeper,
/// later.
std::optional<CornerContact> findCornerContact(const MovingShape& first, const MovingShape& second,
                                               double after = -std::numeric_limits<double>::infinity(),
                                               const PersistentContact* earlier = nullptr,
                                               bool onlyNew = false);
/// Returns the contact that is the first in the frame of the four-velocity `order`.
std::optional<CornerContact> findCornerContact(const MovingShape& first, const MovingShape& second,
                                               const Vec21& order,
                                               const PersistentContact* earlier = nullptr);

/// Returns whether two bodies will part for good on another side than that of an earlier contact; only of
/// convex ones this is known. Each follows its flights one after the other, from the contact or the first
/// start on. Frames disagree about the side: bodies that go on approaching along n, above 0.02 c, part
/// elsewhere, too, if they have come out of each other at an angle to n of which the cosine is less than
/// their relative speed.
bool partElsewhere(const std::array<std::vector<MovingShape>, 2>& flights, const PersistentContact& earlier);
/// Returns whether two convex bodies go past each other on flights on which they do not touch again: they
/// approach along the impulse `touched.n` of a contact, above 0.02 c, and part on the board on a side that
/// looks against it. `noted` is what they know of an earlier contact.
bool goPast(const MovingShape& first, const MovingShape& second, const PersistentContact& touched,
            const PersistentContact* noted);

/// Returns how two bodies have come from an earlier contact by the moment at which the later flight begins,
/// in the frame of equal speeds; or by a time of this frame, from the first one's start on.
PenetrationState penetrationSince(const PersistentContact& earlier, const MovingShape& first,
                                  const MovingShape& second);
PenetrationState penetrationSince(const PersistentContact& earlier, const MovingShape& first,
                                  const MovingShape& second, double time);

/// A place at which two bodies touch: PairContact's C and n.
struct TouchedPlace {
  Vec21 event, n;
};
/// Returns all places at which two bodies touch or overlap as the later flight begins, in the frame of equal
/// speeds. Places nearer than `within` touch.
std::vector<TouchedPlace> touchedPlaces(const MovingShape& first, const MovingShape& second, double within,
                                        const PersistentContact* earlier = nullptr);

/// Returns the places at which two bodies with corners that have not parted since an earlier contact are in
/// or through each other at a time of the frame of equal speeds, from the first one's start on.
std::vector<TouchedPlace> placesKeptOut(const MovingShape& first, const MovingShape& second, double time,
                                        const PersistentContact& earlier);

/// Returns the moments of the contact by which the game orders its events: so long before each centre's turn
/// as light needs to cross the body's radius, or the turn where this does not wait for the signal.
Meeting meetingOf(const MovingShape& first, const MovingShape& second, const CornerContact& found,
                  TurnConvention convention);

}  // namespace carom
