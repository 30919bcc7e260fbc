#include "cave/hud/motion_overlay.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include <glm/geometric.hpp>

#include "cave/gl/gl_state_guard.h"
#include "cave/gl/view_colours.h"
#include "cave/room/off_axis.h"
#include "engine/spacetime/lorentz.h"

namespace carom {
namespace {

constexpr int kSides = 48;
constexpr double kMoves_u = 1e-6;
constexpr double kCircle_m = 0.004, kEllipse_m = 0.005, kMotion_m = 0.008, kThrust_m = 0.004;  // half widths
constexpr double kRim_m = 0.003;  // dark border of a line
constexpr glm::vec4 kDark(0.03F, 0.03F, 0.04F, 0.75F);
constexpr glm::vec3 kLight(0.95F, 0.95F, 0.95F);
constexpr double kFlat = 0.7;  // least cosine between a floor's normal and the room's up

/// The extent of the walls' corners along a direction.
struct Reach {
  double least_m = std::numeric_limits<double>::infinity(), most_m = -least_m;
};

Reach reachOf(const RoomGeometry& room, const glm::dvec3& along) {
  Reach reach;
  for (const Wall& wall : room.walls) {
    const glm::dvec3 upperRight_m = wall.upperLeft_m + wall.lowerRight_m - wall.lowerLeft_m;
    for (const glm::dvec3& corner_m : {wall.lowerLeft_m, wall.lowerRight_m, wall.upperLeft_m, upperRight_m}) {
      reach.least_m = std::min(reach.least_m, glm::dot(corner_m, along));
      reach.most_m = std::max(reach.most_m, glm::dot(corner_m, along));
    }
  }
  return reach;
}

bool hasFloor(const RoomGeometry& room) {
  return std::any_of(room.walls.begin(), room.walls.end(),
                     [&](const Wall& wall) { return glm::dot(normalOf(wall), room.up) > kFlat; });
}

}  // namespace

glm::dvec3 platformInRoom_u(const SeenFrame& seen) { return -seen.record.boardFromRoom.inverse().u(); }

bool isDriven(const SeenFrame& seen) {
  return glm::length(seen.record.boardFromRoom.u()) > kMoves_u || seen.record.drive.thrust != Vec3(0.0);
}

double MotionOverlay::radius_m(const RoomGeometry& room) { return hasFloor(room) ? kRadius_m : kSmall_m; }

glm::dvec3 MotionOverlay::middle_m(const RoomGeometry& room) {
  const glm::dvec3 right = glm::cross(room.forward, room.up);
  const Reach across = reachOf(room, right), ahead = reachOf(room, room.forward);
  const glm::dvec3 foot_m = room.up * reachOf(room, room.up).least_m;
  if (hasFloor(room)) {
    return foot_m + right * (0.5 * (across.least_m + across.most_m)) +
           room.forward * (ahead.most_m - kRadius_m - kClear_m);
  }
  return foot_m + right * (across.most_m - kSmall_m) + room.forward * (ahead.most_m + kSmall_m);
}

void MotionOverlay::addLine(const glm::dvec3& from_m, const glm::dvec3& to_m, double halfWidth_m,
                            const glm::vec3& colour) {
  lines_.push_back({from_m, to_m, halfWidth_m, glm::vec4(colour, 1.0F)});
}

/// Adds an arrow whose head lies in the floor, or stands upright if the arrow points up or down.
void MotionOverlay::addArrow(const RoomGeometry& room, const glm::dvec3& from_m, const glm::dvec3& along_m,
                             double halfWidth_m, const glm::vec3& colour) {
  const double length_m = glm::length(along_m);
  if (!(length_m > halfWidth_m)) return;
  const glm::dvec3 along = along_m / length_m, tip_m = from_m + along_m;
  glm::dvec3 aside = glm::cross(along, room.up);
  if (glm::length(aside) < 0.1) aside = glm::cross(along, room.forward);
  aside = glm::normalize(aside);
  const double head_m = std::min(7.0 * halfWidth_m, 0.6 * length_m);
  addLine(from_m, tip_m, halfWidth_m, colour);
  for (const double side : {-0.6, 0.6})
    addLine(tip_m, tip_m - head_m * along + side * head_m * aside, halfWidth_m, colour);
}

/// Adds the lines. L(v)d = d + (1/γ − 1)(d·v̂)v̂ gives the board's circle in the room.
void MotionOverlay::add(const RoomGeometry& room, const SeenFrame& seen) {
  const glm::dvec3 middle = middle_m(room), right = glm::cross(room.forward, room.up);
  const glm::dvec3 u = platformInRoom_u(seen);
  const double gamma = gammaFromU(u), size = glm::length(u), around_m = radius_m(room);
  const double thick = around_m / kRadius_m;
  const glm::dvec3 along = size > 0.0 ? u / size : glm::dvec3(0.0);
  const auto onCircle_m = [&](int side) {
    const double angle_rad = 2.0 * std::numbers::pi * side / kSides;
    return around_m * (std::cos(angle_rad) * right + std::sin(angle_rad) * room.forward);
  };
  const auto contracted_m = [&](const glm::dvec3& d_m) {
    return d_m + (1.0 / gamma - 1.0) * glm::dot(d_m, along) * along;
  };
  for (int side = 0; side < kSides; ++side) {
    const glm::dvec3 from_m = onCircle_m(side), to_m = onCircle_m(side + 1);
    addLine(middle + from_m, middle + to_m, thick * kCircle_m, kLight);
    addLine(middle + contracted_m(from_m), middle + contracted_m(to_m), thick * kEllipse_m,
            kContractedColour);
  }
  addArrow(room, middle, around_m * betaFromU(u), thick * kMotion_m, kMotionColour);
  addArrow(room, middle, around_m * seen.record.drive.thrust, thick * kThrust_m,
           seen.record.drive.atLimit ? kLimitColour : kThrustColour);
}

void MotionOverlay::draw(const RoomGeometry& room, const Wall& wall, const glm::dvec3& eyeInRoom_m,
                         const SeenFrame& seen, const RenderTarget& picture) {
  if (room.walls.empty() || !isDriven(seen)) return;
  const std::optional<glm::dmat4> clip = clipFromRoom(wall, eyeInRoom_m);
  if (!clip) return;
  lines_.clear();
  add(room, seen);
  const std::size_t count = lines_.size();  // first the dark borders, below the lines
  lines_.resize(2 * count);
  for (std::size_t i = 0; i < count; ++i) {
    lines_[count + i] = lines_[i];
    lines_[i].halfWidth_m += kRim_m;
    lines_[i].colour = kDark;
  }
  const GlStateGuard state(picture.framebuffer(), picture.size_px());
  blendOver();
  ribbons_.draw(lines_, *clip, picture.size_px());
}

}  // namespace carom
