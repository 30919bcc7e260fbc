#include "app/room_formats/jconf_file.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <string_view>

#include "app/room_formats/included.h"
#include "app/room_formats/jconf_input.h"
#include "app/room_formats/room_parts.h"
#include "app/room_import/foreign_room.h"
#include "cave/room/rectangle.h"

namespace carom {
namespace {

constexpr Range kSize_px{.least = 1.0, .most = kMostRoomPixels},
    kPlace_px{.least = -65536.0, .most = 65536.0};
constexpr std::array<std::string_view, 14> kQuiet{"version",
                                                  "frame_buffer_config",
                                                  "border",
                                                  "hide_mouse",
                                                  "always_on_top",
                                                  "lock_key",
                                                  "allow_mouse_locking",
                                                  "start_locked",
                                                  "sleep_time",
                                                  "keyboard_mouse_device_name",
                                                  "tracked",
                                                  "tracker_proxy",
                                                  "event_window_device",
                                                  "use_swap_group"};

/// Returns two numbers, each in an element of its own.
std::optional<glm::dvec2> pairOf(const Part& element, std::string_view name, const Range& range, bool whole,
                                 Room& room) {
  const auto values = element.all(name);
  if (values.size() != 2) {
    addError(room, values.empty() ? element.at : values.front()->at,
             fmt::format("{} has {} value{}, expected 2 numbers", name, values.size(),
                         values.size() == 1 ? "" : "s"));
    return {};
  }
  const auto x = numberOf(*values[0], range, whole, room), y = numberOf(*values[1], range, whole, room);
  if (!x || !y) return {};
  return glm::dvec2(*x, *y);
}

class JconfReading {
 public:
  JconfReading(const Part& elements, Room& room) : elements_(elements), room_(room), ranks_(room) {}

  void read() {
    users_ = readJconfUsers(elements_, room_);
    const std::vector<const Part*> systems = elements_.all("display_system");
    if (!systems.empty()) pipes_ = systems.front()->all("pipes");
    const std::vector<const Part*> windows = elements_.all("display_window");
    refuseTwins(windows, "name", room_);
    bool anyActive = false;
    for (const Part* window : windows) anyActive = anyActive || isActive(*window);
    for (const Part* window : windows) {
      if (anyActive && !isActive(*window)) {
        window->markRead();
        addWarning(
            room_, window->at,
            fmt::format("window '{}' is left out: it is not active", printable(window->textOf("name"))));
      } else {
        readWindow(*window, anyActive);
      }
    }
    if (!anyActive && !windows.empty())
      addWarning(room_, windows.front()->at, "no window with walls is active here: all of them are taken");
    ranks_.finish();
    for (const Part* window : windows) nameUnread(*window, kQuiet, room_);
  }

 private:
  bool isActive(const Part& window) { return flagOr(window, "active", true, room_); }

  void readWindow(const Part& window, bool anyActive) {
    for (const char* simulator : {"simulator_viewports", "sim_viewports", "simulator_viewport"}) {
      const Part* found = window.find(simulator);
      if (!found || (found->parts.empty() && found->text.empty())) continue;
      found->markRead();
      addWarning(room_, found->at,
                 fmt::format("the simulator in window '{}' is left out: it is no wall",
                             printable(window.textOf("name"))));
    }
    const Part* viewports = window.find("surface_viewports");
    if (!viewports || viewports->parts.empty()) return;
    const auto position = pairOf(window, "origin", kPlace_px, true, room_);
    const auto size = pairOf(window, "size", kSize_px, true, room_);
    if (!position || !size) return;
    WindowPlacement placed;
    placed.position_px = glm::ivec2(*position);
    placed.size_px = glm::ivec2(*size);
    placed.fullscreen = flagOr(window, "full_screen", false, room_);
    const bool isStereo = flagOr(window, "stereo", false, room_);
    for (const Part* viewport : viewports->all("surface_viewport")) {
      if (anyActive && !flagOr(*viewport, "active", true, room_)) {
        viewport->markRead();
        addWarning(
            room_, viewport->at,
            fmt::format("viewport '{}' is left out: it is not active", printable(viewport->textOf("name"))));
      } else {
        readViewport(*viewport, window, placed, isStereo);
      }
    }
  }

