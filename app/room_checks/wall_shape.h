#pragma once
// The shape of a wall, and the tolerances of the room checks.

#include <array>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "cave/room/rectangle.h"
#include "cave/room/wall.h"

namespace carom {

/// Smallest deviation that is reported: what a tape measure resolves.
inline constexpr double kMeet_m = kCornerMiss_m;
/// Edges and planes further apart than this are apart on purpose.
inline constexpr double kNear_m = 0.1;
inline constexpr double kSquarePixels = 0.02;
inline constexpr double kNearestWall_m = 0.2, kFarthestWall_m = 10.0;  ///< from the eyes

inline double mm(double length_m) { return length_m * 1e3; }

inline glm::dvec3 across(const Wall& wall) { return wall.lowerRight_m - wall.lowerLeft_m; }
inline glm::dvec3 upwards(const Wall& wall) { return wall.upperLeft_m - wall.lowerLeft_m; }
/// Points to the side that the wall is seen from.
inline glm::dvec3 normal(const Wall& wall) { return glm::normalize(glm::cross(across(wall), upwards(wall))); }
inline glm::dvec3 middle(const Wall& wall) { return wall.lowerLeft_m + 0.5 * (across(wall) + upwards(wall)); }
inline double width_m(const Wall& wall) { return glm::length(across(wall)); }
inline double height_m(const Wall& wall) { return glm::length(upwards(wall)); }

/// Returns the corners of the screen itself, anticlockwise.
inline std::array<glm::dvec3, 4> cornersOf(const Wall& wall) {
  if (wall.skewed) {
    const auto& corners_m = wall.skewed->corners_m;
    return {corners_m[0], corners_m[1], corners_m[3], corners_m[2]};
  }
  return {wall.lowerLeft_m, wall.lowerRight_m, wall.lowerRight_m + upwards(wall), wall.upperLeft_m};
}

}  // namespace carom
