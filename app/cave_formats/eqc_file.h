#pragma once
// Reads the walls of an Equalizer configuration: those of segments, canvases, views and compounds, on the
// channels of its nodes' windows. Metres, x right, y up, z back.

#include <filesystem>
#include <string>

#include "app/room_checks/room.h"
#include "app/room_parts/part.h"

namespace carom {

/// Reads the configuration from the file's parts (eqc_syntax.h); `room` names one of several, by its name or
/// else by its number from 0. Faults of single values become findings and their walls are left out.
Room readEqc(const std::filesystem::path& file, const Part& root, const std::string& room);

}  // namespace carom
