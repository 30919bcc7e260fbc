#include "app/cave_formats/jconf_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <string_view>
#include <vector>

#include "app/cave_formats/jconf_input.h"
#include "app/room_checks/foreign_room.h"
#include "app/room_parts/included.h"
#include "app/room_parts/room_parts.h"
#include "cave/room/rectangle.h"

namespace carom {
namespace {

constexpr std::array<std::string_view, 4> kCorners{"lower_left_corner", "lower_right_corner",
                                                   "upper_right_corner", "upper_left_corner"};
using JconfCorners = std::array<std::optional<glm::dvec3>, 4>;
constexpr std::array<std::string_view, 16> kQuietJuggler{"name",
                                                         "number_of_pipes",
                                                         "listen_port",
                                                         "version",
                                                         "frame_buffer_config",
                                                         "border",
                                                         "hide_mouse",
                                                         "always_on_top",
                                                         "lock_key",
                                                         "allow_mouse_locking",
                                                         "start_locked",
                                                         "sleep_time",
                                                         "keyboard_mouse_device_name",
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

/// A computer with its windows: a node of a cluster, or the one for all that stands outside of nodes.
struct JconfMachine {
  std::string host;
  std::vector<const Part*> pipes, windows;
};

/// A window whose viewports are read.
struct JconfWindow {
  const Part& part;
  const JconfMachine& machine;
  WindowPlacement placed;
  bool isStereo = false;
};

std::string plainHost(const std::string& host) {
  return host == "localhost" || host == "127.0.0.1" ? "" : host;
}

class JconfReading {
 public:
  JconfReading(const Part& elements, const Part* system, Room& room)
      : elements_(elements), room_(room), ranks_(room) {
    machines_.push_back(
        {"", system ? system->all("pipes") : std::vector<const Part*>(), elements.all("display_window")});
  }

  void read() {
    users_ = readJconfUsers(elements_, room_);
    for (const char* kind : {"cluster_node", "machine_specific"}) {
      for (const Part* node : elements_.all(kind)) addNode(*node);
    }
    std::vector<const Part*> windows;
    for (const JconfMachine& machine : machines_) {
      refuseTwins(machine.windows, "name", room_);
      windows.insert(windows.end(), machine.windows.begin(), machine.windows.end());
    }
    const bool anyActive =
        std::any_of(windows.begin(), windows.end(), [&](const Part* window) { return isActive(*window); });
    for (const JconfMachine& machine : machines_) readMachine(machine, anyActive);
    if (!anyActive && !windows.empty())
      addWarning(room_, windows.front()->at, "no window with walls is active here: all of them are taken");
    ranks_.finish();
    if (isMoved_)
      room_.assumptions.push_back(
          "windows' origins count from the lower left of their display, whose height the file does not say: "
          "they "
          "are taken as from its upper left");
    nameUnread(elements_, kQuietJuggler, room_);
  }

 private:
  bool isActive(const Part& window) { return flagOr(window, "active", true, room_); }

  void addNode(const Part& node) {
    JconfMachine machine{plainHost(node.textOf("host_name")), {}, {}};
    if (machine.host.empty()) machine.host = plainHost(node.textOf("name"));
    for (const Part* systems : node.all("display_system")) {
      for (const Part* system : systems->all("display_system")) machine.pipes = system->all("pipes");
    }
    for (const Part* windows : node.all("display_windows")) {
      for (const Part* window : windows->all("display_window")) machine.windows.push_back(window);
    }
    if (machine.windows.empty())
      addWarning(room_, node.at,
                 fmt::format("node '{}' has no window: it draws nothing", printable(node.textOf("name"))));
    machines_.push_back(std::move(machine));
  }

  void readMachine(const JconfMachine& machine, bool anyActive) {
    for (const Part* window : machine.windows) {
      if (anyActive && !isActive(*window)) {
        window->markRead();
        addWarning(
            room_, window->at,
            fmt::format("window '{}' is left out: it is not active", printable(window->textOf("name"))));
      } else {
        readWindow(*window, machine, anyActive);
      }
    }
  }

  void readWindow(const Part& window, const JconfMachine& machine, bool anyActive) {
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
    const auto position = pairOf(window, "origin", kWindowPlace_px, true, room_);
    const auto size = pairOf(window, "size", kWindowSize_px, true, room_);
    if (!position || !size) return;
    WindowPlacement placed;
    placed.position_px = glm::ivec2(*position);
    placed.size_px = glm::ivec2(*size);
    placed.fullscreen = flagOr(window, "full_screen", false, room_);
    if (placed.position_px.y != 0 && !placed.fullscreen) isMoved_ = true;
    const bool isStereo = flagOr(window, "stereo", false, room_);
    for (const Part* viewport : viewports->all("surface_viewport")) {
      if (anyActive && !flagOr(*viewport, "active", true, room_)) {
        viewport->markRead();
        addWarning(
            room_, viewport->at,
            fmt::format("viewport '{}' is left out: it is not active", printable(viewport->textOf("name"))));
      } else if (flagOr(*viewport, "tracked", false, room_)) {
        viewport->markRead();
        addWarning(room_, viewport->at,
                   fmt::format("viewport '{}' is left out: its surface is tracked and moves",
                               printable(viewport->textOf("name"))));
      } else {
        readViewport(*viewport, {window, machine, placed, isStereo});
      }
    }
  }

  void readViewport(const Part& viewport, const JconfWindow& window) {
    RoomWall wall;
    wall.at = {viewport.at, viewport.placeOf("name"),    viewport.at,
               viewport.at, window.part.placeOf("pipe"), window.part.at,
               viewport.at};
    wall.wall.name = viewport.textOf("name");
    wall.wall.stereo = stereoOf(viewport, window.isStereo);
    wall.wall.viewer = userOf(viewport);
    viewport.find("active");
    const JconfCorners corners = cornersOf(viewport);
    place(viewport, window.placed, wall);
    if (std::any_of(corners.begin(), corners.end(), [](const auto& corner) { return !corner; })) return;
    if (!fits(viewport, corners, wall.wall.name)) return;
    wall.wall.node = rankOf(window);
    addWall(std::move(wall), {*corners[0], *corners[1], *corners[3], {kCorners[0], kCorners[1], kCorners[3]}},
            room_);
  }

  /// Returns the corners in the order of kCorners; nothing, with an error noted, for those that are wrong.
  /// The first version of viewports has them as <corners><vec3> with x, y and z.
  JconfCorners cornersOf(const Part& viewport) {
    JconfCorners corners;
    const std::vector<const Part*> old = viewport.all("corners");
    for (std::size_t i = 0; i < corners.size(); ++i) {
      std::vector<const Part*> numbers = viewport.all(kCorners[i]);
      if (numbers.empty() && old.size() == corners.size()) {
        const Part* vector = old[i]->find("vec3");
        for (const char* axis : {"x", "y", "z"}) {
          if (const Part* number = vector ? vector->find(axis) : nullptr) numbers.push_back(number);
        }
      }
      corners[i] = vectorOf(numbers, numbers.empty() ? viewport.at : numbers.front()->at, kCorners[i], room_);
    }
    return corners;
  }

  /// Returns whether the fourth corner is where the others put it; adds an error if not.
  bool fits(const Part& viewport, const JconfCorners& corners, const std::string& name) {
    const double miss_m = glm::distance(*corners[2], *corners[1] + *corners[3] - *corners[0]);
    if (miss_m <= kCornerMiss_m) return true;
    addError(room_, viewport.placeOf("upper_right_corner"),
             fmt::format("upper_right_corner of wall '{}' is {:.1f} mm from where the other corners put it, "
                         "expected at most {:.0f} mm",
                         printable(name), miss_m * 1e3, kCornerMiss_m * 1e3));
    return false;
  }

  StereoMode stereoOf(const Part& viewport, bool isStereo) {
    const Part* view = viewport.find("view");
    const auto is = [&](std::string_view number, std::string_view name) {
      return view->text == number || alike(view->text, name) || alike(view->text, std::string(name) + " Eye");
    };
    if (!view || is("3", "Stereo")) return isStereo ? StereoMode::quadBuffer : StereoMode::mono;
    if (is("1", "Left")) return StereoMode::left;
    if (is("2", "Right")) return StereoMode::right;
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
  int rankOf(const JconfWindow& window) {
    const auto pipe = number(window.part, "pipe", {.least = 0.0, .most = 1023.0}, true, room_);
    const auto index = static_cast<std::size_t>(pipe.value_or(0.0));
    const JconfMachine& machine = window.machine;
    const std::string display = index < machine.pipes.size() ? machine.pipes[index]->text : "";
    const std::size_t colon = display.find(':');
    if (colon == std::string::npos) return ranks_.of(machine.host, "", window.part.placeOf("pipe"));
    const std::string host = plainHost(display.substr(0, colon));
    return ranks_.of(host.empty() ? machine.host : host, display.substr(colon), machine.pipes[index]->textAt);
  }

  const Part& elements_;
  Room& room_;
  Ranks ranks_;
  std::map<std::string, std::size_t> users_;
  std::vector<JconfMachine> machines_;
  bool isMoved_ = false;  // a window is not at the lower edge of its display
};

/// Returns the wanted one of several display systems, each with pipes of its own; null if there is none.
const Part* systemOf(const Part& elements, const std::string& wanted, const std::filesystem::path& file) {
  const std::vector<const Part*> systems = elements.all("display_system");
  if (systems.empty()) {
    refuseRoomName(wanted, file);
    return nullptr;
  }
  std::vector<std::string> names;
  std::vector<FilePlace> places;
  for (const Part* system : systems) {
    names.push_back(system->textOf("name"));
    places.push_back(system->at);
  }
  return systems[chooseRoom(names, places, wanted, file)];
}

}  // namespace

Room readJconf(const std::filesystem::path& file, Part root, const std::string& wanted) {
  Room room = roomOfFormat(file, "a VR Juggler room", "m", 1.0);
  Included(file, "include", room).expand(root);
  Part all{"elements", {}, root.at, root.at};
  for (Part& part : root.parts) {
    if (!alike(part.name, "elements")) continue;
    for (Part& element : part.parts) all.parts.push_back(std::move(element));
  }
  JconfReading(all, systemOf(all, wanted, file), room).read();
  room.assumptions.push_back("lengths are metres, axes x right, y up, z back, as VR Juggler has them");
  room.assumptions.push_back("each display is drawn by an MPI rank, in the order of the windows");
  finishRoom("a surface_viewport of a display_window", room);
  return room;
}

}  // namespace carom
