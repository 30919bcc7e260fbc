#pragma once
// Checks of a rig that involve several values, after each value has been checked by itself.

#include <vector>

#include "app/files/rig.h"
#include "app/files/rig_walls.h"
#include "app/files/toml_file.h"

namespace carom {

/// Reports duplicate names and ranks, walls that are not rectangles, and overlapping windows.
void checkTogether(const TomlTable& root, const Rig& rig, const std::vector<WallText>& walls);

/// Delays the faster walls so that all walls emit light together with the slowest. The delay is a whole
/// number of frames, so the remaining difference is at most half a frame.
void holdBackTheFast(Rig& rig, const std::vector<TomlTable>& tables);

}  // namespace carom
