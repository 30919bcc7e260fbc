#include "app/cave_formats/hevs_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <string_view>

#include "app/cave_formats/hevs_inheritance.h"
#include "app/cave_formats/hevs_screen.h"
#include "app/cave_formats/hevs_trackers.h"
#include "app/room_checks/foreign_room.h"
#include "app/room_parts/room_parts.h"

namespace carom {
namespace {

constexpr double kEyeSeparation_m = 0.065;  // HEVS's default
constexpr glm::ivec2 kAssumedWindow_px{1920, 1080};
constexpr std::array<std::string_view, 10> kQuietHevs{
    "index", "globals", "type", "cluster", "layers", "cull_layers", "fov", "near", "far", "hardware_synced"};

struct HevsStereo {
  std::string_view name;
  StereoMode mode;
  std::string_view differs;
};
constexpr std::array<HevsStereo, 16> kHevsStereo{{
    {"mono", StereoMode::mono, ""},
    {"leftonly", StereoMode::left, ""},
    {"rightonly", StereoMode::right, ""},
    {"sidebyside", StereoMode::sideBySide, ""},
    {"topbottom", StereoMode::topBottom, ""},
    {"quadbuffered", StereoMode::quadBuffer, ""},
    {"sequential", StereoMode::quadBuffer, "it becomes quad-buffer"},
    {"redcyan", StereoMode::anaglyph, ""},
    {"redblue", StereoMode::anaglyph, "it is shown in red and cyan"},
    {"redgreen", StereoMode::anaglyph, "it is shown in red and cyan"},
    {"sidebysidemono", StereoMode::mono, "one picture fills the window"},
    {"topbottommono", StereoMode::mono, "one picture fills the window"},
    {"sidebysideleftonly", StereoMode::left, "one picture fills the window"},
    {"topbottomleftonly", StereoMode::left, "one picture fills the window"},
    {"sidebysiderightonly", StereoMode::right, "one picture fills the window"},
    {"topbottomrightonly", StereoMode::right, "one picture fills the window"},
}};

StereoMode modeOf(const Part& text, Room& room) {
  for (const HevsStereo& stereo : kHevsStereo) {
    if (!alike(text.text, stereo.name)) continue;
    if (!stereo.differs.empty()) {
      addWarning(room, text.textAt,
                 fmt::format("stereo mode '{}' is not known here: {}", printable(text.text), stereo.differs));
    }
    return stereo.mode;
  }
  addWarning(room, text.textAt,
             fmt::format("stereo mode '{}' is not known here: mono is taken", printable(text.text)));
  return StereoMode::mono;
}

/// The node whose displays are read.
struct HevsNode {
  const Part& part;
  WindowPlacement window;
  bool sizeGiven = false;
};

/// Returns a corner of a display in the room, whose z is back, from one with z forward.
std::optional<glm::dvec3> cornerOf(const Part& display, std::string_view name, const Pose& place,
                                   Room& room) {
  const Part* part = display.find(name);
  if (!part) {
    addError(
        room, display.at,
        fmt::format("{} is missing in display '{}', expected ul, ll and lr", name, printable(display.name)));
    return {};
  }
  const auto values = arrayOf(*part, 3, room);
  if (!values) return {};
  return place * glm::dvec3((*values)[0], (*values)[1], -(*values)[2]);
}

std::string hevsHost(const Part& node) {
  const Part* address = node.find("address");
  const std::string host = address ? address->text : node.name;
  return host == "localhost" || host == "127.0.0.1" ? "" : host;
}

/// Viewports are shares of the window, or pixels where a number is above 1, from its lower left, as Unity
/// takes them (Camera.rect).
void placeDisplay(const Part& display, const Part& platform, const WindowPlacement& window, RoomWall& wall,
                  Room& room) {
  const Part* name = display.find("viewport");
  const Part* viewports = platform.find("viewports");
  const Part* viewport = name && viewports ? viewports->find(name->text) : nullptr;
  if (name && !viewport)
    addError(room, name->textAt, fmt::format("there is no viewport '{}'", printable(name->text)));
  if (!viewport) return placeInWindow(window, {0, 0}, window.size_px, wall, room);
  wall.at.pixels = viewport->at;
  viewport->find("absolute");
  constexpr Range kPlace{.least = 0.0, .most = kMostRoomPixels};
  std::array<double, 4> values{};
  constexpr std::array<std::string_view, 4> kNames{"x", "y", "width", "height"};
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!viewport->find(kNames[i]))
      addError(room, viewport->at, fmt::format("{} is missing in viewport", kNames[i]));
    values[i] = number(*viewport, kNames[i], kPlace, false, room).value_or(i < 2 ? 0.0 : 1.0);
  }
  const bool isShare = std::all_of(values.begin(), values.end(), [](double value) { return value <= 1.0; });
  const glm::dvec2 scale = isShare ? glm::dvec2(window.size_px) : glm::dvec2(1.0);
  const glm::dvec2 low = glm::dvec2(values[0], values[1]) * scale;
  const glm::ivec2 low_px(glm::round(low));
  const glm::ivec2 high_px(glm::round(low + glm::dvec2(values[2], values[3]) * scale));
  placeInWindow(window, {low_px.x, window.size_px.y - high_px.y}, glm::max(high_px - low_px, glm::ivec2(1)),
                wall, room);
}

