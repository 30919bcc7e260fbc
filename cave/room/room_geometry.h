#pragma once
// The room as the overlays and the spectator view know it, beyond the walls that a node draws.

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

#include "cave/room/wall.h"
#include "engine/base/pose.h"

namespace carom {

/// What the room knows of a viewer.
struct RoomViewer {
  std::string name = "viewer";
  /// Takes coordinates from the frame of the eyes (the person's right, up and forward along the room's axes)
  /// to that of the head sensor.
  Pose sensorFromEyes;
  bool hasHand = false;  ///< a tracked hand: they need no keyboard
};

struct RoomGeometry {
  std::vector<Wall> walls;                                ///< of all nodes, flat: pieces of curved ones
  glm::dvec3 up{0.0, 1.0, 0.0}, forward{0.0, 0.0, -1.0};  ///< unit vectors
  std::vector<RoomViewer> viewers{1};                     ///< in the order of a frame's record
  /// The board that stands in the room and carries words and choices where no wall does.
  std::optional<Wall> panel{};
  bool isHeadset = false;  ///< the viewer wears a headset and sees all around; the one wall is the panel
};

/// Returns the room with another viewer in the first's place, and the other way round, as the frame's record
/// that this viewer sees (cave/record/frame_state.h).
inline RoomGeometry seenBy(RoomGeometry room, std::size_t viewer) {
  std::swap(room.viewers.front(), room.viewers.at(viewer));
  return room;
}

/// Returns the wall that carries words and choices: the room's panel, or the first wall that a person faces,
/// within 45°, when looking forward; none if the room has no such wall.
std::optional<Wall> frontWall(const RoomGeometry& room);

/// Returns whether two walls are the same screen, as when one computer draws for each eye.
inline bool standSame(const Wall& a, const Wall& b) {
  return a.lowerLeft_m == b.lowerLeft_m && a.lowerRight_m == b.lowerRight_m && a.upperLeft_m == b.upperLeft_m;
}

}  // namespace carom
