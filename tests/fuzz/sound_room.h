#pragma once
// What must hold for every room that a reader makes of any bytes.

#include <cmath>
#include <glm/geometric.hpp>

#include "app/room_checks/room_check.h"
#include "cave/screen/curved_screen.h"
#include "fuzz/expect.h"

namespace carom::test {

inline void expectSound(const Room& room) {
  for (const RoomWall& wall : room.walls) {
    if (wall.wall.screen) {
      expect(!wall.wall.screen->pieces.empty(), "curved walls have flat pieces");
      for (const ScreenTriangle& triangle : wall.wall.screen->mesh) {
        for (const ScreenPoint& point : triangle)
          expect(std::isfinite(glm::length(point.inRoom_m)), "screens are somewhere");
      }
      continue;
    }
    const glm::dvec3 right = wall.wall.lowerRight_m - wall.wall.lowerLeft_m;
    const glm::dvec3 up = wall.wall.upperLeft_m - wall.wall.lowerLeft_m;
    expect(std::isfinite(glm::length(glm::cross(right, up))) && glm::length(glm::cross(right, up)) > 0.0,
           "walls are rectangles");
    expect(wall.wall.pixels.x > 0 && wall.wall.pixels.y > 0, "walls have pixels");
    expect(wall.wall.node >= 0, "ranks count from 0");
    expect(!wordsFor(wall, room).empty(), "walls can be told in words");
  }
  for (const auto& findings : {room.findings.all(), judgeRoom(room)}) {
    for (const Finding& finding : findings) {
      expect(finding.at.line >= 1 && finding.at.column >= 1, "findings have a place");
    }
  }
}

}  // namespace carom::test
