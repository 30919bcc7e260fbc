#pragma once
// How two convex bodies with corners go past each other on the board after their last touch. Theory:
// app/doc/physics.md, Polygons.

#include "engine/polygons/persistent_contact.h"

namespace carom {

/// Returns whether two convex bodies that approach along the impulse `touched.n` of a contact part for good,
/// on the board, on a side that looks against it. Both are followed by the straight lines between their
/// corners, from the board time on at which the later flight begins; a side is compared with the impulse as
/// it lay at the contact, and as it has turned with either body since.
bool passEachOther(const MovingShape& first, const MovingShape& second, const PersistentContact& touched);

}  // namespace carom
