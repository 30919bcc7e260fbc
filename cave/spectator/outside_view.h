#pragma once
// The view of the room from outside, in one frame.

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace carom {

struct OutsideView {
  glm::dmat4 clipFromRoom{1.0};
  glm::dvec3 camera_m{0.0};  ///< in the room
  glm::ivec2 size_px{1};     ///< of the picture
};

}  // namespace carom
