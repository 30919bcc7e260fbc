#include "app/file_tools/rig_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <optional>
#include <set>
#include <variant>

#include "app/calibration/rig_lines.h"
#include "app/file_keys/rig_keys.h"
#include "app/rig/rig_screen.h"
#include "app/room_checks/room_check.h"
#include "cave/screen/curved_screen.h"

namespace carom {
namespace {

/// Returns a number without needless zeros.
std::string plain(double value, int decimals = 6) {
  std::string text = fmt::format("{:.{}f}", value, decimals);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text += '0';
  return text == "-0.0" ? "0.0" : text;
}

std::string plainVector(const glm::dvec3& v) {
  return fmt::format("[{}, {}, {}]", plain(v.x), plain(v.y), plain(v.z));
}

/// Returns a length in the room's unit, to a thousandth of a millimetre.
std::string lengthIn(const Room& room, double length_m) {
  const double unit_m = room.unit == "mm" ? 1e-3 : room.unit == "cm" ? 1e-2 : 1.0;
  return plain(length_m / unit_m, room.unit == "mm" ? 3 : room.unit == "cm" ? 4 : 6);
}

std::string vectorIn(const Room& room, const glm::dvec3& v) {
  return fmt::format("[{}, {}, {}]", lengthIn(room, v.x), lengthIn(room, v.y), lengthIn(room, v.z));
}

std::string poseIn(const Room& room, const Pose& pose) {
  return fmt::format("{{ translation = {}, rotation_deg = {} }}", vectorIn(room, pose.position_m),
                     plainVector(rotation_deg(pose.orientation)));
}

bool isIdentity(const Pose& pose) {
  return glm::length(pose.position_m) == 0.0 && std::abs(pose.orientation.w) >= 1.0;
}

std::string tomlText(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result + '"';
}

std::string windowText(const WindowPlacement& window) {
  return fmt::format("monitor = {}, position = [{}, {}], size = [{}, {}], fullscreen = {}", window.monitor,
                     window.position_px.x, window.position_px.y, window.size_px.x, window.size_px.y,
                     window.fullscreen);
}

std::string headText(const Room& room, const HeadSetup& head) {
  std::string text = fmt::format("tracker = {}\nsensor = {}\neye_separation = {}\n",
                                 tomlText(room.trackers[head.sensor.tracker].name), head.sensor.sensor,
                                 lengthIn(room, head.eyeSeparation_m));
  if (!isIdentity(head.eyesFromSensor))
    text += fmt::format("eyes_from_sensor = {}\n", poseIn(room, head.eyesFromSensor));
  return text;
}

std::string handText(const Room& room, const HandSetup& hand) {
  std::string text =
      fmt::format("tracker = {}\nsensor = {}\n", tomlText(room.trackers[hand.tracker].name), hand.sensor);
  if (!isIdentity(hand.handFromSensor))
    text += fmt::format("hand_from_sensor = {}\n", poseIn(room, hand.handFromSensor));
  return text;
}

std::string peopleText(const Room& room) {
  std::string text;
  const bool several = room.people.size() > 1;
  for (const Person& person : room.people) {
    text += several ? fmt::format("\n[[viewer]]\nname = {}\n", tomlText(person.setup.name)) : "\n[head]\n";
    text += headText(room, person.setup.head);
    if (person.setup.hand)
      text += fmt::format("\n[{}]\n{}", several ? "viewer.hand" : "hand", handText(room, *person.setup.hand));
  }
  return text;
}

std::string_view unitName(double unit_m) {
  const auto found = std::find(kMetresPerUnit.begin(), kMetresPerUnit.end(), unit_m);
  return kLengthUnits.at(static_cast<std::size_t>(found - kMetresPerUnit.begin()));
}

std::string trackersText(const Room& room) {
  std::string text;
  for (const TrackerSetup& tracker : room.trackers) {
    text += fmt::format("\n[[tracker]]\nname = {}\nkind = \"{}\"\n", tomlText(tracker.name),
                        toString(tracker.kind));
    if (tracker.kind == TrackerKind::simulated && room.people.size() > 1) text += "person = \"walks\"\n";
    if (!tracker.source.empty()) text += fmt::format("source = {}\n", tomlText(tracker.source.string()));
    if (tracker.kind == TrackerKind::trackd) text += fmt::format("unit = \"{}\"\n", unitName(tracker.unit_m));
    text += fmt::format("room_from_tracker = {}\n", poseIn(room, tracker.roomFromTracker));
  }
  return text;
}

std::string nodesText(const Room& room) {
  std::string text;
  for (const NodeSetup& node : room.nodes) {
    text += fmt::format("\n[[node]]\nrank = {}\n", node.rank);
    if (!node.host.empty()) text += fmt::format("host = {}\n", tomlText(node.host));
    if (node.slots > 1) text += fmt::format("slots = {}\n", node.slots);
    if (!node.display.empty()) text += fmt::format("display = {}\n", tomlText(node.display));
  }
  return text;
}

/// Returns the shape of a curved wall that has a formula.
std::optional<ScreenFormula> shapeOf(const Wall& wall) {
  if (!wall.screen) return {};
  if (const auto* cylinder = std::get_if<CylinderScreen>(&wall.screen->shape)) return *cylinder;
  if (const auto* dome = std::get_if<DomeScreen>(&wall.screen->shape)) return *dome;
  if (const auto* sky = std::get_if<Sky>(&wall.screen->shape)) return SkyText{*sky, *wall.sky};
  if (const auto* measured = std::get_if<MeasuredScreen>(&wall.screen->shape)) return *measured;
  return {};
}

std::string shapeText(const Room& room, const CylinderScreen& screen) {
  return fmt::format(
      "shape = \"cylinder\", foot = {}, axis = {}, radius = {}, from_deg = {}, to_deg = {}, bottom = {}, top "
      "= {}",
      vectorIn(room, screen.foot_m), plainVector(screen.axis), lengthIn(room, screen.radius_m),
      plain(glm::degrees(screen.from_rad)), plain(glm::degrees(screen.to_rad)),
      lengthIn(room, screen.bottom_m), lengthIn(room, screen.top_m));
}

/// Returns by how much an axis leans from upright towards its front, and where that front is.
std::string leaningText(const RoomAxes& axes, const glm::dvec3& axis, const glm::dvec3& front) {
  const double upright = glm::dot(axis, axes.up), leaning = -glm::dot(front, axes.up);
  const glm::dvec3 heading = leaning * axis + upright * front;
  return fmt::format(
      "tilt_deg = {}, heading_deg = {}", plain(glm::degrees(std::atan2(leaning, upright))),
      plain(glm::degrees(std::atan2(glm::dot(heading, axes.right), glm::dot(heading, axes.forward)))));
}

std::string shapeText(const Room& room, const DomeScreen& screen) {
  return fmt::format("shape = \"dome\", centre = {}, radius = {}, fov_deg = {}, {}",
                     vectorIn(room, screen.centre_m), lengthIn(room, screen.radius_m),
                     plain(glm::degrees(screen.fov_rad)), leaningText(room.axes, screen.axis, screen.front));
}

std::string shapeText(const Room& room, const SkyText& text) {
  const Sky& sky = text.sky;
  const auto& from_m = text.eyes.from_m;
  return fmt::format("kind = \"{}\", fov_deg = {}, {}{}", kSkyKinds[static_cast<std::size_t>(sky.kind)],
                     plain(glm::degrees(sky.fov_rad)), leaningText(room.axes, sky.axis, sky.front),
                     from_m ? fmt::format(", from = {}", vectorIn(room, *from_m)) : "");
}

std::string shapeText(const Room& room, const MeasuredScreen& screen) {
  const bool isTurned = !isIdentity(screen.roomFromScreen);
  return fmt::format(
      "shape = \"{}\", file = {}, unit = \"{}\"{}{}", screen.isGrid ? "grid" : "mesh",
      tomlText(screen.file.filename().string()), unitName(screen.unit_m),
      screen.isGrid && screen.rows == GridRows::fromTop ? ", rows = \"top\"" : "",
      isTurned ? fmt::format(", room_from_screen = {}", poseIn(room, screen.roomFromScreen)) : "");
}

/// Returns the screen of a wall that a reader has made of a formula or a file.
std::string screenText(const Room& room, const ScreenFormula& shape) {
  std::string text =
      fmt::format("{} = {{ {} }}\n", std::holds_alternative<SkyText>(shape) ? "sky" : "screen",
                  std::visit([&](const auto& known) { return shapeText(room, known); }, shape));
  if (const double sagitta_m = sagittaFor_m(shape); sagitta_m > kUsualSagitta_m)
    text += fmt::format("facet_sagitta = {}\n", lengthIn(room, sagitta_m));
  return text;
}

/// Returns the wall's corners, or its screen.
std::string placeText(const Room& room, const Wall& wall) {
  if (const auto shape = shapeOf(wall)) return screenText(room, *shape);
  return fmt::format("lower_left = {}\nlower_right = {}\nupper_left = {}\n", vectorIn(room, wall.lowerLeft_m),
                     vectorIn(room, wall.lowerRight_m), vectorIn(room, wall.upperLeft_m));
}

std::string wallText(const Room& room, const Wall& wall) {
  std::string part;
  if (wall.viewport) {
    part =
        fmt::format(", viewport = {{ position = [{}, {}], size = [{}, {}] }}", wall.viewport->position_px.x,
                    wall.viewport->position_px.y, wall.viewport->size_px.x, wall.viewport->size_px.y);
  }
  std::string text = fmt::format(
      "\n[[wall]]\nname = {}\n{}pixels = [{}, {}]\nnode = {}\nwindow = {{ {}{} }}\nstereo = \"{}\"\n",
      tomlText(wall.name), placeText(room, wall), wall.pixels.x, wall.pixels.y, wall.node,
      windowText(wall.window), part, toString(wall.stereo));
  if (room.people.size() > 1)
    text += fmt::format("viewer = {}\n", tomlText(room.people[wall.viewer].setup.name));
  if (!wall.eyes.empty()) {
    std::vector<std::string> eyes;
    for (const ViewerEye& eye : wall.eyes) {
      const char* which = eye.eye == Eye::left ? "left" : eye.eye == Eye::right ? "right" : "middle";
      const std::string viewer = room.people.size() > 1 ? room.people[eye.viewer].setup.name + "." : "";
      eyes.push_back(fmt::format("\"{}{}\"", viewer, which));
    }
    text += fmt::format("eyes = [{}]\n", fmt::join(eyes, ", "));
  }
  if (!wall.warp.empty()) text += fmt::format("warp = {}\n", tomlText(wall.warp.filename().string()));
  if (!wall.blend.empty()) text += fmt::format("blend = {}\n", tomlText(wall.blend.filename().string()));
  if (wall.flip != Flip::none) text += fmt::format("flip = \"{}\"\n", toString(wall.flip));
  return text;
}

void shift(CylinderScreen& screen, const glm::dvec3& by_m) { screen.foot_m += by_m; }
void shift(DomeScreen& screen, const glm::dvec3& by_m) { screen.centre_m += by_m; }
void shift(MeasuredScreen& screen, const glm::dvec3& by_m) { screen.roomFromScreen.position_m += by_m; }
void shift(SkyText& text, const glm::dvec3& by_m) {
  text.sky.middle_m += by_m;
  if (text.eyes.from_m) *text.eyes.from_m += by_m;
}

void move(Wall& wall, const glm::dvec3& shift_m, const RoomAxes& axes) {
  wall.lowerLeft_m += shift_m;
  wall.lowerRight_m += shift_m;
  wall.upperLeft_m += shift_m;
  auto shape = shapeOf(wall);
  if (!shape) return;
  std::visit([&](auto& known) { shift(known, shift_m); }, *shape);
  curve({.shape = *shape, .sagitta_m = sagittaFor_m(*shape)}, axes, wall);
}

}  // namespace

void putOnFloor(Room& room) {
  const auto floor_m = floorHeight_m(room);
  const glm::dvec3 up = room.axes.up;
  const double eyes_m = glm::dot(room.viewers.front().eyes_m, up);
  const glm::dvec3 beneath_m =
      room.originUnderViewer ? room.viewers.front().eyes_m - eyes_m * up : glm::dvec3(0.0);
  const glm::dvec3 shift_m = -beneath_m + (floor_m ? -*floor_m : kStandingEyes_m - eyes_m) * up;
  for (RoomWall& wall : room.walls) move(wall.wall, shift_m, room.axes);
  for (Viewer& viewer : room.viewers) viewer.eyes_m += shift_m;
  for (TrackerSetup& tracker : room.trackers) tracker.roomFromTracker.position_m += shift_m;
  room.floor_m = 0.0;
  if (!floor_m) {
    room.assumptions.push_back(
        fmt::format("no wall is a floor; the viewer's eyes are {:.0f} mm above it", kStandingEyes_m * 1e3));
  }
  if (glm::length(shift_m) > 0.0) {
    room.assumptions.push_back(
        fmt::format("everything is moved by {} {}, so that the origin is on the floor{}",
                    vectorIn(room, shift_m), room.unit, room.originUnderViewer ? " beneath the viewer" : ""));
  }
}

void keepDisplays(Room& room) {
  std::set<std::string> displays;
  const bool hasHosts = std::any_of(room.nodes.begin(), room.nodes.end(),
                                    [](const NodeSetup& node) { return !node.host.empty(); });
  for (const NodeSetup& node : room.nodes) displays.insert(node.display);
  if (hasHosts || displays.size() > 1) {
    const auto isPlain = [](const NodeSetup& node) { return node.host.empty() && node.display.empty(); };
    for (const NodeSetup& node : room.nodes) {
      if (isPlain(node))
        room.assumptions.push_back(
            fmt::format("rank {} is drawn where it is started: the file names no other computer", node.rank));
    }
    std::erase_if(room.nodes, isPlain);
    return;
  }
  if (!displays.empty()) {
    room.assumptions.push_back(
        fmt::format("every rank draws on the display that it finds: the file names {} for all of them",
                    *displays.begin()));
  }
  room.nodes.clear();
}

void simulateUntracked(Room& room) {
  if (room.people.empty()) {
    Person person;
    person.setup.head.eyeSeparation_m = room.eyeSeparation_m;
    room.people.push_back(std::move(person));
  }
  std::set<std::pair<std::size_t, int>> taken;
  std::size_t simulated = 0;
  for (std::size_t i = 0; i < room.people.size(); ++i) {
    Person& person = room.people[i];
    const SensorChoice sensor = person.setup.head.sensor;
    if (person.isTracked && taken.emplace(sensor.tracker, sensor.sensor).second) continue;
    constexpr double kApart_m = 0.6;  // two people do not stand in one place
    TrackerSetup tracker;
    tracker.name = room.people.size() == 1 ? "person" : "person-" + person.setup.name;
    while (std::any_of(room.trackers.begin(), room.trackers.end(),
                       [&](const TrackerSetup& other) { return other.name == tracker.name; }))
      tracker.name += "-2";
    tracker.seed = i + 1;
    tracker.roomFromTracker.position_m = room.viewers[std::min(i, room.viewers.size() - 1)].eyes_m -
                                         kStandingEyes_m * room.axes.up +
                                         kApart_m * static_cast<double>(simulated++) * room.axes.right;
    room.trackers.push_back(std::move(tracker));
    person.setup.head.sensor = {room.trackers.size() - 1, 0};
    person.setup.head.eyesFromSensor = {};
    room.assumptions.push_back(
        room.people.size() == 1
            ? std::string(
                  "no tracker of the head is taken over: a simulated person walks about where the viewer is")
            : fmt::format("{} has no tracker of their own here: a simulated person walks about for them",
                          person.setup.name));
    if (simulated > 1)
      room.assumptions.push_back(
          fmt::format("the simulated person of {} stands {} m to the right of the one before",
                      person.setup.name, kApart_m));
  }
}

std::string rigText(const Room& room) {
  std::string text = fmt::format("# Made of {} by carom import. What it assumed:\n",
                                 printable(room.file.filename().string()));
  for (const std::string& assumption : room.assumptions) text += fmt::format("# - {}\n", assumption);
  if (!room.findings.empty()) text += "# What of the file it left out, or found doubtful:\n";
  for (const Finding& finding : room.findings) {
    text += fmt::format("# - line {}: {}{}\n", finding.at.line, finding.text,
                        finding.count > 1 ? fmt::format(" (and {} more alike)", finding.count - 1) : "");
  }
  const bool zUp = room.axes.up.z > 0.5;
  text += fmt::format("title = {}\nunit = \"{}\"\naxes = \"{}\"\ndisplay_hz = 60.0\n", tomlText(room.title),
                      room.unit, zUp ? "x-right y-forward z-up" : "x-right y-up z-back");
  if (room.oneWindow) {
    const WindowPlacement& window = *room.oneWindow;
    text +=
        fmt::format("\n[one_window]\nmonitor = {}\nposition = [{}, {}]\nsize = [{}, {}]\nfullscreen = {}\n",
                    window.monitor, window.position_px.x, window.position_px.y, window.size_px.x,
                    window.size_px.y, window.fullscreen);
  }
  text += peopleText(room) + trackersText(room) + nodesText(room);
  for (const RoomWall& wall : room.walls) text += wallText(room, wall.wall);
  return text;
}

}  // namespace carom