  void readViewport(const Part& viewport, const Part& window, const WindowPlacement& placed, bool isStereo) {
    RoomWall wall;
    wall.at = {viewport.at, viewport.placeOf("name"), viewport.at,
               viewport.at, window.placeOf("pipe"),   window.at,
               viewport.at};
    wall.wall.name = viewport.textOf("name");
    wall.wall.stereo = stereoOf(viewport, isStereo);
    wall.wall.viewer = userOf(viewport);
    viewport.find("active");
    std::array<std::optional<glm::dvec3>, 4> corners;
    constexpr std::array<std::string_view, 4> kCorners{"lower_left_corner", "lower_right_corner",
                                                       "upper_right_corner", "upper_left_corner"};
    bool sound = true;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const auto numbers = viewport.all(kCorners[i]);
      corners[i] = vectorOf(numbers, numbers.empty() ? viewport.at : numbers.front()->at, kCorners[i], room_);
      sound = sound && corners[i];
    }
    place(viewport, placed, wall);
    if (!sound || !fits(viewport, corners, wall.wall.name)) return;
    wall.wall.node = rankOf(window);
    addWall(std::move(wall), {*corners[0], *corners[1], *corners[3], {kCorners[0], kCorners[1], kCorners[3]}},
            room_);
  }

  /// Returns whether the fourth corner is where the others put it; adds an error if not.
  bool fits(const Part& viewport, const std::array<std::optional<glm::dvec3>, 4>& corners,
            const std::string& name) {
    const double miss_m = glm::distance(*corners[2], *corners[1] + *corners[3] - *corners[0]);
    if (miss_m <= kCornerMiss_m) return true;
    addError(room_, viewport.all("upper_right_corner").front()->at,
             fmt::format("upper_right_corner of wall '{}' is {:.1f} mm from where the other corners put it, "
                         "expected at most {:.0f} mm",
                         printable(name), miss_m * 1e3, kCornerMiss_m * 1e3));
    return false;
  }

  StereoMode stereoOf(const Part& viewport, bool isStereo) {
    const Part* view = viewport.find("view");
    if (!view || alike(view->text, "Stereo")) return isStereo ? StereoMode::quadBuffer : StereoMode::mono;
    if (alike(view->text, "Left") || alike(view->text, "Left Eye")) return StereoMode::left;
    if (alike(view->text, "Right") || alike(view->text, "Right Eye")) return StereoMode::right;
    addWarning(
        room_, view->textAt,
        fmt::format("view is '{}', expected Left, Right or Stereo: mono is taken", printable(view->text)));
    return StereoMode::mono;
  }

  std::size_t userOf(const Part& viewport) {
    const Part* user = viewport.find("user");
    if (!user || user->text.empty()) return 0;
    const auto known = users_.find(user->text);
    if (known != users_.end()) return known->second;
    addWarning(room_, user->textAt,
               fmt::format("there is no user '{}' here: the wall is for the first", printable(user->text)));
    return 0;
  }

  /// Origin and size are shares of the window from its lower left.
  void place(const Part& viewport, const WindowPlacement& window, RoomWall& wall) {
    constexpr Range kPart{.least = 0.0, .most = 1.0};
    const auto low = pairOf(viewport, "origin", kPart, false, room_);
    const auto size = pairOf(viewport, "size", kPart, false, room_);
    if (!low || !size) return;
    const glm::dvec2 whole(window.size_px);
    const glm::ivec2 begin(glm::round(*low * whole)), end(glm::round((*low + *size) * whole));
    placeInWindow(window, {begin.x, window.size_px.y - end.y}, glm::max(end - begin, glm::ivec2(1)), wall,
                  room_);
  }

  /// Returns the rank of a window's pipe: a display such as "host:0.1".
  int rankOf(const Part& window) {
    const auto pipe = number(window, "pipe", {.least = 0.0, .most = 1023.0}, true, room_);
    const auto index = static_cast<std::size_t>(pipe.value_or(0.0));
    const std::string display = index < pipes_.size() ? pipes_[index]->text : "";
    const std::size_t colon = display.find(':');
    if (colon == std::string::npos) return ranks_.of("", "", window.placeOf("pipe"));
    const std::string host = display.substr(0, colon);
    return ranks_.of(host == "localhost" ? "" : host, display.substr(colon), pipes_[index]->textAt);
  }

  const Part& elements_;
  Room& room_;
  Ranks ranks_;
  std::map<std::string, std::size_t> users_;
  std::vector<const Part*> pipes_;
};

}  // namespace

Room readJconf(const std::filesystem::path& file, Part root) {
  Room room = roomOfFormat(file, "a VR Juggler room", "m", 1.0);
  Included(file, "include", room).expand(root);
  Part all{"elements", {}, root.at, root.at};
  for (Part& part : root.parts) {
    if (!alike(part.name, "elements")) continue;
    for (Part& element : part.parts) all.parts.push_back(std::move(element));
  }
  JconfReading(all, room).read();
  room.assumptions.push_back("lengths are metres, axes x right, y up, z back, as VR Juggler has them");
  room.assumptions.push_back("each display is drawn by an MPI rank, in the order of the windows");
  finishRoom("a surface_viewport of a display_window", room);
  return room;
}

}  // namespace carom
