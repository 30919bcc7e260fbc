#pragma once
// The trackers of an SGCT room, in JSON or XML.

#include "app/room_checks/room.h"
#include "app/room_import/json_tree.h"

namespace carom {

/// Adds the VRPN tracker of the first user's head, and that of a device called wand or hand, and names the
/// others. `root` is the file's content as SGCT 3 has it in JSON.
void addSgctTrackers(const JsonNode& root, Room& room);

}  // namespace carom
