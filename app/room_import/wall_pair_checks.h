#pragma once
// What can be odd about two walls of a room together.

#include "app/room_import/verdict.h"

namespace carom {

/// Judges whether tiles lie in one plane, edges meet, walls cut through each other, windows overlap.
void judgePair(const RoomWall& a, const RoomWall& b, Verdict& verdict);

}  // namespace carom
