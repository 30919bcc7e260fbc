#pragma once
// Reads VR Juggler's configurations (.jconf, version 3 of its XML): display windows with surface viewports,
// users, position proxies and devices. Metres, x right, y up, z back.

#include <filesystem>
#include <string>

#include "app/room_checks/room.h"
#include "app/room_parts/part.h"

namespace carom {

/// Reads the configuration from the file's content. `wanted` names one of several display systems. Faults of
/// single values become findings and their walls are left out, as are simulators and tracked surfaces. Throws
/// InputErrors if an included file cannot be read, or there are several display systems and none is named.
Room readJconf(const std::filesystem::path& file, Part root, const std::string& wanted);

}  // namespace carom
