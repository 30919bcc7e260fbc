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

ObserverView frozenViewAt(const ObserverView& sight, const ObserverView& now) {
  const auto from = [&](const EyeView& eye) {
    return EyeView{sight.middle.observation, eye.positionInRoom_m, sight.middle.seenFromInRoom_m};
  };
  return {sight.headFromBoard, from(now.left), from(now.right), from(now.middle), sight.properTime_s};
}

}  // namespace carom
