#pragma once
// Reads the display systems of HEVS (EPICentre, UNSW): JSON with comments, several platforms in a file. Keys
// and defaults are those of its configuration guide. Lengths in metres, x right, y up, z forward
// (left-handed).

#include <filesystem>
#include <string>

#include "app/room_checks/room.h"
#include "app/room_parts/part.h"

namespace carom {

/// Reads the platform of that name from the file's content; an empty name is right if there is only one.
/// Faults of single values become findings and their walls are left out, as are curved displays and domes.
/// Throws InputErrors if there is no such platform, or several and none is named.
Room readHevs(const std::filesystem::path& file, const Part& root, const std::string& platform);

}  // namespace carom
