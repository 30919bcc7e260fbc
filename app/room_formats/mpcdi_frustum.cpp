#include "app/room_formats/mpcdi_frustum.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <glm/trigonometric.hpp>
#include <string>
#include <string_view>

#include "app/room_checks/foreign_room.h"
#include "devices/setup/tracker_setup.h"
#include "engine/base/pose.h"
#include "engine/text/printable.h"

namespace carom {
namespace {

/// Returns where a region's frustum begins and how its axes stand: at the origin if nothing is said.
std::optional<Pose> frameOf(const Part& region, Room& room) {
  const Part* frame = region.find("coordinateFrame");
  if (!frame) return Pose{};
  constexpr Range kFar{.least = -1e4, .most = 1e4};
  std::array<glm::dvec3, 4> values{};
  constexpr std::array<std::string_view, 4> kAxes{"pos", "yaw", "pitch", "roll"};
  for (std::size_t i = 0; i < kAxes.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      const std::string name = fmt::format("{}{}", kAxes[i], "xyz"[axis]);
      const auto value = number(*frame, name, kFar, false, room);
      if (!value && !frame->find(name))
        addError(room, frame->at, fmt::format("{} is missing in coordinateFrame", name));
      if (!value) return {};
      values[i][axis] = *value;
    }
  }
  const auto turn = rotationOf(glm::dmat3(values[2], -values[1], -values[3]));
  if (turn) return Pose{values[0], *turn};
  addError(room, frame->at,
           "the axes of coordinateFrame are no rotation, expected yaw down, pitch to the right and "
           "roll forward at right angles");
  return {};
}

}  // namespace

std::optional<glm::ivec2> mpcdiPixels(const Part& region, Room& room) {
  constexpr Range kPixels{.least = 1.0, .most = kMostRoomPixels};
  const bool isCapital = region.find("Xresolution") != nullptr;
  const auto x = number(region, isCapital ? "Xresolution" : "xResolution", kPixels, true, room),
             y = number(region, isCapital ? "Yresolution" : "yResolution", kPixels, true, room);
  if (x && y) return glm::ivec2(static_cast<int>(*x), static_cast<int>(*y));
  if (!room.hasErrors())
    addError(room, region.at, "xResolution or yResolution is missing in region, expected both");
  return {};
}

std::optional<ReadCorners> cornersByAngles(const Part& region, Room& room) {
  constexpr Range kAngle{.least = -89.0, .most = 89.0}, kTurn{.least = -360.0, .most = 360.0};
  const Part* frustum = region.find("frustum");
  if (!frustum) {
    addError(room, region.at,
             fmt::format("region '{}' has no frustum, expected one", printable(region.textOf("id"))));
    return {};
  }
  std::array<std::optional<double>, 7> angles_deg;
  constexpr std::array<const char*, 7> kNames{"leftAngle", "rightAngle", "downAngle", "upAngle",
                                              "yaw",       "pitch",      "roll"};
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    angles_deg[i] = number(*frustum, kNames[i], i < 4 ? kAngle : kTurn, false, room);
    if (angles_deg[i]) continue;
    if (!frustum->find(kNames[i]))
      addError(room, frustum->at, fmt::format("{} is missing in frustum", kNames[i]));
    return {};
  }
  const auto frame = frameOf(region, room);
  if (!frame) return {};
  if (!(*angles_deg[0] < *angles_deg[1] && *angles_deg[2] < *angles_deg[3])) {
    addError(room, frustum->at, "the angles leave no picture, expected left below right and down below up");
    return {};
  }
  // Yaw to the right, pitch upwards, roll with the left side up: SAE's order, each about the turned axes.
  const glm::dquat turn = glm::angleAxis(glm::radians(-*angles_deg[4]), glm::dvec3(0, 1, 0)) *
                          glm::angleAxis(glm::radians(*angles_deg[5]), glm::dvec3(1, 0, 0)) *
                          glm::angleAxis(glm::radians(-*angles_deg[6]), glm::dvec3(0, 0, 1));
  const auto corner = [&](double x_deg, double y_deg) {
    return *frame * (turn * (kMpcdiAway_m *
                             glm::dvec3(std::tan(glm::radians(x_deg)), std::tan(glm::radians(y_deg)), -1.0)));
  };
  if (room.viewers.empty())
    room.viewers.push_back({frame->position_m, frustum->at, "the point of the frustum"});
  return ReadCorners{corner(*angles_deg[0], *angles_deg[2]), corner(*angles_deg[1], *angles_deg[2]),
                     corner(*angles_deg[0], *angles_deg[3])};
}

std::optional<ReadCorners> cornersByShare(const Part& region, const Part& buffer, Room& room) {
  std::array<double, 4> share{0.0, 0.0, 1.0, 1.0};
  constexpr std::array<std::string_view, 4> kNames{"x", "y", "xsize", "ysize"};
  for (std::size_t i = 0; i < kNames.size(); ++i)
    share[i] = number(region, kNames[i], kShare, false, room).value_or(share[i]);
  const auto pixels = mpcdiPixels(buffer, room);
  if (!pixels) return {};
  if (!(share[2] > 0.0 && share[3] > 0.0)) {
    addError(room, region.at,
             fmt::format("region '{}' has no size, expected shares above 0", printable(region.textOf("id"))));
    return {};
  }
  const double width_m = kMpcdiHeight_m * pixels->x / pixels->y;
  const auto corner = [&](double x, double y) {
    return glm::dvec3((x - 0.5) * width_m, kStandingEyes_m + (y - 0.5) * kMpcdiHeight_m, -kMpcdiAway_m);
  };
  if (room.viewers.empty()) room.viewers.push_back({{0.0, kStandingEyes_m, 0.0}, region.at, "a viewer"});
  return ReadCorners{corner(share[0], share[1]), corner(share[0] + share[2], share[1]),
                     corner(share[0], share[1] + share[3])};
}

}  // namespace carom
