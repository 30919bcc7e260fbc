#include "app/room_import/sgct_viewport.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <optional>
#include <string_view>

#include "app/room_checks/room_check.h"
#include "app/room_import/sgct_planar.h"
#include "app/room_import/sgct_sky.h"
#include "app/room_import/sgct_values.h"
#include "cave/room/rectangle.h"

namespace carom {
namespace {

using Kind = JsonNode::Kind;

constexpr std::size_t kMostWalls = 512;
constexpr double kRounding = 1e-6;  // of a window: files write thirds with some digits
constexpr std::array<std::string_view, 3> kSgctCorners{"lowerleft", "upperleft", "upperright"};
constexpr std::array<std::string_view, 10> kViewportKeys{
    "pos", "size", "projection", "overlay", "blendmask", "mesh", "tracked", "eye", "user", "blacklevelmask"};
constexpr std::array<std::string_view, 4> kPlaneKeys{"type", "lowerleft", "upperleft", "upperright"};

StereoMode eyeOf(const JsonNode& viewport, const SgctWindow& window, SgctReading& in) {
  const JsonNode* eye = member(viewport, "eye", Kind::text, "a text", in.room);
  if (!eye || eye->text == "center") return window.stereo;
  if (eye->text == "left") return StereoMode::left;
  if (eye->text == "right") return StereoMode::right;
  addWarning(in.room, eye->at,
             fmt::format("eye is '{}', taken as both, expected 'center' or 'left' or 'right'",
                         printable(eye->text)));
  return window.stereo;
}

void checkUser(const JsonNode& viewport, SgctReading& in) {
  const JsonNode* user = member(viewport, "user", Kind::text, "a text", in.room);
  if (!user) return;
  const auto known =
      std::find_if(in.users.begin(), in.users.end(), [&](const SgctUser& u) { return u.name == user->text; });
  if (known == in.users.end()) {
    addWarning(in.room, user->at,
               fmt::format("there is no user '{}'; the first is taken", printable(user->text)));
  }
}

/// Reads a viewport's position and size, which SGCT gives as fractions of the window from its lower left
/// corner.
bool readPlace(const JsonNode& viewport, const SgctWindow& window, Wall& wall, SgctReading& in) {
  const auto position = numbers<2>(viewport, "pos", {.least = 0.0, .most = 1.0}, false, in.room);
  const auto size = numbers<2>(viewport, "size", {.least = 0.0, .most = 1.0, .above = true}, false, in.room);
  if ((viewport.member("pos") && !position) || (viewport.member("size") && !size)) return false;
  const glm::dvec2 low = position ? glm::dvec2((*position)[0], (*position)[1]) : glm::dvec2(0.0);
  const glm::dvec2 part = size ? glm::dvec2((*size)[0], (*size)[1]) : glm::dvec2(1.0);
  const glm::dvec2 high = low + part;
  if (high.x > 1.0 + kRounding || high.y > 1.0 + kRounding) {
    addError(in.room, viewport.at,
             fmt::format("this viewport reaches to ({:.4g}, {:.4g}) of its window, expected at most 1",
                         high.x, high.y));
    return false;
  }
  // Edges are rounded, not sizes, so that viewports that share an edge share it in pixels, too.
  const glm::dvec2 topLeft(low.x, std::max(0.0, 1.0 - high.y));
  const glm::dvec2 bottomRight(std::min(1.0, high.x), 1.0 - low.y);
  const auto edge = [](const glm::dvec2& whole_px, const glm::dvec2& at) {
    return glm::ivec2(glm::round(whole_px * at));
  };
  const auto between = [&](const glm::dvec2& whole_px) {
    return glm::max(edge(whole_px, bottomRight) - edge(whole_px, topLeft), glm::ivec2(1));
  };
  wall.pixels = between(window.picture_px);
  wall.window.monitor = window.monitor;
  wall.window.size_px = between(window.size_px);
  wall.window.position_px = glm::ivec2(window.position_px) +
                            glm::min(edge(window.size_px, topLeft), glm::ivec2(window.size_px) - 1);
  wall.window.fullscreen = window.fullscreen && part == glm::dvec2(1.0);
  return true;
}

bool readPlane(const JsonNode& projection, RoomWall& wall, SgctReading& in) {
  noteUnknown(projection, kPlaneKeys, in.room);
  std::array<std::optional<std::array<double, 3>>, 3> read;
  bool sound = true;
  for (std::size_t i = 0; i < 3; ++i) {
    read[i] = numbers<3>(projection, kSgctCorners[i], {}, false, in.room);
    if (!projection.member(kSgctCorners[i])) {
      addError(in.room, projection.at, fmt::format("{} is missing in projection", kSgctCorners[i]));
    }
    sound = sound && read[i];
  }
  if (!sound) return false;
  const auto corner = [&](std::size_t i) { return glm::dvec3((*read[i])[0], (*read[i])[1], (*read[i])[2]); };
  const ThreeCorners corners{{corner(0), corner(1), corner(2)}, kSgctCorners, false};
  wall.wall.lowerLeft_m = corner(0);
  wall.wall.upperLeft_m = corner(1);
  wall.wall.lowerRight_m = corner(0) + (corner(2) - corner(1));
  wall.at.corner = projection.member("upperright")->at;
  if (const auto fault = rectangleFault("of this viewport", corners)) {
    addError(in.room, projection.member(kSgctCorners[fault->corner])->at, fault->what);
    return false;
  }
  return true;
}

/// Reads what a viewport shows into a wall that has its pixels already.
bool readProjection(const JsonNode& viewport, const JsonNode& projection, RoomWall& wall, SgctReading& in) {
  const JsonNode* type = member(projection, "type", Kind::text, "a text", in.room);
  if (!type) {
    if (!projection.member("type")) addError(in.room, projection.at, "type is missing in projection");
    return false;
  }
  if (type->text == "ProjectionPlane") return readPlane(projection, wall, in);
  if (type->text == "PlanarProjection") return readPlanar(projection, wall, in);
  if (isSgctSky(type->text)) return readSgctSky(viewport, projection, wall, in);
  addWarning(in.room, type->at,
             fmt::format("a projection of type '{}' shows no wall: this viewport is left out, expected a "
                         "plane, fisheye, cylinder, equirectangular picture or spherical mirror",
                         printable(type->text)));
  return false;
}

/// SGCT names no walls.
std::string_view nameOf(const Wall& wall, const Room& room) {
  if (wall.sky) return "sky";
  return wall.screen ? "cylinder" : sideOf(wall, room.axes);
}

}  // namespace

void readViewport(const JsonNode& node, const SgctWindow& window, SgctReading& in) {
  if (!isObject(node, "a viewport", in.room)) return;
  noteUnknown(node, kViewportKeys, in.room);
  for (const std::string_view key : {"overlay", "blendmask", "blacklevelmask", "mesh"}) {
    noteIgnored(node, key, "put the projector's warp and blend into the rig by hand", in.room);
  }
  const JsonNode* projection = member(node, "projection", Kind::object, "an object", in.room);
  if (!projection) {
    if (!node.member("projection")) {
      addWarning(in.room, node.at,
                 "this viewport has no projection, so nothing says which wall it shows: it is left out");
    }
    return;
  }
  RoomWall wall;
  wall.at = {
      .wall = node.at,
      .name = node.at,
      .corner = projection->at,
      .pixels = (window.node.member("res") ? window.node.member("res") : window.node.member("size"))->at,
      .node = node.at,
      .window = window.node.at,
      .blend = node.at};
  wall.wall.node = window.rank;
  wall.wall.flip = window.flip;
  wall.wall.stereo = eyeOf(node, window, in);
  checkUser(node, in);
  if (!readPlace(node, window, wall.wall, in) || !readProjection(node, *projection, wall, in)) return;
  if (in.room.walls.size() == kMostWalls) {
    return addError(in.room, node.at, fmt::format("there are more than {} walls", kMostWalls));
  }
  wall.wall.name = rigName(in.room, nameOf(wall.wall, in.room));
  in.room.walls.push_back(std::move(wall));
  in.ofWindow.push_back(in.windows);
  in.places.push_back({window.position_px, window.size_px, window.monitor, window.fullscreen});
}

}  // namespace carom
