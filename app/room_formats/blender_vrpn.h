#pragma once
// The VRPN section of a BlenderCAVE or BlenderVR configuration.

#include <map>
#include <string>

#include "app/room_checks/room.h"
#include "app/room_parts/part.h"

namespace carom {

/// Adds the trackers of a <vrpn> element. Sensors that place a user become their head; `users` has the index
/// of each by name and by number.
void readBlenderVrpn(const Part& vrpn, const std::map<std::string, std::size_t>& users, Room& room);

}  // namespace carom
