#pragma once
// Reads the viewers of a rig file and the eyes that its walls show, and checks that everybody sees every
// screen with both eyes.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/rig/rig.h"
#include "app/rig/rig_walls.h"
#include "app/toml/toml_file.h"

namespace carom {

/// The most tables [[viewer]] of a file that are read, to say that there are more than kMostViewers.
inline constexpr std::size_t kMostNamedViewers = 100;

/// Returns the viewers' names, in their order.
std::vector<std::string> namesOf(const std::vector<ViewerSetup>& viewers);

/// Returns the viewers: those of [[viewer]], or the one of [head] and [hand]. `folder` is the rig's.
std::vector<ViewerSetup> readViewers(const TomlTable& root, const std::vector<TrackerSetup>& trackers,
                                     double unit_m, const std::filesystem::path& folder);

/// Reads whose eyes a wall shows. The wall's stereo mode must have been read.
void readEyes(const TomlTable& table, const std::vector<ViewerSetup>& viewers, Wall& wall);

/// Returns the rig with the viewer of that name, "" for the first, in the first's place and the other way
/// round, and with the walls alone that show this viewer's eyes; of a wall for several, the channel.
Rig rigFor(Rig rig, const std::string& viewer);

/// Returns in words what a viewer sees of each screen of the room: in which walls of the rig with which eyes,
/// or that nothing there is for them.
std::vector<std::string> sightsOf(const Rig& rig, std::size_t viewer);

/// Records faults of viewers and walls that do not fit: two viewers on one sensor, an eye twice on a screen,
/// a viewer without a screen or with one eye on it only.
void checkViewers(const TomlTable& root, const Rig& rig, const std::vector<WallText>& walls);

}  // namespace carom
