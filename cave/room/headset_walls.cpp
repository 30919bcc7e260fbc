#include "cave/room/headset_walls.h"

namespace carom {

Wall wallBefore(const HeadsetEye& eye, const char* name, glm::ivec2 pixels) {
  Wall wall;
  wall.name = name;
  wall.pixels = pixels;
  hang(wall, eye);
  return wall;
}

void hang(Wall& wall, const HeadsetEye& eye) {
  const EyeFrustum& f = eye.frustum;
  wall.lowerLeft_m = eye.roomFromEye * glm::dvec3(f.left, f.down, -1.0);
  wall.lowerRight_m = eye.roomFromEye * glm::dvec3(f.right, f.down, -1.0);
  wall.upperLeft_m = eye.roomFromEye * glm::dvec3(f.left, f.up, -1.0);
}

Pose headBetween(const std::array<HeadsetEye, 2>& eyes) {
  const glm::dvec3& left_m = eyes[0].roomFromEye.position_m;
  const glm::dvec3& right_m = eyes[1].roomFromEye.position_m;
  return {0.5 * (left_m + right_m),
          glm::normalize(glm::slerp(eyes[0].roomFromEye.orientation, eyes[1].roomFromEye.orientation, 0.5))};
}

}  // namespace carom
