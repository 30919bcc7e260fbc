#pragma once
// The computers of an SGCT room, in JSON or XML.

#include "app/room_checks/room.h"
#include "app/room_import/json_tree.h"

namespace carom {

/// Gives each rank of the room, which is a node of the file, its computer, unless all of them are this one;
/// tells if the master is not the first. `root` is the file's content as SGCT 3 has it in JSON.
void addSgctNodes(const JsonNode& root, Room& room);

}  // namespace carom
