#pragma once
// Reads the trackers of a rig file and their use for head and hand.

#include <string_view>
#include <vector>

#include "app/rig/rig.h"
#include "app/toml/toml_file.h"

namespace carom {

/// `unit_m` is the file's unit of length.
TrackerSetup readTracker(const TomlFile& file, const TomlTable& table, double unit_m, const RoomAxes& axes);
HandSetup readHand(const TomlTable& table, const std::vector<TrackerSetup>& trackers, double unit_m);
HeadSetup readHead(const TomlTable& table, const std::vector<TrackerSetup>& trackers, double unit_m);

/// Reads [hand.force]; none if the hand has none.
std::optional<ForceSetup> readForce(const TomlTable& hand, double unit_m);

/// Lets hands that name no tracker be followed by their force devices, where these say where they are: the
/// device of a VRPN server is a tracker, too.
void followForceDevices(Rig& rig);

}  // namespace carom
