#pragma once
// Reads the configurations of BlenderCAVE and of BlenderVR, which followed it. Metres, x right, y up, z back;
// the origin is at the eyes or on the floor.

#include <filesystem>
#include <string>

#include "app/room_checks/room.h"
#include "app/room_parts/part.h"

namespace carom {

/// Reads the room from the file's content, `leftOut` being the files that it names as entities. BlenderVR has
/// several configurations in a file, of which `wanted` names one. Faults of single values become findings and
/// their walls are left out, as are consoles and head-mounted displays. Throws InputErrors if there is no
/// such configuration, or several and none is named.
Room readBlender(const std::filesystem::path& file, const Part& root,
                 const std::vector<OutsideEntity>& leftOut, const std::string& wanted);

}  // namespace carom