/// Reads a platform.
class HevsPlatform {
 public:
  HevsPlatform(const Part& platform, Room& room) : platform_(platform), room_(room), ranks_(room) {}

  void read() {
    readStereo();
    readPeople();
    const Part* nodes = platform_.find("nodes");
    const std::string master = masterName();
    if (nodes) {
      for (const Part& node : nodes->parts) {
        if (node.name == master) readNode(node);
      }
      for (const Part& node : nodes->parts) {
        if (node.name != master) readNode(node);
      }
    }
    ranks_.finish();
    nameUnused();
  }

 private:
  std::string masterName() const {
    const Part* cluster = platform_.find("cluster");
    return cluster ? cluster->textOf("master") : "";
  }

  void readStereo() {
    const Part* stereo = platform_.find("stereo");
    if (!stereo) return;
    if (const Part* mode = stereo->find("mode")) mode_ = modeOf(*mode, room_);
    swapsEyes_ = flagOr(*stereo, "swap_eyes", false, room_);
    separation_m_ = number(*stereo, "separation", kNotNegative, false, room_).value_or(kEyeSeparation_m);
    separationAt_ = stereo->placeOf("separation");
    headName_ = stereo->textOf("tracker");
    for (const char* told : {"alignment", "separate_eyes"}) stereo->find(told);  // as every tracked wall here
  }

  void readPeople() {
    const glm::dvec3 standing_m(0.0, kStandingEyes_m, 0.0);
    addPerson("viewer", separation_m_, standing_m, separationAt_, "someone standing on the origin", room_);
    readHevsTrackers(platform_, headName_, room_);
  }

  void readNode(const Part& node) {
    node.isRead = true;
    HevsNode in{node, {}};
    in.window.fullscreen = flagOr(node, "fullscreen", true, room_);
    in.window.size_px = kAssumedWindow_px;
    if (const Part* resolution = node.find("resolution")) {
      constexpr Range kSize{.least = 1.0, .most = kMostRoomPixels};
      if (resolution->parts.size() != 2) {
        addError(room_, resolution->textAt, "resolution is no array of 2 numbers, expected width and height");
      } else {
        const auto x = numberOf(resolution->parts[0], kSize, true, room_),
                   y = numberOf(resolution->parts[1], kSize, true, room_);
        if (x && y) in.window.size_px = {static_cast<int>(*x), static_cast<int>(*y)};
        in.sizeGiven = true;
      }
    }
    node.find("address");
    const Part* names = node.find("displays");
    if (!names) names = node.find("display");
    if (!names) {
      return addWarning(room_, node.at,
                        fmt::format("node '{}' has no display: it draws nothing", printable(node.name)));
    }
    if (names->parts.empty()) readDisplay(*names, in);
    for (const Part& name : names->parts) readDisplay(name, in);
  }

  void readDisplay(const Part& name, const HevsNode& node) {
    name.isRead = true;
    const Part* displays = platform_.find("displays");
    const Part* found = displays ? displays->find(name.text) : nullptr;
    if (!found) {
      return addError(room_, name.textAt,
                      fmt::format("there is no display '{}', which node '{}' shows", printable(name.text),
                                  printable(node.part.name)));
    }
    const Part display = HevsInheritance(*displays, room_).of(*found);
    found->markRead();
    const std::string type = display.textOf("type");
    if (alike(type, "offaxis")) {
      readFlat(display, node);
    } else if (alike(type, "curved")) {
      readCurved(display, node, hevsCylinder(display, hevsPlaceOf(display, platform_, room_), room_));
    } else if (alike(type, "dome")) {
      const auto dome = hevsDome(display, hevsPlaceOf(display, platform_, room_), room_);
      readCurved(display, domeWindow(display, node), dome);
    } else {
      return addWarning(
          room_, type.empty() ? found->at : display.placeOf("type"),
          fmt::format("display '{}' of type '{}' is left out: nothing says where its screen is, "
                      "expected offaxis, curved or dome",
                      printable(found->name), type.empty() ? "standard" : printable(type)));
    }
    nameUnread(display, kQuietHevs, room_);
  }

