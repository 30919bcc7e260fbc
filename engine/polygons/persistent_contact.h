#pragma once
// The memory of a pair: the contact at which it came together. c = 1.
//
// Light needs time from a contact to the centres, so that bodies go into each other before they turn, and
// thin ones can come out behind each other: they must go back. Until they have parted, a corner (the centre
// of a disc) that is in or behind the other body is known by its way: straight from where it was at that
// contact, as the other body sees it. The side by which this way comes in is the one to which it belongs,
// however near another is, and what comes at a side from behind does not touch it. Convex bodies that are in
// or through each other are free to turn there: to them the sides count that look, by then, to where the
// other one was on the board. A corner that has come in, or is through, is kept out by that side as a leg
// begins. From the moment on at which the two have parted on their flights, all this is forgotten. Convex
// ones that have been through each other have parted when a line across the contact's normal parts them.
//
// Convex bodies are also followed through each other, in the frame of equal speeds of the contact: they have
// passed when the side that parts them, as they come out, looks against the impulse of the contact. A contact
// after which they would part for good on such a side goes on with a kick through both centres, along its
// impulse, which sends them back. Theory: app/doc/physics.md, Polygons.

#include <array>

#include "engine/polygons/moving_shape.h"

namespace carom {

/// Two flights and the contact at which they came together.
struct PersistentContact {
  std::array<MovingShape, 2> flights;
  Vec21 event, n;       ///< PairContact's C and n; or, instead of n, the impulse
  bool behind = false;  ///< they have been found to be through each other since
};

/// How two bodies have come from an earlier contact: apart; some corners, or the centre of a disc, into the
/// other; or some through it.
enum class PenetrationState { apart, inside, through };

}  // namespace carom
