#include "app/room_import/sgct_sky.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>
#include <optional>

#include "app/rig/rig_screen.h"
#include "app/room_import/sgct_values.h"

namespace carom {
namespace {

using Kind = JsonNode::Kind;

constexpr std::array<std::string_view, 4> kTypes{"FisheyeProjection", "EquirectangularProjection",
                                                 "CylindricalProjection", "SphericalMirrorProjection"};
constexpr std::array<std::string_view, 11> kFisheyeKeys{"type",   "fov",        "quality", "interpolation",
                                                        "tilt",   "diameter",   "crop",    "keepaspectratio",
                                                        "offset", "background", "method"};
constexpr std::array<std::string_view, 2> kEquirectangularKeys{"type", "quality"};
constexpr std::array<std::string_view, 5> kCylinderKeys{"type", "quality", "rotation", "heightoffset",
                                                        "radius"};
constexpr std::array<std::string_view, 5> kMirrorKeys{"type", "quality", "tilt", "background", "geometry"};
constexpr Range kAngle_deg{.least = -360.0, .most = 360.0};

const SgctUser& userOf(const JsonNode& viewport, const SgctReading& in) {
  const JsonNode* name = viewport.member("user");
  const auto named = std::find_if(in.users.begin(), in.users.end(),
                                  [&](const SgctUser& user) { return name && user.name == name->text; });
  return named == in.users.end() ? in.users.front() : *named;
}

/// Returns a picture whose axis leans forward from upright by `tilt_rad`, seen from the user's place, or from
/// the tracked head in a viewport that is tracked.
SkyText skyOf(const JsonNode& viewport, SkyKind kind, double tilt_rad, SgctReading& in) {
  const RoomAxes& axes = in.room.axes;
  SkyText text;
  text.sky.kind = kind;
  text.sky.axis = std::cos(tilt_rad) * axes.up + std::sin(tilt_rad) * axes.forward;
  text.sky.front = std::cos(tilt_rad) * axes.forward - std::sin(tilt_rad) * axes.up;
  text.sky.middle_m = userOf(viewport, in).eyes_m;
  text.eyes.right = axes.right;
  if (!flag(viewport, "tracked", in.room)) text.eyes.from_m = text.sky.middle_m;
  return text;
}

/// Reads the angle by which the axis leans forward; returns nothing if it is wrong.
std::optional<double> readTilt_rad(const JsonNode& projection, Room& room) {
  const auto tilt_deg = number(projection, "tilt", kAngle_deg, false, room);
  if (projection.member("tilt") && !tilt_deg) return {};
  return glm::radians(tilt_deg.value_or(0.0));
}

void noteLeftOut(const JsonNode& projection, std::initializer_list<std::string_view> keys, Room& room) {
  for (const std::string_view key : keys) noteIgnored(projection, key, "no rig says it", room);
}

/// SGCT's angle from the axis is in proportion to the distance from the circle's middle, and its front is at
/// the bottom (FisheyeProjection of SGCT 3).
std::optional<ScreenFormula> readFisheye(const JsonNode& viewport, const JsonNode& projection,
                                         SgctReading& in) {
  constexpr double kUsualFov_deg = 180.0;
  constexpr Range kFov_deg{.least = 0.0, .most = 359.0, .above = true};
  noteUnknown(projection, kFisheyeKeys, in.room);
  const auto tilt_rad = readTilt_rad(projection, in.room);
  const auto fov_deg = number(projection, "fov", kFov_deg, false, in.room);
  if (!tilt_rad || (projection.member("fov") && !fov_deg)) return {};
  noteLeftOut(projection, {"crop", "keepaspectratio", "offset", "background", "diameter"}, in.room);
  SkyText text = skyOf(viewport, SkyKind::fisheye, *tilt_rad, in);
  text.sky.fov_rad = glm::radians(fov_deg.value_or(kUsualFov_deg));
  return text;
}

/// SGCT lays one turn across the window, straight ahead at its left edge and the right after it, and heights
/// of one radius up the window (CylindricalProjection of SGCT 3).
std::optional<ScreenFormula> readCylinder(const JsonNode& viewport, const JsonNode& projection,
                                          SgctReading& in) {
  constexpr double kUsualRadius_m = 5.0;
  noteUnknown(projection, kCylinderKeys, in.room);
  const auto turn_deg = number(projection, "rotation", kAngle_deg, false, in.room);
  const auto rise = number(projection, "heightoffset", {.least = -100.0, .most = 100.0}, false, in.room);
  const auto radius_m = number(projection, "radius", {.least = 0.1, .most = 100.0}, false, in.room);
  for (const auto& [key, value] :
       {std::pair{"rotation", turn_deg}, {"heightoffset", rise}, {"radius", radius_m}}) {
    if (projection.member(key) && !value) return {};
  }
  CylinderScreen screen;
  screen.foot_m = userOf(viewport, in).eyes_m;
  screen.axis = in.room.axes.up;
  screen.ahead = in.room.axes.forward;
  screen.radius_m = radius_m.value_or(kUsualRadius_m);
  screen.bottom_m = rise.value_or(0.0) * screen.radius_m;
  screen.top_m = screen.bottom_m + screen.radius_m;
  screen.from_rad = std::remainder(glm::radians(-turn_deg.value_or(0.0)), 2.0 * std::numbers::pi);
  if (screen.from_rad > 0.0) screen.from_rad -= 2.0 * std::numbers::pi;
  screen.to_rad = screen.from_rad + 2.0 * std::numbers::pi;
  in.room.assumptions.push_back(fmt::format(
      "the cylinder of line {} stands round the user, {:g} m away, its front at the window's left edge",
      projection.at.line, screen.radius_m));
  return screen;
}

/// SGCT bends each of four flat pictures by a mesh of its own; what a spherical mirror shows on a dome is a
/// fisheye picture bent by one mesh.
std::optional<ScreenFormula> readMirror(const JsonNode& viewport, const JsonNode& projection,
                                        SgctReading& in) {
  noteUnknown(projection, kMirrorKeys, in.room);
  const auto tilt_rad = readTilt_rad(projection, in.room);
  if (!tilt_rad) return {};
  noteLeftOut(projection, {"background"}, in.room);
  const JsonNode* meshes = member(projection, "geometry", Kind::object, "an object", in.room);
  std::string names;
  if (meshes) {
    for (const JsonNode& mesh : meshes->children)
      names += fmt::format("{}{} '{}'", names.empty() ? "" : ", ", mesh.key, printable(mesh.text));
  }
  addWarning(
      in.room, meshes ? meshes->at : projection.at,
      fmt::format("SGCT bends four pictures by four meshes{}: the sky here is one picture, which wants "
                  "the mirror's one mesh (Paul Bourke's .data) as warp in the rig",
                  names.empty() ? "" : " (" + names + ")"));
  return skyOf(viewport, SkyKind::fisheye, *tilt_rad, in);
}

std::optional<ScreenFormula> readShape(std::string_view type, const JsonNode& viewport,
                                       const JsonNode& projection, SgctReading& in) {
  if (type == kTypes[0]) return readFisheye(viewport, projection, in);
  if (type == kTypes[2]) return readCylinder(viewport, projection, in);
  if (type == kTypes[3]) return readMirror(viewport, projection, in);
  noteUnknown(projection, kEquirectangularKeys, in.room);
  return skyOf(viewport, SkyKind::equirectangular, 0.0, in);
}

}  // namespace

bool isSgctSky(std::string_view type) {
  return std::find(kTypes.begin(), kTypes.end(), type) != kTypes.end();
}

bool readSgctSky(const JsonNode& viewport, const JsonNode& projection, RoomWall& wall, SgctReading& in) {
  const JsonNode& type = *projection.member("type");
  const auto shape = readShape(type.text, viewport, projection, in);
  if (!shape) return false;
  ScreenText text;
  text.shape = *shape;
  text.sagitta_m = sagittaFor_m(*shape);
  if (!curve(text, in.room.axes, wall.wall)) return true;
  addError(in.room, type.at,
           fmt::format("the {} takes more flat pieces than a rig may have", printable(type.text)));
  return false;
}

}  // namespace carom
