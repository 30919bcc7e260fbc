#include "cave/room/room_geometry.h"

#include <cmath>

namespace carom {

std::optional<Wall> frontWall(const RoomGeometry& room) {
  if (room.panel) return room.panel;
  for (const Wall& wall : room.walls) {
    if (-glm::dot(normalOf(wall), room.forward) > std::sqrt(0.5)) return wall;
  }
  return std::nullopt;
}

}  // namespace carom
