#pragma once
// Checks whether a room is plausible, from its geometry alone, independent of the file format. A file of
// valid numbers can still describe walls that no building has; each check here is for a mistake once found in
// a file in use.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/room_checks/room.h"

namespace carom {

/// Returns findings about an unusual room, in the order of its file, without the room's own findings.
std::vector<Finding> judgeRoom(const Room& room);

/// Returns a description of the wall: "front: 3.048 × 3.048 m (10 ft), 840 px/m, 1.52 m ahead".
std::string wordsFor(const RoomWall& wall, const Room& room);

/// Returns the side of a wall, from the direction in which one looks at it perpendicularly: "front", "left",
/// "floor" and so on.
std::string_view sideOf(const Wall& wall, const RoomAxes& axes);

/// Returns the height of the floor along the room's up axis: that of a floor wall, or as the format defines
/// it.
std::optional<double> floorHeight_m(const Room& room);

}  // namespace carom
