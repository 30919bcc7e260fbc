#pragma once
// The viewports in a room file of SGCT: each shows a wall.

#include "app/room_import/sgct_reading.h"

namespace carom {

/// Adds the wall that a viewport shows to the room, or a finding that says why not.
void readViewport(const JsonNode& node, const SgctWindow& window, SgctReading& in);

}  // namespace carom
