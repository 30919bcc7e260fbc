#include "app/cave_formats/hevs_screen.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>
#include <string_view>

#include "app/rig/rig_screen.h"
#include "app/room_checks/foreign_room.h"

namespace carom {
namespace {

constexpr Range kLength_m{.least = 0.1, .most = 100.0};  // of a radius or height
constexpr double kTurn_rad = 2.0 * std::numbers::pi;

/// Returns an object's transform as the file has it, or null.
const Part* transformOf(const Part& object, const Part& platform, Room& room) {
  const Part* own = object.find("transform");
  if (!own || !own->parts.empty() || own->text.empty()) return own;
  const Part* all = platform.find("transforms");
  const Part* named = all ? all->find(own->text) : nullptr;
  if (!named) addError(room, own->textAt, fmt::format("there is no transform '{}'", printable(own->text)));
  return named;
}

/// Returns a required length of a display.
std::optional<double> length_m(const Part& display, std::string_view name, Room& room) {
  if (!display.find(name))
    addError(room, display.at, fmt::format("{} is missing in display '{}'", name, printable(display.name)));
  return number(display, name, kLength_m, false, room);
}

/// Returns the angle about an axis from one direction to another, positive to the right of the first.
double rightwards_rad(const glm::dvec3& from, const glm::dvec3& to, const glm::dvec3& axis) {
  return std::atan2(glm::dot(to, glm::cross(from, axis)), glm::dot(to, from));
}

/// Names what shows a dome that a rig's dome does not; returns whether there is any.
bool needsCalibration(const Part& display, Room& room) {
  const auto leaveOut = [&](const Part& part, std::string_view why) {
    addWarning(room, part.at,
               fmt::format("display '{}' of type 'dome' is left out: {}", printable(display.name), why));
    return true;
  };
  if (const Part* several = display.find("projectors"); several && several->parts.size() > 1)
    return leaveOut(*several, "several projectors show it by their calibration");
  if (number(display, "projector_count", {.least = 1.0, .most = 64.0}, true, room).value_or(1.0) > 1.0)
    return leaveOut(*display.find("projector_count"), "several projectors show it by their calibration");
  for (const char* file : {"vioso_path", "warp_mesh_path", "warp_path"}) {
    const Part* found = display.find(file);
    if (found && !found->text.empty())
      return leaveOut(*found,
                      fmt::format("its projectors are calibrated by {} '{}'", file, printable(found->text)));
  }
  return false;
}

}  // namespace

Pose hevsPlaceOf(const Part& object, const Part& platform, Room& room) {
  Pose place;
  const Part* transform = transformOf(object, platform, room);
  if (!transform) return place;
  transform->isRead = true;
  if (const Part* translate = transform->find("translate")) {
    if (const auto moved = arrayOf(*translate, 3, room))
      place.position_m = {(*moved)[0], (*moved)[1], -(*moved)[2]};
  }
  if (const Part* rotate = transform->find("rotate")) {
    // Mirrored from z forward to z back, turns about x and y change their sense.
    if (const auto turned_deg = arrayOf(*rotate, 3, room)) {
      const glm::dvec3 turn = glm::radians(glm::dvec3((*turned_deg)[0], (*turned_deg)[1], (*turned_deg)[2]));
      place.orientation = glm::angleAxis(-turn.y, glm::dvec3(0, 1, 0)) *
                          glm::angleAxis(-turn.x, glm::dvec3(1, 0, 0)) *
                          glm::angleAxis(turn.z, glm::dvec3(0, 0, 1));
    }
  }
  if (const Part* scale = transform->find("scale")) {
    const auto by = arrayOf(*scale, 3, room);
    if (by && *by != std::vector<double>{1.0, 1.0, 1.0})
      addWarning(room, scale->textAt,
                 fmt::format("the scale of '{}' is left out: lengths are metres", printable(object.name)));
  }
  return place;
}

std::optional<CylinderScreen> hevsCylinder(const Part& display, const Pose& place, Room& room) {
  constexpr Range kAngle_deg{.least = -360.0, .most = 360.0};
  std::array<std::optional<double>, 2> angles_deg;
  constexpr std::array<std::string_view, 2> kNames{"angle_start", "angle_end"};
  for (std::size_t i = 0; i < 2; ++i) {
    if (!display.find(kNames[i]))
      addError(room, display.at,
               fmt::format("{} is missing in display '{}'", kNames[i], printable(display.name)));
    angles_deg[i] = number(display, kNames[i], kAngle_deg, false, room);
  }
  const auto radius_m = length_m(display, "radius", room), height_m = length_m(display, "height", room);
  const auto foot_m = number(display, "ground_offset", {.least = -100.0, .most = 100.0}, false, room);
  for (const char* ofDrawing : {"slices", "rendertarget_stretch_factor"}) display.find(ofDrawing);
  if (!angles_deg[0] || !angles_deg[1] || !radius_m || !height_m) return {};
  const double turn_deg = std::abs(*angles_deg[1] - *angles_deg[0]);
  if (!(turn_deg >= 1.0 && turn_deg <= 360.0)) {
    addError(room, display.placeOf("angle_end"),
             fmt::format("the display turns by {:g}° from angle_start to angle_end, expected 1 to 360°",
                         turn_deg));
    return {};
  }
  if (*angles_deg[1] < *angles_deg[0])
    addWarning(
        room, display.placeOf("angle_end"),
        fmt::format("angle_end is left of angle_start: the display is taken {:g}° to the right of it, as "
                    "HEVS draws it",
                    turn_deg));
  CylinderScreen screen;
  screen.foot_m = place.position_m;
  screen.axis = place.orientation * glm::dvec3(0, 1, 0);
  screen.ahead = aheadOf(screen.axis, room.axes);
  screen.radius_m = *radius_m;
  screen.bottom_m = foot_m.value_or(0.0);
  screen.top_m = screen.bottom_m + *height_m;
  const double ahead_rad =
      rightwards_rad(screen.ahead, place.orientation * glm::dvec3(0, 0, -1), screen.axis);
  screen.from_rad = std::remainder(ahead_rad + glm::radians(*angles_deg[0]), kTurn_rad);
  if (screen.from_rad + glm::radians(turn_deg) > kTurn_rad) screen.from_rad -= kTurn_rad;
  screen.to_rad = screen.from_rad + glm::radians(turn_deg);
  if (!foot_m)
    room.assumptions.push_back(fmt::format(
        "the file gives no height of the foot of the curved display '{}': it is at the origin's, line {}",
        printable(display.name), display.at.line));
  return screen;
}

std::optional<DomeScreen> hevsDome(const Part& display, const Pose& place, Room& room) {
  if (needsCalibration(display, room)) {
    display.markRead();
    return {};
  }
  const auto radius_m = length_m(display, "radius", room);
  if (!radius_m) return {};
  DomeScreen screen;
  screen.centre_m = place.position_m;
  screen.radius_m = *radius_m;
  screen.axis = place.orientation * glm::dvec3(0, 0, -1);
  screen.front = place.orientation * glm::dvec3(0, -1, 0);
  constexpr double kLevel = 1e-3;
  if (std::abs((place.orientation * glm::dvec3(1, 0, 0)).y) > kLevel) {
    const Part* transform = display.find("transform");
    addWarning(
        room, transform->at,
        fmt::format("display '{}' of type 'dome' is left out: its transform leans it to the side, which no "
                    "rig says",
                    printable(display.name)));
    return {};
  }
  room.assumptions.push_back(fmt::format("dome '{}' is half a sphere, as HEVS draws domes, line {}",
                                         printable(display.name), display.at.line));
  return screen;
}

}  // namespace carom
