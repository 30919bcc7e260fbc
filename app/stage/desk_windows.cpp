#include "app/stage/desk_windows.h"

#include <fmt/format.h>

#include <algorithm>

#include <glm/common.hpp>

#include "cave/display/window_layout.h"
#include "engine/text/log.h"

namespace carom {
namespace {

constexpr glm::ivec2 kConsole_px{1280, 1000}, kLeastConsole_px{800, 620};
constexpr glm::ivec2 kOutside_px{1440, 900}, kDiagram_px{1000, 820}, kLeastView_px{320, 220},
    kLeastDiagram_px{480, 320};
constexpr glm::ivec2 kLeastWall_px{200, 120};
constexpr double kLeastShare = 0.5;  // of its width that a wall's window keeps beside the console

/// Returns whether the wall has a window of its own that the user may move.
bool isMovable(const Wall& wall) {
  return wall.window.border && !wall.window.fullscreen && !wall.viewport.has_value();
}

/// Returns whether the other rank, too, draws on rank 0's display, as far as the rig says.
bool sharesDisplay(const Rig& rig, int rank) {
  const bool hasHosts = std::any_of(rig.nodes.begin(), rig.nodes.end(),
                                    [](const NodeSetup& node) { return !node.host.empty(); });
  return !hasHosts && displayOf(rig, rank) == displayOf(rig, 0);
}

/// Returns where a window stands, or nothing if its monitor is not there.
std::optional<ScreenPlace> placeIfThere(const WindowPlacement& window,
                                        std::span<const Monitor> monitors) try {
  return placeOf(window, monitors);
} catch (const std::exception&) {
  return {};
}

/// Returns a placement with a border at this place, on the first of the monitors.
WindowPlacement placementAt(const ScreenPlace& place, std::span<const Monitor> monitors) {
  return {.position_px = place.position_px - monitors.front().position_px,
          .size_px = place.size_px,
          .border = true};
}

std::optional<ScreenPlace> rememberedPlace(const std::string& name,
                                           const std::vector<RememberedWindow>& remembered,
                                           std::span<const Monitor> monitors) {
  for (const RememberedWindow& window : remembered) {
    if (window.name != name) continue;
    const auto monitor = std::find_if(monitors.begin(), monitors.end(),
                                      [&](const Monitor& there) { return there.name == window.monitor; });
    if (monitor == monitors.end()) return {};
    return ScreenPlace{monitor->position_px + glm::ivec2(window.position[0], window.position[1]),
                       {window.size[0], window.size[1]}};
  }
  return {};
}

/// The windows to be placed, and what takes each place in the end.
class Placing {
 public:
  Placing(const std::vector<RememberedWindow>& remembered, std::span<const Monitor> monitors)
      : remembered_(remembered), monitors_(monitors) {}

  void add(const std::string& name, const FreeWindow& window) {
    windows_.push_back(window);
    names_.push_back(name);
    if (const auto place = rememberedPlace(name, remembered_, monitors_)) windows_.back().at = place;
  }

  std::size_t count() const { return windows_.size(); }

  /// Returns whether the last of these windows leaves those before it, from the first to this one, their
  /// place.
  bool leavesRoom(std::size_t first, std::span<const ScreenPlace> taken,
                  std::span<const ScreenPlace> areas) const {
    const std::vector<std::optional<ScreenPlace>> found = arranged(windows_, taken, areas);
    for (std::size_t i = 0; i < first && i < found.size(); ++i) {
      const glm::ivec2& wanted_px = windows_[i].at ? windows_[i].at->size_px : windows_[i].wanted_px;
      if (!found[i] || found[i]->size_px.x < kLeastShare * wanted_px.x) return false;
    }
    return found.back().has_value();
  }

  /// Takes the last window out again. Returns where it lies over the others.
  WindowPlacement takeBack(std::span<const ScreenPlace> areas) {
    const WindowPlacement place = over(windows_.size() - 1, areas);
    windows_.pop_back();
    names_.pop_back();
    return place;
  }

  /// Returns the places, in the order in which the windows were added.
  std::vector<WindowPlacement> places(std::span<const ScreenPlace> taken,
                                      std::span<const ScreenPlace> areas) const {
    const std::vector<std::optional<ScreenPlace>> found = arranged(windows_, taken, areas);
    std::vector<WindowPlacement> result;
    for (std::size_t i = 0; i < found.size(); ++i) {
      if (!found[i]) {
        log::warn(fmt::format("There is no room for the window \"{}\" beside the others: it opens over them.",
                              names_[i]));
      }
      result.push_back(found[i] ? placementAt(*found[i], monitors_) : over(i, areas));
    }
    return result;
  }

