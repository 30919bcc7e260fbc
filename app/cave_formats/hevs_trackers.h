#pragma once
// The trackers of a HEVS configuration.

#include <string>

#include "app/room_checks/room.h"
#include "app/room_parts/part.h"

namespace carom {

/// Adds the VRPN trackers of a platform, and names the others. That which the stereo settings name, or one
/// called Head, is the head of the room's first person, and one called Wand or Hand their hand.
void readHevsTrackers(const Part& platform, const std::string& headName, Room& room);

}  // namespace carom
