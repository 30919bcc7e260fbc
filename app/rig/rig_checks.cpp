#include "app/rig/rig_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "app/rig/rig_nodes.h"
#include "cave/room/rectangle.h"

namespace carom {
namespace {

/// Records a fault if the three or four corners are not those of a rectangle.
void checkRectangle(const TomlTable& table, const Wall& wall, const std::optional<glm::dvec3>& upperRight_m) {
  const ThreeCorners corners{{wall.lowerRight_m, wall.lowerLeft_m, wall.upperLeft_m},
                             {"lower_right", "lower_left", "upper_left"}};
  if (const auto fault = rectangleFault(wall.name, corners)) {
    return table.fault(corners.names[fault->corner], fault->what);
  }
  if (!upperRight_m) return;
  const glm::dvec3 expected_m = wall.lowerRight_m + wall.upperLeft_m - wall.lowerLeft_m;
  const double fourthMiss_m = glm::distance(*upperRight_m, expected_m);
  if (!(fourthMiss_m <= kCornerMiss_m)) {
    table.fault("upper_right",
                fmt::format("upper_right of wall '{}' is {:.1f} mm from where the other corners put it, "
                            "expected at most {:.0f} mm",
                            wall.name, fourthMiss_m * 1e3, kCornerMiss_m * 1e3));
  }
}

/// Checks a wall's name, which is used in the file names of captured images.
void checkWallName(const TomlTable& table, const std::string& name) {
  const bool plain = std::all_of(name.begin(), name.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
  });
  if (!plain) table.fault("name", fmt::format("name is '{}', expected letters, digits, - and _ only", name));
}

template <class Named>
void checkUnique(const std::vector<TomlTable>& tables, std::string_view key, const std::vector<Named>& items,
                 const auto& valueOf) {
  for (std::size_t i = 0; i < items.size(); ++i) {
    const auto taken = std::find_if(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(i),
                                    [&](const Named& item) { return valueOf(item) == valueOf(items[i]); });
    if (taken == items.begin() + static_cast<std::ptrdiff_t>(i)) continue;
    const auto first = static_cast<std::size_t>(taken - items.begin());
    tables[i].fault(key, fmt::format("the {} '{}' is taken in line {}, expected another", key,
                                     valueOf(items[i]), tables[first].place(key).line));
  }
}

bool meet(const Viewport& a, const Viewport& b) {
  const glm::ivec2 low = glm::max(a.position_px, b.position_px);
  const glm::ivec2 high = glm::min(a.position_px + a.size_px, b.position_px + b.size_px);
  return low.x < high.x && low.y < high.y;
}

/// A shared window and a wall's part of it.
struct SharedPlace {
  WindowPlacement window;
  Viewport part;
};

std::optional<SharedPlace> sharedPlaceOf(const Rig& rig, const Wall& wall) {
  if (rig.oneWindow) return SharedPlace{*rig.oneWindow, {wall.window.position_px, wall.window.size_px}};
  if (wall.viewport) return SharedPlace{wall.window, *wall.viewport};
  return {};
}

/// Checks that walls that share a window have separate parts of it.
void checkPlaces(const Rig& rig, const std::vector<TomlTable>& tables) {
  const char* window = rig.oneWindow ? "the one window" : "their window";
  for (std::size_t i = 0; i < rig.walls.size(); ++i) {
    const auto place = sharedPlaceOf(rig, rig.walls[i]);
    if (!place) continue;
    const glm::ivec2 low = place->part.position_px, high = low + place->part.size_px,
                     size = place->window.size_px;
    const auto complain = [&](const std::string& what) { tables[i].fault("window", what); };
    if (low.x < 0 || low.y < 0 || high.x > size.x || high.y > size.y) {
      complain(fmt::format("wall '{}' reaches out of {}, expected a place within {} × {} pixels",
                           rig.walls[i].name, rig.oneWindow ? window : "its window", size.x, size.y));
    }
    if (rig.oneWindow && rig.walls[i].window.fullscreen)
      complain("a place inside the one window cannot be fullscreen, expected false");
    for (std::size_t j = 0; j < i; ++j) {
      const auto other = sharedPlaceOf(rig, rig.walls[j]);
      if (!other || rig.walls[j].node != rig.walls[i].node || other->window != place->window ||
          !meet(place->part, other->part))
        continue;
      complain(fmt::format("walls '{}' and '{}' overlap in {}, expected places apart", rig.walls[j].name,
                           rig.walls[i].name, window));
    }
  }
}

}  // namespace

