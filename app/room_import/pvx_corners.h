#pragma once
// Where a room file of ParaView has the screens of its machines.

#include "app/room_import/room.h"
#include "app/room_import/xml_tree.h"

namespace carom {

/// The largest picture of a window, along an edge.
inline constexpr int kMostPvxPixels = 16384;

/// Reads the corners of a machine's wall; one without any shows ParaView's ordinary view. False, with errors
/// noted, where they make no wall.
bool readCorners(const XmlElement& machine, Wall& wall, Room& room);

/// Gives a wall of known size its pixels, where the machine does not say them.
void assumePixels(const XmlElement& machine, Wall& wall, Room& room);

}  // namespace carom
