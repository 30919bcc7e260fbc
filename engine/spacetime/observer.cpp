#include "engine/spacetime/observer.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

namespace carom {

Lorentz startingRoom(const ObserverStart& start, const RoomAxes& axes, double c_m_s) {
  const glm::dvec3 forward(std::cos(start.facing_rad), std::sin(start.facing_rad), 0.0);
  const glm::dvec3 up(0.0, 0.0, 1.0);
  const glm::dmat3 board(glm::cross(forward, up), forward, up);
  const glm::dmat3 room(axes.right, axes.forward, axes.up);
  const glm::dquat turn = glm::normalize(glm::quat_cast(board * glm::transpose(room)));
  return Lorentz::boost(uFromBeta(start.beta), c_m_s) * Lorentz::rotation(turn, c_m_s);
}

// The eyes rest in the head's frame: there they are apart by ±right_m at no time apart.
ObserverView viewOfEyes(const Lorentz& headFromBoard, const EyeView& middle, const Vec3& right_m,
                        double properTime_s) {
  const Lorentz boardFromHead = headFromBoard.inverse();
  const auto eye = [&](const Vec3& offset_m) {
    return EyeView{middle.observation + boardFromHead * Displacement{0.0, offset_m},
                   middle.positionInRoom_m + offset_m, middle.seenFromInRoom_m + offset_m};
  };
  return {headFromBoard, eye(-right_m), eye(right_m), middle, properTime_s};
}

// The other's light arrives at the place from which its view counts seen places; the room's present of that
// event holds the place's own, X = X_other + Λ (0, r − r_other).
ObserverView viewAtRest(const ObserverView& other, const Lorentz& boardFromRoom, double room_s,
                        const Vec3& placeInRoom_m, const Vec3& right_m) {
  const Vec3 apart_m = placeInRoom_m - other.middle.seenFromInRoom_m;
  const Event here = other.middle.observation + boardFromRoom * Displacement{0.0, apart_m};
  return viewOfEyes(boardFromRoom.inverse(), {here, placeInRoom_m, placeInRoom_m}, right_m, room_s);
}

ObserverView frozenViewAt(const ObserverView& sight, const ObserverView& now) {
  const auto from = [&](const EyeView& eye) {
    return EyeView{sight.middle.observation, eye.positionInRoom_m, sight.middle.seenFromInRoom_m};
  };
  return {sight.headFromBoard, from(now.left), from(now.right), from(now.middle), sight.properTime_s};
}

}  // namespace carom