void checkTogether(const TomlTable& root, const Rig& rig, const std::vector<WallText>& walls) {
  checkUnique(root.tables("tracker"), "name", rig.trackers, [](const TrackerSetup& t) { return t.name; });
  checkNodes(rig.nodes, root.tables("node"));
  const std::vector<TomlTable> tables = root.tables("wall");
  checkUnique(tables, "name", rig.walls, [](const Wall& wall) { return wall.name; });
  for (const WallText& text : walls) {
    checkWallName(text.table, text.wall.name);
    if (!text.screen) checkRectangle(text.table, text.wall, text.upperRight_m);
  }
  checkPlaces(rig, tables);
}

void holdBackTheFast(Rig& rig, const std::vector<TomlTable>& tables) {
  // Buffered images take memory; a larger difference between displays is a mistake.
  constexpr double kMostHeld_s = 0.1;
  for (const Wall& wall : rig.walls)
    rig.displayLatency_s = std::max(rig.displayLatency_s, wall.displayLatency_s);
  for (std::size_t i = 0; i < rig.walls.size(); ++i) {
    Wall& wall = rig.walls[i];
    const double ahead_s = rig.displayLatency_s - wall.displayLatency_s;
    wall.heldFrames = static_cast<std::size_t>(std::lround(ahead_s * rig.display_hz));
    if (ahead_s <= kMostHeld_s) continue;
    tables[i].fault(
        "display_latency_ms",
        fmt::format("wall '{}' is {:.1f} ms faster than the slowest wall, expected at most {:.0f} "
                    "ms between the walls of a room",
                    wall.name, ahead_s * 1e3, kMostHeld_s * 1e3));
  }
}

std::optional<RoomBox> boxOf(const Rig& rig) {
  std::optional<RoomBox> box;
  for (const Wall& wall : standingWalls(rig)) {
    for (const Vec3& corner_m : {wall.lowerLeft_m, wall.lowerRight_m, wall.upperLeft_m,
                                 wall.lowerRight_m + wall.upperLeft_m - wall.lowerLeft_m}) {
      if (!box) box = {corner_m, corner_m};
      box = {glm::min(box->low_m, corner_m), glm::max(box->high_m, corner_m)};
    }
  }
  return box;
}

// The person stands about the origin, also where a single wall is all that there is.
std::optional<std::string> warningOf(const SpacetimeSetup& setup, const Rig& rig) {
  constexpr double kAround_m = 1.5;
  const std::optional<RoomBox> box = boxOf(rig);
  if (!setup.place_m || !box) return {};
  const Vec3 place_m = *setup.place_m, low_m = glm::min(box->low_m, Vec3(-kAround_m)),
             high_m = glm::max(box->high_m, Vec3(kAround_m));
  if (glm::clamp(place_m, low_m, high_m) == place_m) return {};
  return fmt::format(
      "[spacetime] place = [{:.4g}, {:.4g}, {:.4g}] m lies outside the room: nobody can walk round it, "
      "expected a place between [{:.4g}, {:.4g}, {:.4g}] and [{:.4g}, {:.4g}, {:.4g}] m",
      place_m.x, place_m.y, place_m.z, low_m.x, low_m.y, low_m.z, high_m.x, high_m.y, high_m.z);
}

}  // namespace carom
