#include "app/cave_formats/eqc_file.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/trigonometric.hpp>
#include <map>
#include <string_view>
#include <utility>

#include "app/room_checks/foreign_room.h"
#include "app/room_parts/room_parts.h"

namespace carom {
namespace {

constexpr glm::ivec2 kAssumedPipe_px{1920, 1080};
constexpr std::array<std::string_view, 13> kQuietEqualizer{
    "latency",        "swapbarrier", "connection", "attributes",   "global", "name",       "swap_barrier",
    "view_equalizer", "robustness",  "warp",       "thread_model", "task",   "outputframe"};

/// A channel with the window on which it draws.
struct EqcChannel {
  const Part* part = nullptr;
  const Part *node = nullptr, *pipe = nullptr, *window = nullptr;
  bool isShown = false;
};

/// A part of a canvas or window: shares from its lower left corner.
struct Share {
  glm::dvec2 low{0.0}, size{1.0};
};

/// The rotation and the place of the wall as Wall::operator=(const Projection&) of Equalizer has them
/// (eq/fabric/wall.cpp): the wall's middle is at origin + w·distance, with w the third column, and its size
/// 2·distance·tan(fov/2).
ReadCorners projectedWall(const glm::dvec3& origin_m, double distance_m, const glm::dvec2& fov_deg,
                          const glm::dvec3& hpr_deg) {
  const glm::dvec3 hpr = glm::radians(hpr_deg);
  const double cH = std::cos(hpr.x), sH = std::sin(hpr.x), cP = std::cos(hpr.y), sP = std::sin(hpr.y),
               cR = std::cos(hpr.z), sR = std::sin(hpr.z);
  const glm::dvec3 right(cH * cR, -cH * sR, -sH);
  const glm::dvec3 up(-sP * sH * cR + cP * sR, sP * sH * sR + cP * cR, -sP * cH);
  const glm::dvec3 w(cP * sH * cR + sP * sR, -cP * sH * sR + sP * cR, cP * cH);
  const glm::dvec2 size_m = glm::abs(2.0 * distance_m * glm::tan(0.5 * glm::radians(fov_deg)));
  return rectangleAround(origin_m + distance_m * w, right, up, size_m.x, size_m.y);
}

/// Returns the part of a wall.
ReadCorners cut(const ReadCorners& wall, const Share& share) {
  const glm::dvec3 across_m = wall.lowerRight_m - wall.lowerLeft_m,
                   up_m = wall.upperLeft_m - wall.lowerLeft_m;
  ReadCorners part = wall;
  part.lowerLeft_m = wall.lowerLeft_m + share.low.x * across_m + share.low.y * up_m;
  part.lowerRight_m = part.lowerLeft_m + share.size.x * across_m;
  part.upperLeft_m = part.lowerLeft_m + share.size.y * up_m;
  return part;
}

/// Returns the first address of a node; none for the computer itself.
std::string equalizerHost(const Part& node) {
  std::string host;
  for (const Part* connection : node.all("connection")) {
    if (host.empty()) host = connection->textOf("hostname");
  }
  if (host.empty()) host = node.textOf("host");
  return host == "localhost" || host == "127.0.0.1" ? "" : host;
}

/// Returns the X display of a pipe, or nothing where the file names none.
std::string displayOf(const Part& pipe, Room& room) {
  constexpr Range kScreen{.least = 0.0, .most = 63.0};
  const auto port = number(pipe, "port", kScreen, true, room),
             device = number(pipe, "device", kScreen, true, room);
  if (!port && !device) return "";
  return fmt::format(":{}.{}", port.value_or(0.0), device.value_or(0.0));
}

/// What a compound hands down to those within.
struct Handed {
  const Part* channel = nullptr;
  const Part* eye = nullptr;
};

class EqcReading {
 public:
  /// `global`: the file's usual values, or null.
  EqcReading(const Part& config, const Part* global, Room& room)
      : config_(config), global_(global), room_(room), ranks_(room) {}

  void read() {
    for (const Part& part : config_.parts) {
      if (alike(part.name, "appNode") || alike(part.name, "node")) readNode(part);
    }
    readObserver();
    for (const Part* layout : config_.all("layout")) {
      for (const Part* view : layout->all("view")) view->find("observer");  // the first is the one
    }
    for (const Part* canvas : config_.all("canvas")) readCanvas(*canvas);
    for (const Part* compound : config_.all("compound")) readCompound(*compound, {}, 0);
    ranks_.finish();
    for (const auto& [name, channel] : channels_) {
      if (channel.isShown) continue;
      channel.part->markRead();
      for (const Part* its : {channel.window, channel.pipe}) {
        if (const Part* viewport = its->find("viewport")) viewport->markRead();
      }
      addWarning(room_, channel.part->at,
                 fmt::format("channel '{}' is left out: no wall is shown on it", printable(name)));
    }
  }

