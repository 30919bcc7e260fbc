#include "app/rig/rig_walls.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <span>
#include <stdexcept>
#include <string_view>
#include <variant>

#include "app/toml/toml_values.h"
#include "cave/mesh_files/screen_file.h"
#include "cave/process/work_budget.h"
#include "cave/warps/warp_file.h"
#include "engine/text/log.h"

namespace carom {
namespace {

glm::ivec2 toPixels(const std::array<double, 2>& a) {
  return {static_cast<int>(a[0]), static_cast<int>(a[1])};
}

/// Reads a wall's window and, if it is shared, the wall's part of it.
void readWallWindow(const TomlTable& table, bool hasOneWindow, Wall& wall) {
  wall.window = readWindow(table);
  const auto part = table.table("viewport");
  if (!part) return;
  wall.viewport = Viewport{toPixels(part->numbers<2>("position")), toPixels(part->numbers<2>("size"))};
  if (hasOneWindow)
    table.fault("viewport", "a place inside the one window has no viewport of its own, expected none");
}

/// Returns the file that a wall's key names, or an empty path if it names none. `kinds` are the supported
/// extensions.
std::filesystem::path readWallFile(const TomlFile& file, const TomlTable& table, std::string_view key,
                                   std::span<const std::string_view> kinds) {
  if (!table.has(key)) return {};
  const InputKind usual = key == "blend" ? InputKind::blend : InputKind::warp;
  const InputKind kind = table.text(key).ends_with(".vwf") ? InputKind::screenGrid : usual;
  const std::filesystem::path found = file.existingFile(table, key, kind, Reach::anywhere);
  const std::string ending = found.extension().string();
  if (!found.empty() && std::find(kinds.begin(), kinds.end(), ending) == kinds.end()) {
    table.fault(key, fmt::format("{} is '{}', expected a file ending in {}", key, found.filename().string(),
                                 fmt::join(kinds, " or ")));
  }
  return found;
}

/// Reads the name of a warp mesh and checks that the mesh can be read; a fault gives the position in it.
std::filesystem::path readWallWarp(const TomlFile& file, const TomlTable& table, std::string_view key,
                                   const glm::ivec2& window_px) {
  const std::filesystem::path warp = readWallFile(file, table, key, kWarpEndings);
  if (std::find(kWarpEndings.begin(), kWarpEndings.end(), warp.extension().string()) == kWarpEndings.end())
    return warp;  // none, or has been reported
  constexpr std::uintmax_t kMostExamined = 32U << 20U;
  constexpr double kOfOne_s = 0.5;
  std::error_code failed;
  if (hasBudget() &&
      (std::filesystem::file_size(warp, failed) > kMostExamined || budgetLeft_s() < kOfOne_s)) {
    log::warn(
        fmt::format("{}:1:1: was not read here, which would take too long: whether it is whole is not known",
                    warp.string()));
    return warp;
  }
  try {
    readWarp(warp, glm::max(window_px, 1));
  } catch (const std::runtime_error& fault) {
    table.fault(key, fault.what());
  }
  return warp;
}

/// Reads the meshes of single colours, which come all three or not at all.
void readColourWarps(const TomlFile& file, const TomlTable& table, Wall& wall) {
  constexpr std::array<std::string_view, 3> kKeys{"warp_red", "warp_green", "warp_blue"};
  const bool any = table.has(kKeys[0]) || table.has(kKeys[1]) || table.has(kKeys[2]);
  for (std::size_t colour = 0; any && colour < kKeys.size(); ++colour) {
    wall.colourWarps[colour] = readWallWarp(file, table, kKeys[colour], wall.pixels);
    if (table.has(kKeys[colour])) continue;
    table.fault(
        table.place(),
        fmt::format("{} is missing: the meshes of the colours come all three or not at all", kKeys[colour]));
  }
  if (any && table.has("warp")) {
    table.fault("warp", "each colour has a mesh of its own, expected no warp for all of them");
  }
}

/// Reads how bright each colour of the projector's white is and how its light follows the code.
void readColours(const TomlTable& table, Wall& wall) {
  wall.gain = toVec3(table.numbers<3>("gain"));
  if (table.has("gamma")) wall.gamma = toVec3(table.numbers<3>("gamma"));
  const double weakest = std::min({wall.gain.x, wall.gain.y, wall.gain.z});
  if (weakest > wall.blackLevel) return;
  table.fault("gain",
              fmt::format("gain has {} for a colour whose black_level is {}, expected white above black",
                          weakest, wall.blackLevel));
}

/// Reads the settings of the projector's light, its mirroring and its latency.
void readLight(const TomlFile& file, const TomlTable& table, Wall& wall) {
  constexpr std::array<std::string_view, 6> kPictures{".png", ".jpg", ".jpeg", ".tif", ".tiff", ".vwf"};
  wall.blend = readWallFile(file, table, "blend", kPictures);
  wall.blackLevel = table.number("black_level");
  readColours(table, wall);
  wall.flip = static_cast<Flip>(table.choice("flip"));
  wall.displayLatency_s = table.number("display_latency_ms") * 1e-3;
}

/// Reads the settings of the projector, between the image and the screen.
void readProjector(const TomlFile& file, const TomlTable& table, Wall& wall) {
  wall.warp = readWallWarp(file, table, "warp", wall.pixels);
  readColourWarps(file, table, wall);
  readLight(file, table, wall);
}

/// Reads the corners of a flat wall.
void readCorners(const TomlTable& table, double unit_m, WallText& text) {
  const auto corner = [&](std::string_view key) { return toVec3(table.numbers<3>(key)) * unit_m; };
  text.wall.lowerLeft_m = corner("lower_left");
  text.wall.lowerRight_m = corner("lower_right");
  text.wall.upperLeft_m = corner("upper_left");
  if (table.has("upper_right")) text.upperRight_m = corner("upper_right");
  text.skewed = table.flag("skewed");
  if (!text.skewed) return;
  if (!text.upperRight_m)
    table.fault("skewed", "a skewed wall needs all four corners, expected upper_right beside it");
  for (const char* key : {"warp", "warp_red", "warp_green", "warp_blue"}) {
    if (!table.has(key)) continue;
    table.fault(
        key,
        "a warp mesh says where the picture goes, as the corners of a skewed wall do: expected one of "
        "them");
  }
}

/// Returns the file with the warp or the screen of a wall; empty if there is none.
std::filesystem::path measuredFileOf(const std::optional<ScreenText>& screen, const Wall& wall) {
  const auto* measured = screen ? std::get_if<MeasuredScreen>(&screen->shape) : nullptr;
  return measured ? measured->file : wall.warp;
}

}  // namespace

WindowPlacement readWindow(const TomlTable& table) {
  WindowPlacement window{.position_px = toPixels(table.numbers<2>("position")),
                         .size_px = toPixels(table.numbers<2>("size")),
                         .fullscreen = table.flag("fullscreen"),
                         .border = table.flag("border")};
  if (table.isNumber("monitor") || !table.has("monitor")) {
    window.monitor = table.integer("monitor");
  } else {
    for (PlacedText& name : table.oneOrMoreTexts("monitor")) window.monitorNames.push_back(name.text);
    if (window.monitorNames.empty())
      table.fault("monitor", "monitor names none, expected a number, a name or a list of names");
  }
  return window;
}

WallText readWall(const TomlFile& file, const TomlTable& table, const RoomAxes& axes, double unit_m,
                  bool hasOneWindow) {
  WallText text{table, {}, {}, false, readScreen(file, table, axes, unit_m)};
  if (!text.screen) readCorners(table, unit_m, text);
  Wall& wall = text.wall;
  wall.name = table.text("name");
  wall.pixels = toPixels(table.numbers<2>("pixels"));
  wall.node = table.integer("node");
  wall.stereo = static_cast<StereoMode>(table.choice("stereo"));
  wall.window.size_px = wall.pixels;
  const auto window = hasOneWindow ? table.requiredTable("window") : table.table("window");
  if (window) readWallWindow(*window, hasOneWindow, wall);
  if (text.screen && !text.screen->isSky())
    readLight(file, table, wall);
  else
    readProjector(file, table, wall);
  const std::filesystem::path places = measuredFileOf(text.screen, wall);
  if (wall.blend.empty() && !table.has("blend") && hasBlend(places)) wall.blend = places;
  return text;
}

void straighten(WallText& text) {
  if (!text.skewed) return;
  Wall& wall = text.wall;
  const AroundScreen found =
      around({wall.lowerLeft_m, wall.lowerRight_m, wall.upperLeft_m, *text.upperRight_m});
  if (!found.fault.empty()) return text.table.fault("upper_right", found.fault);
  wall.lowerLeft_m = found.lowerLeft_m;
  wall.lowerRight_m = found.lowerRight_m;
  wall.upperLeft_m = found.upperLeft_m;
  wall.skewed = found.screen;
  text.upperRight_m.reset();
}

WallPlaces placesOf(const TomlTable& table) {
  return {.wall = table.place(),
          .name = table.place("name"),
          .corner = table.place("upper_left"),
          .pixels = table.place("pixels"),
          .node = table.place("node"),
          .window = table.place("window"),
          .blend = table.place("blend")};
}

std::string_view toString(StereoMode mode) { return kStereoModes[static_cast<std::size_t>(mode)]; }

std::string_view toString(Flip flip) { return kFlips[static_cast<std::size_t>(flip)]; }

}  // namespace carom
