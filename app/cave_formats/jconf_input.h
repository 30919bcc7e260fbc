#pragma once
// Users, proxies and devices of a VR Juggler configuration as the people and trackers of a room.

#include <map>
#include <string>

#include "app/room_checks/room.h"
#include "app/room_parts/part.h"

namespace carom {

/// Adds the users in the order of the file, one at least, with the trackers of their heads, and the wand of
/// the first. Returns the index of each user by name.
std::map<std::string, std::size_t> readJconfUsers(const Part& elements, Room& room);

}  // namespace carom
