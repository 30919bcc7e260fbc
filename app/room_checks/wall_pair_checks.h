#pragma once
// Checks of two walls of a room together.

#include "app/room_checks/verdict.h"

namespace carom {

/// Checks whether tiles lie in one plane, edges meet, walls intersect, or windows overlap.
void judgePair(const RoomWall& a, const RoomWall& b, Verdict& verdict);

}  // namespace carom
