#pragma once
// Reads nDisplay's configurations: the JSON of Unreal Engine 4.26 and later (.ndisplay, centimetres) and the
// text form of before (.cfg, metres).

#include <filesystem>
#include <string>

#include "app/room_checks/room.h"
#include "app/room_parts/part.h"

namespace carom {

/// Reads the JSON form. Faults of single values become findings and their walls are left out, as are
/// projections by warp files and screens that hang on the viewer's head.
Room readNdisplay(const std::filesystem::path& file, const Part& root);

/// Reads the text form, `root` being its lines (ndisplay_cfg.h).
Room readNdisplayCfg(const std::filesystem::path& file, const Part& root);

/// Returns the lines of the text form as parts: each named as its bracket, its keys as parts. Throws
/// InputErrors if the file cannot be read.
Part readCfgLines(const std::filesystem::path& file);

}  // namespace carom
