#pragma once
// Reads SGCT's older description of a display system, in XML (SGCT 1 and 2): the same rooms as in JSON, by
// elements and attributes whose capitals differ between versions.

#include <filesystem>

#include "app/room_import/json_tree.h"
#include "app/room_parts/part.h"

namespace carom {

/// Returns what the file says as SGCT 3 writes it in JSON, each value with its place in the XML file.
JsonNode sgctFromXml(const Part& root);

}  // namespace carom
