#pragma once
// The camera that looks at a room from outside: it goes round the room's middle.

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "cave/room/room_geometry.h"

namespace carom {

class OrbitCamera {
 public:
  /// Above, behind and to the right of the person, with the whole room in sight.
  explicit OrbitCamera(const RoomGeometry& room);

  /// A drag of the pointer across the window, in pixels right and down: the room turns with it.
  void turn(const glm::dvec2& dragged_px);
  /// Notches of the wheel; forwards comes nearer.
  void zoom(double notches);

  /// In the room.
  glm::dvec3 place_m() const;
  glm::dmat4 clipFromRoom(const glm::ivec2& picture_px) const;

 private:
  glm::dvec3 middle_m_{0.0}, up_, forward_;
  double around_rad_, above_rad_;  ///< from straight behind to the right; from the horizontal
  double distance_m_, least_m_, most_m_;
};

}  // namespace carom
