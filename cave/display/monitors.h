#pragma once
// The monitors of the X display, by RandR 1.5: the outputs that show something, and what `xrandr
// --setmonitor` has defined.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "cave/room/wall.h"

namespace carom {

struct Monitor {
  std::string name;  ///< of the output, such as "DP-1"
  glm::ivec2 position_px{0}, size_px{0};
  double rate_hz = 0.0;  ///< 0: unknown

  bool operator==(const Monitor&) const = default;
};

/// Returns the monitors of the display that Graphics has opened, the primary one first.
std::vector<Monitor> monitors();

/// Returns the names of monitors for a message, each with its number.
std::string namesOf(std::span<const Monitor> monitors);

/// A rectangle on the X screen.
struct ScreenPlace {
  glm::ivec2 position_px{0}, size_px{0};

  bool operator==(const ScreenPlace&) const = default;
};

/// Returns the monitors of a window. Throws std::runtime_error, which names the monitors there are, if one of
/// them is missing.
std::vector<Monitor> monitorsOf(const WindowPlacement& placement, std::span<const Monitor> monitors);

/// Returns where a window lies: its position counts from the upper left of the rectangle around its monitors,
/// and if it is fullscreen, it covers that rectangle. Throws as monitorsOf does.
ScreenPlace placeOf(const WindowPlacement& placement, std::span<const Monitor> monitors);

/// Returns the part of each monitor that a desktop leaves to windows, without its panels.
std::vector<ScreenPlace> workAreas(std::span<const Monitor> monitors);

/// Throws as monitorsOf does, for the windows of all these walls.
void checkMonitors(std::span<const Wall> walls, const std::optional<WindowPlacement>& oneWindow);

}  // namespace carom
