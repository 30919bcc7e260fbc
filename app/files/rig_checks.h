#pragma once
// What can be checked of a rig once every value by itself is right.

#include <vector>

#include "app/files/rig.h"
#include "app/files/rig_walls.h"
#include "app/files/toml_file.h"

namespace carom {

/// Names and ranks that are taken, walls that are no rectangle, places in windows that overlap.
void checkTogether(const TomlTable& root, const Rig& rig, const std::vector<WallText>& walls);

/// Light should leave all walls together, that of the slowest. The others' pictures wait for it, by whole
/// frames: what is left is half a frame at most.
void holdBackTheFast(Rig& rig, const std::vector<TomlTable>& tables);

}  // namespace carom
