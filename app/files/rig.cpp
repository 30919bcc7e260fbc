#include "app/files/rig.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <span>
#include <stdexcept>
#include <string_view>

#include "app/files/toml_file.h"
#include "cave/room/rectangle.h"
#include "cave/room/warp_mesh.h"
#include "devices/setup/tracker_factory.h"

namespace carom {

namespace {

constexpr int kMostPixels = 16384;  // the largest texture of common GPUs
constexpr int kMostRanks = 4096;
constexpr int kMostSensors = 65535;

glm::dvec3 toVec3(const std::array<double, 3>& a) { return {a[0], a[1], a[2]}; }
glm::ivec2 toPixels(const std::array<double, 2>& a) {
  return {static_cast<int>(a[0]), static_cast<int>(a[1])};
}

double readUnit_m(const TomlTable& root) {
  constexpr std::array<std::string_view, 5> kNames{"mm", "cm", "in", "ft",
                                                   "m"};  // an unknown one stands for the smallest
  constexpr std::array<double, 5> kMetres{1e-3, 1e-2, 0.0254, 0.3048, 1.0};
  return kMetres[root.choice("unit", kNames)];
}

RoomAxes readAxes(const TomlTable& root) {
  constexpr std::array<std::string_view, 2> kNames{"x-right y-up z-back", "x-right y-forward z-up"};
  const std::array<RoomAxes, 2> axes{RoomAxes{.right = {1, 0, 0}, .up = {0, 1, 0}, .forward = {0, 0, -1}},
                                     RoomAxes{.right = {1, 0, 0}, .up = {0, 0, 1}, .forward = {0, 1, 0}}};
  return axes[root.choice("axes", kNames)];
}

/// { translation, rotation_deg }: turned about the fixed x, then y, then z axis, then moved.
Pose readPose(const TomlTable& parent, std::string_view key, double unit_m) {
  const auto table = parent.table(key);
  if (!table) return {};
  constexpr Range kTurn{.least = -360.0, .most = 360.0};
  const std::array<double, 3> none{0.0, 0.0, 0.0};
  const glm::dvec3 turn_rad = glm::radians(toVec3(table->numbers<3>("rotation_deg", kTurn, none)));
  const glm::dquat aboutX = glm::angleAxis(turn_rad.x, glm::dvec3(1, 0, 0));
  const glm::dquat aboutY = glm::angleAxis(turn_rad.y, glm::dvec3(0, 1, 0));
  const glm::dquat aboutZ = glm::angleAxis(turn_rad.z, glm::dvec3(0, 0, 1));
  return {toVec3(table->numbers<3>("translation", {}, none)) * unit_m, aboutZ * aboutY * aboutX};
}

/// In the order of StereoMode and of Flip.
constexpr std::array<std::string_view, 10> kStereoModes{
    "mono",       "left",     "right",      "quad-buffer",  "side-by-side",
    "top-bottom", "anaglyph", "interlaced", "checkerboard", "anaglyph-grey"};
constexpr std::array<std::string_view, 4> kFlips{"none", "horizontal", "vertical", "both"};

/// Where a tracker's samples come from.
std::filesystem::path readSource(const TomlFile& file, const TomlTable& table, TrackerKind kind,
                                 const RoomAxes& axes) {
  if (kind == TrackerKind::recorded) return file.existingFile(table, "source");
  if (kind == TrackerKind::simulated) {
    table.refuse("source", "has no meaning for a simulated tracker, expected none");
    return {};
  }
  if (kind == TrackerKind::spaceMouse && !table.has("source")) return {};  // the first that is plugged in
  const std::string source = table.text("source");
  if (source.empty()) return {};  // complained of already
  try {
    createTransport(kind, source, axes);
  } catch (const std::invalid_argument& wrong) {
    table.fault("source", wrong.what());
  }
  return source;
}

TrackerSetup readTracker(const TomlFile& file, const TomlTable& table, double unit_m, const RoomAxes& axes) {
  TrackerSetup tracker;
  tracker.name = table.text("name");
  tracker.kind = static_cast<TrackerKind>(table.choice("kind", kTrackerKinds));
  tracker.source = readSource(file, table, tracker.kind, axes);
  constexpr std::array<std::string_view, 2> kPersons{"moves", "still"};
  if (tracker.kind == TrackerKind::simulated) {
    tracker.still = table.choice("person", kPersons, 0) == 1;
  } else {
    table.refuse("person", "has a meaning for a simulated tracker alone, expected none");
  }
  constexpr Range kLatency_ms{.least = 0.0, .most = 1000.0};
  tracker.latency_s = table.number("latency_ms", kLatency_ms, 0.0) * 1e-3;
  tracker.roomFromTracker = readPose(table, "room_from_tracker", unit_m);
  return tracker;
}

/// The tracker that a key names, an index; beyond the last one where there is none of that name.
std::size_t readTrackerName(const TomlTable& table, std::string_view key,
                            const std::vector<TrackerSetup>& trackers) {
  const std::string name = table.text(key);
  const auto found = std::find_if(trackers.begin(), trackers.end(),
                                  [&](const auto& tracker) { return tracker.name == name; });
  if (found == trackers.end() && table.has(key) && !name.empty()) {
    std::vector<std::string> names;
    for (const TrackerSetup& tracker : trackers) names.push_back(tracker.name);
    table.fault(
        key, names.empty()
                 ? fmt::format("there is no tracker '{}', expected a [[tracker]] of that name", name)
                 : fmt::format("there is no tracker '{}', expected '{}'", name, fmt::join(names, "' or '")));
  }
  return static_cast<std::size_t>(found - trackers.begin());
}

/// `tracker` and `sensor` of the head or the hand.
SensorChoice readSensor(const TomlTable& table, const std::vector<TrackerSetup>& trackers) {
  return {.tracker = readTrackerName(table, "tracker", trackers),
          .sensor = table.integer("sensor", 0, kMostSensors, 0)};
}

HandSetup readHand(const TomlTable& table, const std::vector<TrackerSetup>& trackers, double unit_m) {
  HandSetup hand{readSensor(table, trackers), readPose(table, "hand_from_sensor", unit_m)};
  if (!table.has("buttons")) return hand;
  const auto isSpaceMouse = [&](std::size_t tracker) {
    return tracker < trackers.size() && trackers[tracker].kind == TrackerKind::spaceMouse;
  };
  const std::size_t buttons = readTrackerName(table, "buttons", trackers);
  if (isSpaceMouse(buttons)) {
    table.fault("buttons", "a spacemouse steers and holds no cue, expected a tracker with buttons of a hand");
  } else if (isSpaceMouse(hand.tracker)) {
    table.fault("buttons", "a hand on a spacemouse has no place to hold a cue in, expected no buttons");
  }
  if (buttons != hand.tracker) hand.buttons = buttons;
  return hand;
}

HeadSetup readHead(const TomlTable& table, const std::vector<TrackerSetup>& trackers, double unit_m) {
  HeadSetup head;
  constexpr double kWidestEyes_m = 1.0;
  head.sensor = readSensor(table, trackers);
  if (head.sensor.tracker < trackers.size() &&
      trackers[head.sensor.tracker].kind == TrackerKind::spaceMouse) {
    table.fault("tracker", "a spacemouse sends no poses, expected a tracker that does");
  }
  const Range range{.least = 0.0, .most = kWidestEyes_m / unit_m};
  head.eyeSeparation_m = table.number("eye_separation", range, head.eyeSeparation_m / unit_m) * unit_m;
  head.eyesFromSensor = readPose(table, "eyes_from_sensor", unit_m);
  return head;
}

constexpr Range kPlace_px{.least = -65536.0, .most = 65536.0};
constexpr Range kSize_px{.least = 1.0, .most = kMostPixels};

WindowPlacement readWindow(const TomlTable& table) {
  return {.monitor = table.integer("monitor", 0, 63, 0),
          .position_px = toPixels(table.wholeNumbers<2>("position", kPlace_px, {{0.0, 0.0}})),
          .size_px = toPixels(table.wholeNumbers<2>("size", kSize_px)),
          .fullscreen = table.flag("fullscreen", false)};
}

/// A wall's window, and its part of it where it shares one.
void readWallWindow(const TomlTable& table, bool hasOneWindow, Wall& wall) {
  wall.window = readWindow(table);
  const auto part = table.table("viewport");
  if (!part) return;
  wall.viewport = Viewport{toPixels(part->wholeNumbers<2>("position", kPlace_px, {{0.0, 0.0}})),
                           toPixels(part->wholeNumbers<2>("size", kSize_px))};
  if (hasOneWindow)
    table.fault("viewport", "a place inside the one window has no viewport of its own, expected none");
}

/// Complains where the three or four corners are no rectangle.
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

/// A wall as the file gives it, before its corners are checked.
struct WallText {
  TomlTable table;
  Wall wall;
  std::optional<glm::dvec3> upperRight_m;
};

/// The file that a wall's key names, empty where it names none. `kinds` are the endings that can be read.
std::filesystem::path readWallFile(const TomlFile& file, const TomlTable& table, std::string_view key,
                                   std::span<const std::string_view> kinds) {
  if (!table.has(key)) return {};
  const std::filesystem::path found = file.existingFile(table, key);
  const std::string ending = found.extension().string();
  if (!found.empty() && std::find(kinds.begin(), kinds.end(), ending) == kinds.end()) {
    table.fault(key, fmt::format("{} is '{}', expected a file ending in {}", key, found.filename().string(),
                                 fmt::join(kinds, " or ")));
  }
  return found;
}

/// A file that is no such mesh is named with the place in it.
void checkWarp(const TomlTable& table, const std::filesystem::path& warp) {
  if (warp.extension() != ".pfm" && warp.extension() != ".obj") return;  // none, or complained of already
  try {
    readWarp(warp);
  } catch (const std::runtime_error& fault) {
    table.fault("warp", fault.what());
  }
}

/// What stands between the picture and the screen: the projector.
void readProjector(const TomlFile& file, const TomlTable& table, Wall& wall) {
  constexpr std::array<std::string_view, 2> kMeshes{".pfm", ".obj"};
  constexpr std::array<std::string_view, 5> kPictures{".png", ".jpg", ".jpeg", ".tif", ".tiff"};
  constexpr Range kLevel{.least = 0.0, .most = 1.0};
  constexpr Range kLatency_ms{.least = 0.0, .most = 1000.0};
  wall.warp = readWallFile(file, table, "warp", kMeshes);
  checkWarp(table, wall.warp);
  wall.blend = readWallFile(file, table, "blend", kPictures);
  wall.blackLevel = table.number("black_level", kLevel, 0.0);
  wall.flip = static_cast<Flip>(table.choice("flip", kFlips, 0));
  wall.displayLatency_s = table.number("display_latency_ms", kLatency_ms, 0.0) * 1e-3;
}

WallText readWall(const TomlFile& file, const TomlTable& table, double unit_m, bool hasOneWindow) {
  constexpr Range kPixels{.least = 1.0, .most = kMostPixels};
  Wall wall;
  wall.name = table.text("name");
  wall.lowerLeft_m = toVec3(table.numbers<3>("lower_left", {})) * unit_m;
  wall.lowerRight_m = toVec3(table.numbers<3>("lower_right", {})) * unit_m;
  wall.upperLeft_m = toVec3(table.numbers<3>("upper_left", {})) * unit_m;
  std::optional<glm::dvec3> upperRight_m;
  if (table.has("upper_right")) upperRight_m = toVec3(table.numbers<3>("upper_right", {})) * unit_m;
  wall.pixels = toPixels(table.wholeNumbers<2>("pixels", kPixels));
  wall.node = table.integer("node", 0, kMostRanks, 0);
  wall.stereo = static_cast<StereoMode>(table.choice("stereo", kStereoModes, 0));
  wall.window.size_px = wall.pixels;
  const auto window = hasOneWindow ? table.requiredTable("window") : table.table("window");
  if (window) readWallWindow(*window, hasOneWindow, wall);
  readProjector(file, table, wall);
  return {table, wall, upperRight_m};
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

/// File names of captured pictures are made of it.
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

/// A wall's part of a window that it shares, with the window.
struct SharedPlace {
  WindowPlacement window;
  Viewport part;
};

std::optional<SharedPlace> sharedPlaceOf(const Rig& rig, const Wall& wall) {
  if (rig.oneWindow) return SharedPlace{*rig.oneWindow, {wall.window.position_px, wall.window.size_px}};
  if (wall.viewport) return SharedPlace{wall.window, *wall.viewport};
  return {};
}

/// Walls that share a window have each their own place inside.
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

/// Light should leave all walls together, that of the slowest. The others' pictures wait for it, by whole
/// frames: what is left is half a frame at most.
void holdBackTheFast(Rig& rig, const std::vector<TomlTable>& tables) {
  constexpr double kMostHeld_s = 0.1;  // pictures take memory; displays that differ by more are mistaken
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

/// What can be checked once every value by itself is right.
void checkTogether(const TomlTable& root, const Rig& rig, const std::vector<WallText>& walls) {
  checkUnique(root.tables("tracker"), "name", rig.trackers, [](const TrackerSetup& t) { return t.name; });
  checkUnique(root.tables("node"), "rank", rig.nodes, [](const NodeSetup& node) { return node.rank; });
  const std::vector<TomlTable> tables = root.tables("wall");
  checkUnique(tables, "name", rig.walls, [](const Wall& wall) { return wall.name; });
  for (const WallText& text : walls) {
    checkWallName(text.table, text.wall.name);
    checkRectangle(text.table, text.wall, text.upperRight_m);
  }
  checkPlaces(rig, tables);
}

PlacedRig readPlacedRig(const TomlFile& file, const std::string& name) {
  const TomlTable& root = file.root();
  PlacedRig placed;
  const double unit_m = placed.unit_m = readUnit_m(root);
  Rig& rig = placed.rig;
  rig.title = root.text("title", name);
  rig.axes = readAxes(root);
  constexpr Range kDisplay_hz{.least = 1.0, .most = 1000.0};
  rig.display_hz = root.number("display_hz", kDisplay_hz, rig.display_hz);
  rig.frameLock = static_cast<FrameLock>(root.choice("frame_lock", kFrameLocks, 0));
  for (const TomlTable& table : root.tables("tracker"))
    rig.trackers.push_back(readTracker(file, table, unit_m, rig.axes));
  if (const auto head = root.requiredTable("head")) {
    rig.head = readHead(*head, rig.trackers, unit_m);
    placed.head = head->place();
    placed.eyeSeparation = head->place("eye_separation");
  }
  if (const auto hand = root.table("hand")) rig.hand = readHand(*hand, rig.trackers, unit_m);
  for (const TomlTable& table : root.tables("node")) {
    rig.nodes.push_back({.rank = table.integer("rank", 0, kMostRanks), .display = table.text("display")});
    placed.nodes.push_back(table.place());
  }
  if (const auto window = root.table("one_window")) rig.oneWindow = readWindow(*window);
  if (const auto console = root.table("console")) {
    if (const auto window = console->requiredTable("window")) rig.console = readWindow(*window);
  }

  std::vector<WallText> walls;
  for (const TomlTable& table : root.tables("wall")) {
    walls.push_back(readWall(file, table, unit_m, rig.oneWindow.has_value()));
    rig.walls.push_back(walls.back().wall);
    placed.walls.push_back(placesOf(table));
  }
  if (walls.empty()) root.fault("wall", "there is no wall here, expected one [[wall]] at least");
  file.throwFaults();
  if (rig.hand && rig.hand->buttons && *rig.hand->buttons != rig.head.sensor.tracker)
    rig.trackers[*rig.hand->buttons].buttonsAlone = true;
  checkTogether(root, rig, walls);
  holdBackTheFast(rig, root.tables("wall"));
  file.throwFaults();
  return placed;
}

}  // namespace

std::string_view toString(StereoMode mode) { return kStereoModes[static_cast<std::size_t>(mode)]; }

std::string_view toString(Flip flip) { return kFlips[static_cast<std::size_t>(flip)]; }

RoomGeometry roomGeometryOf(const Rig& rig) {
  return {rig.walls, rig.axes.up, rig.axes.forward, inverse(rig.head.eyesFromSensor)};
}

std::string displayOf(const Rig& rig, int rank) {
  for (const NodeSetup& node : rig.nodes) {
    if (node.rank == rank) return node.display;
  }
  return {};
}

Rig readRig(const std::filesystem::path& path) { return readPlacedRig(path).rig; }

Rig readRig(const std::filesystem::path& path, const std::string& kept) {
  return readPlacedRig(TomlFile(path, kept), path.stem().string()).rig;
}

PlacedRig readPlacedRig(const std::filesystem::path& path) {
  return readPlacedRig(TomlFile(path), path.stem().string());
}

}  // namespace carom
