#pragma once
// A person before one wall, in a room that may move.

#include <numbers>

#include <glm/vec3.hpp>

#include "cave/overlay/home_arrow.h"
#include "engine/light_speed.h"

namespace carom::test {

inline Wall wall(const glm::dvec3& lowerLeft_m, const glm::dvec3& lowerRight_m,
                 const glm::dvec3& upperLeft_m) {
  Wall wall;
  wall.name = "wall";
  wall.lowerLeft_m = lowerLeft_m;
  wall.lowerRight_m = lowerRight_m;
  wall.upperLeft_m = upperLeft_m;
  wall.pixels = {64, 64};
  return wall;
}

/// One wall, 1 m before the person, who looks along -z.
inline RoomGeometry oneWall() {
  RoomGeometry room;
  room.walls = {wall({-1.0, 0.7, -1.0}, {1.0, 0.7, -1.0}, {-1.0, 2.3, -1.0})};
  return room;
}

/// Returns the record of a person whose eyes are 1.6 m above the floor of a room that moves with β and is at
/// this place of the board; the room's axes are the board's x, z and −y.
inline FrameRecord recordAt(const Vec3& eye_m, const Vec3& beta) {
  const ObserverStart start{eye_m - Vec3(0.0, 0.0, 1.6), 0.5 * std::numbers::pi, beta};
  FrameRecord record;
  record.boardFromRoom =
      startingRoom(start, {.right = {1, 0, 0}, .up = {0, 1, 0}, .forward = {0, 0, -1}}, kC_m_s);
  record.viewers[0].observer.middle.observation = {3.0, eye_m};
  record.viewers[0].observer.middle.positionInRoom_m = {0.0, 1.6, 0.0};
  return record;
}

}  // namespace carom::test