 private:
  WindowPlacement over(std::size_t window, std::span<const ScreenPlace> areas) const {
    const ScreenPlace& area = areas.front();
    const glm::ivec2 corner(kEdge_px, kTitle_px);
    const glm::ivec2 most_px = area.size_px - corner - glm::ivec2(kEdge_px);
    return placementAt({area.position_px + corner, glm::min(windows_[window].wanted_px, most_px)}, monitors_);
  }

  const std::vector<RememberedWindow>& remembered_;
  std::span<const Monitor> monitors_;
  std::vector<FreeWindow> windows_;
  std::vector<std::string> names_;
};

}  // namespace

std::filesystem::path windowMemory() {
  const std::filesystem::path folder = userFolder();
  return folder.empty() ? folder : folder / "windows.toml";
}

std::string memoryName(const Wall& wall) {
  const WindowPlacement& window = wall.window;
  return fmt::format("wall {} {}x{}+{}+{}", wall.name, window.size_px.x, window.size_px.y,
                     window.position_px.x, window.position_px.y);
}

DeskWindows placeWindows(Rig& rig, std::span<const Wall> walls, const ExtraWindows& extra,
                         const std::vector<RememberedWindow>& remembered, std::span<const Monitor> monitors,
                         std::span<const ScreenPlace> areas) {
  std::vector<ScreenPlace> taken;
  if (rig.oneWindow) taken.push_back(placeOf(*rig.oneWindow, monitors));
  Placing placing(remembered, monitors);
  std::vector<Wall*> moved;
  for (Wall& wall : rig.walls) {
    const bool isDrawn =
        std::any_of(walls.begin(), walls.end(), [&](const Wall& drawn) { return drawn.name == wall.name; });
    if (rig.oneWindow || (!isDrawn && !sharesDisplay(rig, wall.node))) continue;
    if (!isDrawn) {  // by another rank, perhaps of another computer
      if (const auto there = placeIfThere(wall.window, monitors)) taken.push_back(*there);
      continue;
    }
    const ScreenPlace place = placeOf(wall.window, monitors);
    if (!isMovable(wall)) {
      taken.push_back(place);
      continue;
    }
    placing.add(memoryName(wall), {wall.window.size_px, kLeastWall_px, place, true});
    moved.push_back(&wall);
  }
  const auto add = [&](bool wanted, const char* name, const FreeWindow& window) {
    if (wanted) placing.add(name, window);
  };
  if (extra.console && rig.console) taken.push_back(placeOf(*rig.console, monitors));
  DeskWindows desk;
  bool isPlaced = extra.console && !rig.console;
  add(isPlaced, "console", {kConsole_px, kLeastConsole_px});
  if (isPlaced && !placing.leavesRoom(moved.size(), taken, areas)) {
    desk.console = placing.takeBack(areas);
    desk.consoleWaits = true;
    isPlaced = false;
    log::note("There is no room for the console beside the walls: F10 shows it.");
  }
  add(extra.outside, "outside", {kOutside_px, kLeastView_px});
  add(extra.diagram, "diagram", {kDiagram_px, kLeastDiagram_px});
  const std::vector<WindowPlacement> places = placing.places(taken, areas);
  auto next = places.begin();
  for (Wall* wall : moved) wall->window = *next++;
  if (isPlaced) desk.console = *next++;
  if (extra.console && rig.console) desk.console = *rig.console;
  if (extra.outside) desk.outside = *next++;
  if (extra.diagram) desk.diagram = *next++;
  return desk;
}

std::optional<RememberedWindow> remember(const std::string& name, const ScreenPlace& place,
                                         std::span<const Monitor> monitors) {
  for (const Monitor& monitor : monitors) {
    const glm::ivec2 at = place.position_px - monitor.position_px, end = at + place.size_px;
    if (at.x < 0 || at.y < 0 || end.x > monitor.size_px.x || end.y > monitor.size_px.y) continue;
    return RememberedWindow{name, monitor.name, {at.x, at.y}, {place.size_px.x, place.size_px.y}};
  }
  return {};
}

}  // namespace carom
