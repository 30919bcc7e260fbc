#include "app/room_import/sgct_planar.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/trigonometric.hpp>
#include <optional>
#include <string_view>

#include "app/room_checks/wall_shape.h"
#include "app/room_import/sgct_values.h"

namespace carom {
namespace {

using Kind = JsonNode::Kind;

constexpr double kUsualDistance_m = 10.0;  // SGCT's own
constexpr Range kHalf_deg{.least = -89.0, .most = 89.0};
constexpr Range kWhole_deg{.least = 0.0, .most = 178.0, .above = true};
constexpr std::array<std::string_view, 5> kPlanarKeys{"type", "fov", "distance", "orientation", "offset"};
constexpr std::array<std::string_view, 7> kFovKeys{"hfov", "vfov", "left", "right", "down", "up", "distance"};
constexpr std::array<std::string_view, 7> kTurnKeys{"yaw", "pitch", "roll", "x", "y", "z", "w"};

/// Angles from the screen's middle axis to two opposite edges.
struct Angles {
  double low_deg = 0.0, high_deg = 0.0;
};

/// Reads `whole`, which is symmetric, and then `low` and `high`, which take precedence.
std::optional<Angles> readAngles(const JsonNode& fov, std::string_view whole, std::string_view low,
                                 std::string_view high, Room& room) {
  const auto both = number(fov, whole, kWhole_deg, false, room);
  const auto toLow = number(fov, low, kHalf_deg, false, room),
             toHigh = number(fov, high, kHalf_deg, false, room);
  for (const std::string_view key : {whole, low, high}) {
    if (fov.member(key) && !number(fov, key, key == whole ? kWhole_deg : kHalf_deg, false, room)) return {};
  }
  if (!both && !(toLow && toHigh)) {
    addError(room, fov.at, fmt::format("{}, or {} and {}, is missing in fov", whole, low, high));
    return {};
  }
  const double half_deg = both.value_or(0.0) / 2.0;
  const Angles angles{toLow.value_or(half_deg), toHigh.value_or(half_deg)};
  if (angles.low_deg + angles.high_deg > 0.0) return angles;
  addError(room, fov.at,
           fmt::format("{} and {} of fov together are {} degrees, expected above 0", low, high,
                       angles.low_deg + angles.high_deg));
  return {};
}

/// Reads the orientation: turned by -yaw about y, then about its own x by pitch, then about its own z by
/// -roll; or a quaternion.
std::optional<glm::dquat> readTurn(const JsonNode& projection, Room& room) {
  const JsonNode* turn = member(projection, "orientation", Kind::object, "an object", room);
  if (!turn) return projection.member("orientation") ? std::nullopt : std::optional(glm::dquat(1, 0, 0, 0));
  noteUnknown(*turn, kTurnKeys, room);
  const bool isQuaternion = turn->member("w") != nullptr;
  std::array<double, 4> values{};
  for (std::size_t i = 0; i < (isQuaternion ? 4U : 3U); ++i) {
    const std::string_view key = kTurnKeys[isQuaternion ? 3 + i : i];
    const auto value = number(*turn, key, {.least = -360.0, .most = 360.0}, false, room);
    if (!value && !turn->member(key))
      addError(room, turn->at, fmt::format("{} is missing in orientation", key));
    if (!value) return {};
    values[i] = *value;
  }
  if (!isQuaternion) {
    return glm::angleAxis(glm::radians(-values[0]), glm::dvec3(0, 1, 0)) *
           glm::angleAxis(glm::radians(values[1]), glm::dvec3(1, 0, 0)) *
           glm::angleAxis(glm::radians(-values[2]), glm::dvec3(0, 0, 1));
  }
  const glm::dquat q(values[3], values[0], values[1], values[2]);
  const double length = glm::length(q);
  if (length > 0.9 && length < 1.1) return glm::normalize(q);
  addError(room, turn->at,
           fmt::format("the quaternion has length {:.3g}, expected a rotation, of length 1", length));
  return {};
}

std::optional<double> readDistance(const JsonNode& projection, const JsonNode& fov, Room& room) {
  const JsonNode& holder = projection.member("distance") ? projection : fov;
  if (!holder.member("distance")) return kUsualDistance_m;
  return number(holder, "distance", {.least = 0.01, .most = 1000.0}, false, room);
}

}  // namespace

/// SGCT puts the screen at the distance along -z, turns it about the origin and then moves it by the offset
/// (BaseViewport::setViewPlaneCoordsUsingFOVs and ProjectionPlane::offset of SGCT 3).
bool readPlanar(const JsonNode& projection, RoomWall& wall, SgctReading& in) {
  noteUnknown(projection, kPlanarKeys, in.room);
  const JsonNode* fov = member(projection, "fov", Kind::object, "an object", in.room);
  if (!fov) {
    if (!projection.member("fov")) addError(in.room, projection.at, "fov is missing in projection");
    return false;
  }
  noteUnknown(*fov, kFovKeys, in.room);
  const auto across = readAngles(*fov, "hfov", "left", "right", in.room);
  const auto up = readAngles(*fov, "vfov", "down", "up", in.room);
  const auto distance_m = readDistance(projection, *fov, in.room);
  const auto turn = readTurn(projection, in.room);
  const auto offset = numbers<3>(projection, "offset", {}, false, in.room);
  if (!across || !up || !distance_m || !turn || (projection.member("offset") && !offset)) return false;
  const glm::dvec3 moved_m = offset ? glm::dvec3((*offset)[0], (*offset)[1], (*offset)[2]) : glm::dvec3(0.0);
  const auto corner = [&](double x_deg, double y_deg) {
    const glm::dvec3 onScreen(std::tan(glm::radians(x_deg)), std::tan(glm::radians(y_deg)), -1.0);
    return *turn * (*distance_m * onScreen) + moved_m;
  };
  wall.wall.lowerLeft_m = corner(-across->low_deg, -up->low_deg);
  wall.wall.lowerRight_m = corner(across->high_deg, -up->low_deg);
  wall.wall.upperLeft_m = corner(-across->low_deg, up->high_deg);
  addWarning(in.room, projection.member("type")->at,
             fmt::format(
                 "a PlanarProjection gives angles and no place: its screen is taken as SGCT draws it, {:.2f} "
                 "× {:.2f} m, {:.4g} m from the origin; a tracked person needs the corners of the real "
                 "screen, by a ProjectionPlane or in the rig",
                 width_m(wall.wall), height_m(wall.wall), *distance_m));
  return true;
}

}  // namespace carom
