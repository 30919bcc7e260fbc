#include "cave/room/off_axis.h"

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

namespace carom {

std::optional<glm::dmat4> clipFromEye(const Wall& wall, const glm::dvec3& eyeInRoom_m,
                                      const ClipRange& range) {
  const glm::dvec3 across = wall.lowerRight_m - wall.lowerLeft_m;
  const glm::dvec3 upwards = wall.upperLeft_m - wall.lowerLeft_m;
  const glm::dvec3 area = glm::cross(across, upwards);
  if (!(glm::length(area) > 0.0)) return std::nullopt;

  // Kooima (2009), section 3: the wall's axes; the normal points to the side from which the corners read
  // lower left, lower right, upper left.
  const glm::dvec3 right = glm::normalize(across);
  const glm::dvec3 normal = glm::normalize(area);
  const glm::dvec3 up = glm::cross(normal, right);

  const glm::dvec3 lowerLeftFromEye = wall.lowerLeft_m - eyeInRoom_m;
  const double distance = -glm::dot(normal, lowerLeftFromEye);
  if (!(distance >= kNearestToWall_m)) return std::nullopt;

  // Kooima, section 4: the wall's edges on the near plane.
  const double scale = range.near_m / distance;
  const double left_m = glm::dot(right, lowerLeftFromEye) * scale;
  const double right_m = glm::dot(right, wall.lowerRight_m - eyeInRoom_m) * scale;
  const double bottom_m = glm::dot(up, lowerLeftFromEye) * scale;
  const double top_m = glm::dot(up, wall.upperLeft_m - eyeInRoom_m) * scale;
  const glm::dmat4 clipFromWallAxes =
      glm::frustum(left_m, right_m, bottom_m, top_m, range.near_m, range.far_m);

  // Kooima, section 5: turn the room's axes to the wall's.
  const glm::dmat4 roomFromWallAxes(glm::dvec4(right, 0.0), glm::dvec4(up, 0.0), glm::dvec4(normal, 0.0),
                                    glm::dvec4(0.0, 0.0, 0.0, 1.0));
  return clipFromWallAxes * glm::transpose(roomFromWallAxes);
}

std::optional<glm::dmat4> clipFromRoom(const Wall& wall, const glm::dvec3& eyeInRoom_m,
                                       const ClipRange& range) {
  const std::optional<glm::dmat4> fromEye = clipFromEye(wall, eyeInRoom_m, range);
  if (!fromEye) return std::nullopt;
  return *fromEye * glm::translate(glm::dmat4(1.0), -eyeInRoom_m);
}

glm::dvec2 sizeOf_m(const Wall& wall) {
  return {glm::length(wall.lowerRight_m - wall.lowerLeft_m),
          glm::length(wall.upperLeft_m - wall.lowerLeft_m)};
}

}  // namespace carom
