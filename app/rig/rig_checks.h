#pragma once
// Checks of a rig that involve several values, after each value has been checked by itself.

#include <optional>
#include <string>
#include <vector>

#include "app/rig/rig.h"
#include "app/rig/rig_walls.h"
#include "app/toml/toml_file.h"

namespace carom {

/// Reports duplicate names and ranks, walls that are not rectangles, and overlapping windows.
void checkTogether(const TomlTable& root, const Rig& rig, const std::vector<WallText>& walls);

/// Delays the faster walls so that all walls emit light together with the slowest. The delay is a whole
/// number of frames, so the remaining difference is at most half a frame.
void holdBackTheFast(Rig& rig, const std::vector<TomlTable>& tables);

/// The box around the walls that stand in a room, room frame; none where there are none.
struct RoomBox {
  Vec3 low_m{0.0}, high_m{0.0};
};
std::optional<RoomBox> boxOf(const Rig& rig);

/// Returns a warning if spacetime is to stand outside all walls of the room.
std::optional<std::string> warningOf(const SpacetimeSetup& setup, const Rig& rig);

}  // namespace carom
