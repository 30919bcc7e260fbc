#pragma once
// Whether a room can be: its geometry judged, whatever file it came from. A file of correct numbers can still
// describe walls that no building has; each judgement here is a mistake once found in a file in use.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/room_import/room.h"

namespace carom {

/// What is odd about the room, in the order of its file. The room's own findings are not repeated.
std::vector<Finding> judgeRoom(const Room& room);

/// The wall in words: "front: 3.048 × 3.048 m (10 ft), 840 px/m, 1.52 m ahead".
std::string wordsFor(const RoomWall& wall, const Room& room);

/// Which way a wall lies, by the direction in which one looks squarely at it: "front", "left", "floor" and so
/// on.
std::string_view sideOf(const Wall& wall, const RoomAxes& axes);

/// Height of the floor along the room's up: that of a wall which is one, or as the format fixes it.
std::optional<double> floorHeight_m(const Room& room);

}  // namespace carom
