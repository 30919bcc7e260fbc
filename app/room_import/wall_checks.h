#pragma once
// What can be odd about one wall of a room.

#include <string_view>

#include "app/room_import/verdict.h"

namespace carom {

/// Judges a wall's pixels, window, name and distance.
void judgeWall(const RoomWall& wall, Verdict& verdict);

/// A side of a room.
struct Side {
  std::string_view name;   ///< of the wall there
  std::string_view where;  ///< as seen by a person
  glm::dvec3 direction;
};

/// The side whose direction is nearest to the one in which the wall is looked at squarely.
Side lookedAt(const Wall& wall, const RoomAxes& axes);

}  // namespace carom
