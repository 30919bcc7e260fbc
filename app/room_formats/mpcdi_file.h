#pragma once
// Rooms of the VESA standard MPCDI 1 and 2: projectors and the screens that they have been measured on.

#include <filesystem>

#include "app/room_checks/room.h"

namespace carom {

/// Returns whether a file is one, by its ending or its content: a zip archive, or an .xml whose first element
/// is <MPCDI>.
bool isMpcdi(const std::filesystem::path& file);

/// Reads an .mpcdi or .mpcdi.xml. Of the profile a3 each region becomes a wall with a measured screen, of 3d
/// and 2d a flat wall with a warp, which is right from one place only; sl is an error. The files that such a
/// wall needs are Room::files. Throws InputErrors if it cannot be read.
Room readMpcdi(const std::filesystem::path& file);

}  // namespace carom
