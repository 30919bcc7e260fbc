#include "cave/room/wall_eyes.h"

namespace carom {

std::vector<Eye> eyesOf(StereoMode mode) {
  switch (mode) {
    case StereoMode::mono:
      return {Eye::middle};
    case StereoMode::left:
      return {Eye::left};
    case StereoMode::right:
      return {Eye::right};
    default:
      return {Eye::left, Eye::right};
  }
}

std::vector<ViewerEye> eyesOf(const Wall& wall) {
  if (!wall.eyes.empty()) return wall.eyes;
  std::vector<ViewerEye> eyes;
  for (const Eye eye : eyesOf(wall.stereo)) eyes.push_back({wall.viewer, eye});
  return eyes;
}

const char* nameOf(Eye eye) {
  switch (eye) {
    case Eye::left:
      return "left";
    case Eye::right:
      return "right";
    case Eye::middle:
      return "mono";
  }
  return "mono";
}

}  // namespace carom
