#pragma once
// Reads SGCT's description of a display system (.json): nodes, their windows, and viewports with one
// projection plane each. Keys and words are those of SGCT's own schema (sgct.schema.json).

#include <filesystem>

#include "app/room_checks/room.h"
#include "app/room_import/json_tree.h"

namespace carom {

/// Reads the whole file. Faults of single values become findings and their walls are left out, as are
/// projections that show no wall. Throws InputErrors if the file cannot be read or is not JSON.
Room readSgct(const std::filesystem::path& file);
/// The same of a file's content in another syntax.
Room readSgct(const std::filesystem::path& file, JsonNode root);

}  // namespace carom