 private:
  void readNode(const Part& node) {
    node.isRead = true;
    for (const Part* pipe : node.all("pipe")) {
      for (const Part* window : pipe->all("window")) {
        for (const Part* channel : window->all("channel")) {
          const std::string name = channel->textOf("name");
          const auto [known, isNew] = channels_.emplace(name, EqcChannel{channel, &node, pipe, window});
          if (!isNew) {
            addError(room_, channel->placeOf("name"),
                     fmt::format("the channel name '{}' is taken in line {}, expected another",
                                 printable(name), known->second.part->at.line));
          }
        }
      }
    }
  }

  void readObserver() {
    double apart_m = 0.05;  // Equalizer's default eye base
    FilePlace at = config_.at;
    for (const auto& [whole, name] : {std::pair(global_, "EQ_CONFIG_FATTR_EYE_BASE"),
                                      std::pair(config_.find("attributes"), "eye_base")}) {
      if (!whole || !whole->find(name)) continue;
      apart_m = number(*whole, name, kNotNegative, false, room_).value_or(apart_m);
      at = whole->placeOf(name);
    }
    const std::vector<const Part*> observers = config_.all("observer");
    for (const Part* observer : observers) {
      apart_m = number(*observer, "eye_base", kNotNegative, false, room_).value_or(apart_m);
      if (observer->find("eye_base")) at = observer->placeOf("eye_base");
      const Part *left = observer->find("eye_left"), *right = observer->find("eye_right");
      if (!left || !right) continue;
      const auto l = arrayOf(*left, 3, room_), r = arrayOf(*right, 3, room_);
      if (!l || !r) continue;
      apart_m = glm::distance(glm::dvec3((*l)[0], (*l)[1], (*l)[2]), glm::dvec3((*r)[0], (*r)[1], (*r)[2]));
      at = left->textAt;
    }
    addPerson("viewer", apart_m, kStandingEyes_m * room_.axes.up, at, "someone standing on the origin",
              room_);
    if (observers.size() > 1)
      addWarning(room_, observers[1]->at, "there are several observers: the walls are for the first");
    for (const Part* observer : observers) {
      const Part* tracker = observer->find("vrpn_tracker");
      if (!tracker || room_.people.front().isTracked) continue;
      if (const auto index = addVrpn("head", tracker->text, {}, tracker->textAt, room_)) {
        room_.people.front().setup.head.sensor = {*index, 0};
        room_.people.front().isTracked = true;
        room_.assumptions.push_back("the VRPN tracker's coordinates are those of the room, its sensor is 0");
      }
    }
  }

  /// Returns the corners of a part's wall or projection; nothing if it has none or, with an error noted, a
  /// wrong one. `at` becomes its place.
  std::optional<ReadCorners> wallOf(const Part& part, FilePlace& at) {
    if (const Part* wall = part.find("wall")) {
      at = wall->at;
      std::array<std::optional<glm::dvec3>, 3> corners;
      constexpr std::array<std::string_view, 3> kNames{"bottom_left", "bottom_right", "top_left"};
      for (std::size_t i = 0; i < corners.size(); ++i) {
        const Part* corner = wall->find(kNames[i]);
        if (!corner) addError(room_, wall->at, fmt::format("{} is missing in wall", kNames[i]));
        const auto values = corner ? arrayOf(*corner, 3, room_) : std::nullopt;
        if (values) corners[i] = {(*values)[0], (*values)[1], (*values)[2]};
      }
      if (const Part* type = wall->find("type"); type && alike(type->text, "HMD")) {
        addWarning(room_, wall->at, "a wall of type HMD hangs on the head: it is left out");
        return {};
      }
      if (!corners[0] || !corners[1] || !corners[2]) return {};
      return ReadCorners{*corners[0], *corners[1], *corners[2], kNames};
    }
    const Part* projection = part.find("projection");
    if (!projection) return {};
    at = projection->at;
    const auto values = [&](std::string_view name, std::size_t count) {
      const Part* given = projection->find(name);
      return given ? arrayOf(*given, count, room_) : std::optional(std::vector<double>(count, 0.0));
    };
    const auto origin = values("origin", 3), fov = values("fov", 2), hpr = values("hpr", 3);
    const auto distance_m = number(*projection, "distance", {}, false, room_);
    if (!origin || !fov || !hpr || !distance_m) return {};
    return projectedWall({(*origin)[0], (*origin)[1], (*origin)[2]}, *distance_m, {(*fov)[0], (*fov)[1]},
                         {(*hpr)[0], (*hpr)[1], (*hpr)[2]});
  }

