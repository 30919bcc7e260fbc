#pragma once
// Reads the screens of the machines in a ParaView room file.

#include "app/room_checks/room.h"
#include "app/room_import/xml_tree.h"

namespace carom {

/// Largest edge length of a window's image.
inline constexpr int kMostPvxPixels = 16384;

/// Reads the corners of a machine's wall; a machine without corners has ParaView's default view. Returns
/// false, with errors noted, if they do not form a wall.
bool readCorners(const XmlElement& machine, Wall& wall, Room& room);

/// Sets a default pixel count for a wall of known size if the machine does not give it.
void assumePixels(const XmlElement& machine, Wall& wall, Room& room);

}  // namespace carom
