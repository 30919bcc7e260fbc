#pragma once
// Reads the viewports of an SGCT room file; each shows one wall.

#include "app/room_import/sgct_reading.h"

namespace carom {

/// Adds the wall that a viewport shows to the room, or a finding with the reason why not.
void readViewport(const JsonNode& node, const SgctWindow& window, SgctReading& in);

}  // namespace carom
