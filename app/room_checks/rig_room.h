#pragma once
// Converts a rig to a room so that it can be checked.

#include "app/room_checks/room.h"

namespace carom {

/// Returns the rig's room. Its viewer is at the initial head position: for a recorded tracker the start of
/// its trace, for all others someone standing at the room's origin. Throws InputErrors if the trace cannot be
/// read.
Room roomOf(const PlacedRig& rig, const std::filesystem::path& file);

}  // namespace carom
