#pragma once
// A room of another program as the text of a rig.

#include <string>

#include "app/room_checks/room.h"

namespace carom {

/// Moves the room, with its trackers, so that the origin is on the floor, as rigs have it; where the file
/// says at which place the viewer stands, beneath the viewer.
void putOnFloor(Room& room);

/// Removes the nodes unless they have hosts or their displays differ.
void keepDisplays(Room& room);

/// Lets a simulated person stand for everybody without a tracker, and for the second of two with one sensor.
void simulateUntracked(Room& room);

/// Returns the rig, in the room's unit and axes. Its first comments are what was assumed, then what of the
/// file was left out or is doubtful, by lines.
std::string rigText(const Room& room);

}  // namespace carom