  std::optional<Share> shareOf(const Part& part) {
    const Part* viewport = part.find("viewport");
    if (!viewport) return Share{};
    const auto values = arrayOf(*viewport, 4, room_);
    if (!values) return {};
    return Share{{(*values)[0], (*values)[1]}, {(*values)[2], (*values)[3]}};
  }

  /// Returns the wall of the first view of a canvas's layout.
  std::optional<ReadCorners> viewWallOf(const Part& canvas, FilePlace& at) {
    const std::string name = canvas.textOf("layout");
    const std::vector<const Part*> layouts = config_.all("layout");
    for (std::size_t i = 0; i < layouts.size(); ++i) {
      if (layouts[i]->textOf("name") != name && fmt::format("{}", i) != name) continue;
      for (const Part* view : layouts[i]->all("view")) {
        if (const auto wall = wallOf(*view, at)) return wall;
      }
    }
    return {};
  }

  void readCanvas(const Part& canvas) {
    FilePlace at = canvas.at;
    auto whole = wallOf(canvas, at);
    if (!whole) whole = viewWallOf(canvas, at);
    for (const Part* segment : canvas.all("segment")) {
      FilePlace own = at;
      auto corners = wallOf(*segment, own);
      const auto share = shareOf(*segment);
      if (corners && segment->find("viewport"))
        room_.assumptions.push_back(fmt::format(
            "the segment has a wall of its own, so its viewport on the canvas is left out, line {}",
            segment->find("viewport")->at.line));
      if (!corners && whole && share) corners = cut(*whole, *share);
      const Part* channel = segment->find("channel");
      if (!channel) {
        addWarning(room_, segment->at, "this segment has no channel: it is left out");
      } else if (!corners) {
        addWarning(room_, segment->at, "this segment has no wall, nor has its canvas: it is left out");
      } else {
        showOn(*channel, *corners, own, segment->find("eye"));
      }
    }
  }

  void readCompound(const Part& compound, Handed handed, std::size_t depth) {
    if (const Part* channel = compound.find("channel")) handed.channel = channel;
    if (const Part* eye = compound.find("eye")) handed.eye = eye;
    FilePlace at = compound.at;
    if (const auto corners = wallOf(compound, at)) {
      if (handed.channel) {
        showOn(*handed.channel, *corners, at, handed.eye);
      } else {
        addWarning(room_, at, "this wall is left out: its compound has no channel");
      }
    }
    for (const Part* child : compound.all("compound")) readCompound(*child, handed, depth + 1);
  }

  /// Returns whether a hint of a channel's window is on: its own, or else that of all windows.
  bool hasHint(const EqcChannel& channel, std::string_view own, std::string_view ofAll) const {
    const Part* attributes = channel.window->find("attributes");
    const Part* hint = attributes ? attributes->find(own) : nullptr;
    if (!hint && global_) hint = global_->find(ofAll);
    return hint && alike(hint->text, "ON");
  }

  /// Returns the eyes of a list such as [ LEFT CYCLOP ].
  StereoMode stereoOf(const Part* eyes, const EqcChannel& channel) {
    bool left = false, right = false;
    for (const Part& eye : partsOf(eyes)) {
      eye.isRead = true;
      left = left || alike(eye.text, "LEFT");
      right = right || alike(eye.text, "RIGHT");
    }
    if (left != right) return left ? StereoMode::left : StereoMode::right;
    const bool quad = hasHint(channel, "hint_stereo", "EQ_WINDOW_IATTR_HINT_STEREO");
    return quad ? StereoMode::quadBuffer : StereoMode::mono;
  }

  void showOn(const Part& name, const ReadCorners& corners, FilePlace at, const Part* eyes) {
    name.isRead = true;
    const auto found = channels_.find(name.text);
    if (found == channels_.end()) {
      return addError(room_, name.textAt, fmt::format("there is no channel '{}'", printable(name.text)));
    }
    EqcChannel& channel = found->second;
    channel.isShown = true;
    RoomWall wall;
    wall.at = {at, name.textAt, at, channel.part->at, channel.node->at, channel.window->at, at};
    wall.wall.name = name.text;
    wall.wall.stereo = stereoOf(eyes, channel);
    place(channel, wall);
    wall.wall.node =
        ranks_.of(equalizerHost(*channel.node), displayOf(*channel.pipe, room_), channel.node->at);
    addWall(std::move(wall), corners, room_);
  }

