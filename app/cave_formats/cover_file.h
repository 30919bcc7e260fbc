#pragma once
// Reads OpenCOVER's configurations (COVISE's XML): the screens, channels, viewports and windows of each
// computer of a cluster. Millimetres, x right, y forward, z up.

#include <filesystem>
#include <string>

#include "app/room_checks/room.h"
#include "app/room_parts/part.h"

namespace carom {

/// Reads the room from the file's content, with the files that it includes. `wanted` names the master of one
/// of several clusters. Faults of single values become findings and their walls are left out. Throws
/// InputErrors if a file includes itself or there are several clusters and none is named.
Room readCover(const std::filesystem::path& file, Part root, const std::string& wanted);

}  // namespace carom
