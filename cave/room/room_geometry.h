#pragma once
// The room as the overlays and the spectator view know it, beyond the walls that a node draws.

#include <vector>

#include <glm/vec3.hpp>

#include "cave/room/wall.h"
#include "engine/base/pose.h"

namespace carom {

struct RoomGeometry {
  std::vector<Wall> walls;                                ///< of all nodes
  glm::dvec3 up{0.0, 1.0, 0.0}, forward{0.0, 0.0, -1.0};  ///< unit vectors
  /// Takes coordinates from the frame of the eyes (the person's right, up and forward along the room's axes)
  /// to that of the head sensor.
  Pose sensorFromEyes;
};

/// Returns whether two walls are the same screen, as when one computer draws for each eye.
inline bool standSame(const Wall& a, const Wall& b) {
  return a.lowerLeft_m == b.lowerLeft_m && a.lowerRight_m == b.lowerRight_m && a.upperLeft_m == b.upperLeft_m;
}

}  // namespace carom
