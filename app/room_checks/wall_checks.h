#pragma once
// Checks of a single wall of a room.

#include <string_view>

#include "app/room_checks/verdict.h"

namespace carom {

/// Checks a wall's pixels, window, name and distance.
void judgeWall(const RoomWall& wall, Verdict& verdict);

/// A side of a room.
struct Side {
  std::string_view name;   ///< of the wall there
  std::string_view where;  ///< as seen by the viewer
  glm::dvec3 direction;
};

/// Returns the side whose direction is nearest to that in which one looks at the wall perpendicularly.
Side lookedAt(const Wall& wall, const RoomAxes& axes);

}  // namespace carom