  /// Returns the pixels of a viewport: its numbers are pixels from the top left, or shares where all are at
  /// most 1; then, within a window, they count from its lower left.
  std::optional<Viewport> pixelsOf(const Part& part, glm::ivec2 whole_px, bool fromBelow) {
    const auto share = shareOf(part);
    if (!share) return {};
    const glm::dvec2 end = share->low + share->size;
    const bool isShare = share->size.x <= 1.0 && share->size.y <= 1.0;
    const glm::dvec2 scale = isShare ? glm::dvec2(whole_px) : glm::dvec2(1.0);
    constexpr double kFarthest = 65536.0;
    const auto rounded = [&](glm::dvec2 at) {
      return glm::ivec2(glm::round(glm::clamp(at * scale, -kFarthest, kFarthest)));
    };
    const glm::ivec2 low = rounded(share->low), high = glm::max(rounded(end), low + 1);
    const int top = isShare && fromBelow ? whole_px.y - high.y : low.y;
    return Viewport{{low.x, top}, high - low};
  }

  void place(const EqcChannel& channel, RoomWall& wall) {
    const auto pipe =
        channel.pipe->find("viewport") ? pixelsOf(*channel.pipe, kAssumedPipe_px, false) : std::nullopt;
    const glm::ivec2 pipe_px = pipe ? pipe->size_px : kAssumedPipe_px;
    const bool said = channel.window->find("viewport") || pipe;
    const auto window = pixelsOf(*channel.window, pipe_px, false);
    if (!window) return;
    if (!said) {
      addWarning(room_, channel.window->at,
                 fmt::format("this window has no viewport: {} × {} pixels are taken", pipe_px.x, pipe_px.y));
    }
    WindowPlacement placed;
    placed.position_px = window->position_px;
    placed.size_px =
        glm::clamp(window->size_px, glm::ivec2(1), glm::ivec2(static_cast<int>(kMostRoomPixels)));
    placed.fullscreen = hasHint(channel, "hint_fullscreen", "EQ_WINDOW_IATTR_HINT_FULLSCREEN");
    if (const auto part = pixelsOf(*channel.part, placed.size_px, true))
      placeInWindow(placed, part->position_px, part->size_px, wall, room_);
  }

  const Part& config_;
  const Part* global_;
  Room& room_;
  Ranks ranks_;
  std::map<std::string, EqcChannel> channels_;
};

/// Returns the wanted one of several configurations of a server, each named or else numbered from 0; null if
/// there is none.
const Part* configOf(const Part& whole, const std::string& wanted, const std::filesystem::path& file) {
  const std::vector<const Part*> configs = whole.all("config");
  if (configs.size() < 2) {
    refuseRoomName(wanted, file);
    return configs.empty() ? nullptr : configs.front();
  }
  std::vector<std::string> names;
  std::vector<FilePlace> places;
  for (const Part* config : configs) {
    const std::string name = config->textOf("name");
    names.push_back(name.empty() ? fmt::format("{}", names.size()) : name);
    places.push_back(config->at);
  }
  const Part* chosen = configs[chooseRoom(names, places, wanted, file)];
  for (const Part* config : configs) {
    if (config != chosen) config->markRead();
  }
  return chosen;
}

}  // namespace

Room readEqc(const std::filesystem::path& file, const Part& root, const std::string& wanted) {
  Room room = roomOfFormat(file, "an Equalizer room", "m", 1.0);
  const Part* server = root.find("server");
  const Part* config = configOf(server ? *server : root, wanted, file);
  if (!config) {
    addError(room, server ? server->at : FilePlace{},
             "there is no config here, expected server { config { … } }");
  } else {
    EqcReading(*config, root.find("global"), room).read();
  }
  nameUnread(root, kQuietEqualizer, room);
  room.assumptions.push_back("lengths are metres, axes x right, y up, z back, as Equalizer has them");
  room.assumptions.push_back("each pipe with walls is drawn by an MPI rank, those of the appNode first");
  room.assumptions.push_back("walls whose window asks for no stereo are mono, but for those of one eye");
  finishRoom("a wall or a projection of a segment, a canvas or a compound with a channel", room);
  return room;
}

}  // namespace carom
