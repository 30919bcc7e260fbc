#pragma once
// SGCT's description of a display system (.json): nodes, their windows, and viewports with a projection plane
// each. Keys and words as in SGCT's own schema (sgct.schema.json).

#include <filesystem>

#include "app/room_import/room.h"

namespace carom {

/// Reads the whole file. Faults of single values become findings and their walls are left out; so do
/// projections that no flat wall stands for. Throws InputErrors where the file cannot be read or is no JSON.
Room readSgct(const std::filesystem::path& file);

}  // namespace carom
