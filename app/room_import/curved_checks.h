#pragma once
// Checks of a wall with a curved screen, and its facts in words.

#include <string>

#include "app/room_import/verdict.h"

namespace carom {

/// Checks where the eyes are before the screen, how squarely they look at it, its pixels, and how much of the
/// window shows it.
void judgeCurved(const RoomWall& wall, Verdict& verdict);

/// Returns the screen's size, its pixels, its distance from the eyes, and the flat pieces on which it is
/// drawn.
std::string wordsForCurved(const RoomWall& wall, const Room& room);

}  // namespace carom
