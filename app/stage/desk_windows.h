#pragma once
// The windows of rank 0 that have a border: those of a desk's walls, the console, the view from outside and
// the diagram. They open beside one another, and where they lay last.

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/rig/rig.h"
#include "app/stage/window_memory.h"
#include "cave/display/monitors.h"
#include "cave/room/wall.h"

namespace carom {

/// Which windows a session opens besides those of the walls.
struct ExtraWindows {
  bool console = false, outside = false, diagram = false;
};

/// Where they open; empty for those that do not.
struct DeskWindows {
  std::optional<WindowPlacement> console, outside, diagram;
  bool consoleWaits = false;  ///< out of sight: there is no room for it beside the walls
};

/// Returns where the windows open on these monitors, and moves those of the rig's walls that have a border
/// and stand alone; `walls` are those that this rank draws. A place that the rig gives to the console goes
/// before the remembered one. The console waits out of sight where it would leave a wall's window less than
/// half of its width. Logs a warning for another window for which there is no room: it opens over the others.
DeskWindows placeWindows(Rig& rig, std::span<const Wall> walls, const ExtraWindows& extra,
                         const std::vector<RememberedWindow>& remembered, std::span<const Monitor> monitors,
                         std::span<const ScreenPlace> areas);

/// Returns the file that remembers the windows; empty if the user has no home.
std::filesystem::path windowMemory();

/// Returns the name under which the window of a wall is remembered: with the place that its rig gives it, so
/// that another rig, or another place in the same one, is another window.
std::string memoryName(const Wall& wall);

/// Returns the remembered place of a window that lies here; nothing if it is on no monitor.
std::optional<RememberedWindow> remember(const std::string& name, const ScreenPlace& place,
                                         std::span<const Monitor> monitors);

}  // namespace carom
