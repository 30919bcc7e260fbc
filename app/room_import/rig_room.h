#pragma once
// A rig as a room to be judged.

#include "app/room_import/room.h"

namespace carom {

/// The viewer is where the head starts: of a recorded tracker where its trace begins, of all others someone
/// standing on the room's origin. Throws InputErrors where the trace cannot be read.
Room roomOf(const PlacedRig& rig, const std::filesystem::path& file);

}  // namespace carom