  void readFlat(const Part& display, const HevsNode& node) {
    const Pose place = hevsPlaceOf(display, platform_, room_);
    const auto upperLeft = cornerOf(display, "ul", place, room_),
               lowerLeft = cornerOf(display, "ll", place, room_),
               lowerRight = cornerOf(display, "lr", place, room_);
    if (!upperLeft || !lowerLeft || !lowerRight) return;
    addWall(wallOf(display, node), {*lowerLeft, *lowerRight, *upperLeft, {"ll", "lr", "ul"}}, room_);
  }

  template <typename Shape>
  void readCurved(const Part& display, const HevsNode& node, const std::optional<Shape>& shape) {
    if (shape) addCurvedWall(wallOf(display, node), *shape, room_);
  }

  /// Returns the node with a window of the dome's fisheye picture if it gives none.
  HevsNode domeWindow(const Part& display, HevsNode node) {
    const Part* picture = display.find("fisheye_resolution");
    if (!picture || node.sizeGiven) return node;
    const auto size = arrayOf(*picture, 2, room_);
    constexpr Range kSize{.least = 1.0, .most = kMostRoomPixels};
    if (size && within(kSize, (*size)[0]) && within(kSize, (*size)[1]))
      node.window.size_px = {(*size)[0], (*size)[1]};
    return node;
  }

  /// Returns the wall of a display, without its place.
  RoomWall wallOf(const Part& display, const HevsNode& node) {
    RoomWall wall;
    wall.at = {display.at, display.at, display.placeOf("lr"), display.at, node.part.at,
               display.at, display.at};
    wall.wall.name = display.name;
    readEyes(display, wall.wall);
    WindowPlacement window = node.window;
    window.monitor =
        static_cast<int>(number(display, "monitor", {.least = 0.0, .most = 63.0}, true, room_).value_or(0.0));
    placeDisplay(display, platform_, window, wall, room_);
    if (!node.sizeGiven) {
      addWarning(room_, node.part.at,
                 fmt::format("node '{}' has no resolution: a window of {} × {} pixels is taken",
                             printable(node.part.name), window.size_px.x, window.size_px.y));
    }
    wall.wall.node = ranks_.of(hevsHost(node.part), "", node.part.at);
    return wall;
  }

  /// A display's own stereo settings win over the platform's.
  void readEyes(const Part& display, Wall& wall) {
    const Part* mode = display.find("stereo_mode");
    wall.stereo = mode ? modeOf(*mode, room_) : mode_;
    display.find("stereo_alignment");  // as every tracked wall here
    if (!flagOr(display, "swap_eyes", swapsEyes_, room_) || wall.stereo == StereoMode::mono) return;
    if (wall.stereo == StereoMode::left || wall.stereo == StereoMode::right) {
      wall.stereo = wall.stereo == StereoMode::left ? StereoMode::right : StereoMode::left;
    } else {
      wall.eyes = {{0, Eye::right}, {0, Eye::left}};
    }
  }

  void nameUnused() {
    const Part* displays = platform_.find("displays");
    for (const Part& display : partsOf(displays)) {
      if (!display.isRead)
        addWarning(room_, display.at,
                   fmt::format("display '{}' is left out: no node shows it", printable(display.name)));
    }
    if (displays) displays->markRead();  // those that are shown have been told of one by one
    for (const char* input : {"input", "tuio"}) {
      const Part* found = platform_.find(input);
      if (!found) continue;
      found->markRead();
      addWarning(room_, found->at, fmt::format("{} is left out: it has no place in a rig", input));
    }
    nameUnread(platform_, kQuietHevs, room_);
  }

  const Part& platform_;
  Room& room_;
  Ranks ranks_;
  StereoMode mode_ = StereoMode::mono;
  bool swapsEyes_ = false;
  double separation_m_ = kEyeSeparation_m;
  FilePlace separationAt_{};
  std::string headName_;
};

}  // namespace

Room readHevs(const std::filesystem::path& file, const Part& root, const std::string& platform) {
  Room room = roomOfFormat(file, "a HEVS room", "m", 1.0);
  refuseTwinMembers(root, room);
  const Part* platforms = root.find("platforms");
  std::vector<std::string> names;
  std::vector<FilePlace> places;
  for (const Part& each : platforms->parts) {
    names.push_back(each.name);
    places.push_back(each.at);
  }
  if (names.empty()) {
    addError(room, platforms->at, "there is no platform here, expected one at least with a wall");
    room.viewers.push_back({});
    return room;
  }
  const Part& chosen = platforms->parts[chooseRoom(names, places, platform, file)];
  room.title = printable(chosen.name);
  const Part whole = HevsInheritance(*platforms, room).of(chosen);
  HevsPlatform(whole, room).read();
  room.assumptions.push_back("the file is left-handed, x right, y up, z forward: it is turned to z back");
  room.assumptions.push_back("each node is drawn by an MPI rank, the master first if it has walls");
  finishRoom("a display of type offaxis, curved or dome that a node shows", room, chosen.at);
  return room;
}

}  // namespace carom
