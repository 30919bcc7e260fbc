#include "cave/spectator/room_simultaneity.h"

#include <cmath>

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

namespace carom {

glm::dmat3 bodyFromRoomNow(const Lorentz& boardFromRoom, const glm::dvec3& u) {
  const Lorentz bodyFromRoom = Lorentz::boost(-u, boardFromRoom.lightSpeed_m_s()) * boardFromRoom;
  const glm::dmat4& m = bodyFromRoom.matrix();
  glm::dmat3 now;
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row) now[column][row] = m[column + 1][row + 1];
  }
  return now;
}

RoomSimultaneity::RoomSimultaneity(const Lorentz& boardFromRoom, const Event& event,
                                   const glm::dvec3& placeInRoom_m)
    : boardFromRoom_(boardFromRoom),
      roomFromBoard_(boardFromRoom.inverse()),
      event_(event),
      placeInRoom_m_(placeInRoom_m) {}

/// Returns the motion of the centre where its world line crosses this time of the room. Room time increases
/// along every timelike line, so there is exactly one such event; bisection finds it.
Motion RoomSimultaneity::at(const WorldLine& line) const {
  const auto roomTime_s = [&](double t_s) { return (roomFromBoard_ * (line.at(t_s).event - event_)).dt_s; };
  double before_s = event_.t_s, after_s = event_.t_s;
  for (double step_s = 1.0; roomTime_s(before_s) > 0.0 && step_s < 1e9; step_s *= 2.0) before_s -= step_s;
  for (double step_s = 1.0; roomTime_s(after_s) < 0.0 && step_s < 1e9; step_s *= 2.0) after_s += step_s;
  constexpr double kEnough_s = 1e-9;  // light travels a nanometre
  while (after_s - before_s > kEnough_s) {
    const double middle_s = 0.5 * (before_s + after_s);
    if (middle_s == before_s || middle_s == after_s) break;
    if (roomTime_s(middle_s) < 0.0) {
      before_s = middle_s;
    } else {
      after_s = middle_s;
    }
  }
  return line.at(after_s);
}

/// At one time of the room dt = 0, so a body's point is at d = Λ dr with Λ the spatial part of bodyFromRoom;
/// in the room it is at dr = Λ⁻¹ d.
std::optional<glm::dmat4> RoomSimultaneity::roomFromBody(const WorldLine& line) const {
  const Motion motion = at(line);
  if (motion.event.t_s < line.appears_s()) return std::nullopt;
  return roomFrom(motion.event, motion.u);
}

glm::dmat4 RoomSimultaneity::roomFrom(const Event& centre, const Vec3& u) const {
  glm::dmat4 result(glm::inverse(bodyFromRoomNow(boardFromRoom_, u)));
  result[3] = glm::dvec4(placeInRoom_m_ + (roomFromBoard_ * (centre - event_)).dr_m, 1.0);
  return result;
}

}  // namespace carom
