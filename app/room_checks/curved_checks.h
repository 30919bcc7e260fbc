#pragma once
// Checks of a wall with a curved screen, and its facts in words.

#include <array>
#include <string>
#include <vector>

#include "app/room_checks/verdict.h"
#include "cave/screen/screen_mesh.h"

namespace carom {

/// Checks where the eyes are before the screen, how squarely they look at it, its pixels, and how much of the
/// window shows it.
void judgeCurved(const RoomWall& wall, Verdict& verdict);

/// A wall's screen and where it ends; empty for a picture by direction.
struct ScreenEnd {
  ScreenMesh mesh;
  std::vector<std::array<ScreenPoint, 2>> rim;
  bool isCurved = false;
};

/// Returns those of all walls; none at all in a room without curved screens.
std::vector<ScreenEnd> screenEndsOf(const Room& room);

/// Checks whether two walls, of which one is curved, meet at their rims.
void judgeRims(const RoomWall& a, const RoomWall& b, const ScreenEnd& endA, const ScreenEnd& endB,
               Verdict& verdict);

/// Returns a flat wall at the middle of a curved screen that faces as the screen does on the whole.
Wall chordOf(const Wall& wall);

/// Returns the screen's size, its pixels, its distance from the eyes, and the flat pieces on which it is
/// drawn.
std::string wordsForCurved(const RoomWall& wall, const Room& room);

}  // namespace carom
