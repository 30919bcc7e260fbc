#pragma once
// The camera that looks at a room from outside: it orbits around the room's middle.

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "cave/room/room_geometry.h"

namespace carom {

class OrbitCamera {
 public:
  /// Places the camera above, behind and to the right of the person, with the whole room in view.
  explicit OrbitCamera(const RoomGeometry& room);

  /// Turns the room with a drag of the pointer across the window, in pixels right and down.
  void turn(const glm::dvec2& dragged_px);
  /// Moves the camera by notches of the wheel; forwards comes nearer.
  void zoom(double notches);

  /// The camera's place and its projection, in the room.
  glm::dvec3 place_m() const;
  glm::dmat4 clipFromRoom(const glm::ivec2& picture_px) const;

 private:
  glm::dvec3 middle_m_{0.0}, up_, forward_;
  double around_rad_, above_rad_;  ///< angles from straight behind to the right, and from the horizontal
  double distance_m_, least_m_, most_m_;
};

}  // namespace carom
