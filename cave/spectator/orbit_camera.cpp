#include "cave/spectator/orbit_camera.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

namespace carom {
namespace {

constexpr double kFieldOfView_rad = 0.56;  // 32°: little distortion, as for a model on a table
constexpr double kPerPixel_rad = 0.006;
constexpr double kPerNotch = 0.9;
constexpr double kLowest_rad = -0.2, kHighest_rad = 1.5;

}  // namespace

OrbitCamera::OrbitCamera(const RoomGeometry& room)
    : up_(room.up), forward_(room.forward), around_rad_(0.62), above_rad_(0.52) {
  glm::dvec3 least_m(std::numeric_limits<double>::infinity()), most_m(-least_m);
  for (const Wall& wall : room.walls) {
    const glm::dvec3 fourth_m = wall.lowerRight_m + wall.upperLeft_m - wall.lowerLeft_m;
    for (const glm::dvec3& corner_m : {wall.lowerLeft_m, wall.lowerRight_m, wall.upperLeft_m, fourth_m}) {
      least_m = glm::min(least_m, corner_m);
      most_m = glm::max(most_m, corner_m);
    }
  }
  constexpr double kStanding_m = 1.8;  // a person at the room's origin is in view, too
  for (const glm::dvec3& place_m : {glm::dvec3(0.0), kStanding_m * room.up}) {
    least_m = glm::min(least_m, place_m);
    most_m = glm::max(most_m, place_m);
  }
  middle_m_ = 0.5 * (least_m + most_m);
  const double radius_m = 0.5 * glm::distance(least_m, most_m);
  distance_m_ = 1.04 * radius_m / std::sin(0.5 * kFieldOfView_rad);
  least_m_ = 0.2 * distance_m_;
  most_m_ = 5.0 * distance_m_;
}

void OrbitCamera::turn(const glm::dvec2& dragged_px) {
  around_rad_ -= kPerPixel_rad * dragged_px.x;
  above_rad_ = std::clamp(above_rad_ + kPerPixel_rad * dragged_px.y, kLowest_rad, kHighest_rad);
}

void OrbitCamera::zoom(double notches) {
  distance_m_ = std::clamp(distance_m_ * std::pow(kPerNotch, notches), least_m_, most_m_);
}

glm::dvec3 OrbitCamera::place_m() const {
  const glm::dvec3 right = glm::cross(forward_, up_);
  const glm::dvec3 level = std::sin(around_rad_) * right - std::cos(around_rad_) * forward_;
  return middle_m_ + distance_m_ * (std::cos(above_rad_) * level + std::sin(above_rad_) * up_);
}

glm::dmat4 OrbitCamera::clipFromRoom(const glm::ivec2& picture_px) const {
  const double aspect = static_cast<double>(picture_px.x) / std::max(picture_px.y, 1);
  // The whole room is in view, also in a window that is higher than wide.
  const double vertical_rad = 2.0 * std::atan(std::tan(0.5 * kFieldOfView_rad) / std::min(aspect, 1.0));
  return glm::perspective(vertical_rad, aspect, 0.02 * distance_m_, 20.0 * distance_m_) *
         glm::lookAt(place_m(), middle_m_, up_);
}

}  // namespace carom
