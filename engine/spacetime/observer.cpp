#include "engine/spacetime/observer.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "engine/base/limits.h"

namespace carom {

Lorentz startingRoom(const ObserverStart& start, const RoomAxes& axes, double c_m_s) {
  const glm::dvec3 forward(std::cos(start.facing_rad), std::sin(start.facing_rad), 0.0);
  const glm::dvec3 up(0.0, 0.0, 1.0);
  const glm::dmat3 board(glm::cross(forward, up), forward, up);
  const glm::dmat3 room(axes.right, axes.forward, axes.up);
  const glm::dquat turn = glm::normalize(glm::quat_cast(board * glm::transpose(room)));
  return Lorentz::boost(uFromBeta(start.beta), c_m_s) * Lorentz::rotation(turn, c_m_s);
}

Observer::Observer(const Lorentz& boardFromRoom, const Event& roomOrigin, const Head& head)
    : boardFromRoom_(boardFromRoom),
      headEvent_(roomOrigin + boardFromRoom * Displacement{0.0, head.roomFromHead.position_m}),
      head_(head) {}

Observer Observer::at(const Event& headEvent, double properTime_s, const Lorentz& boardFromRoom,
                      const Head& head) {
  Observer observer(boardFromRoom, headEvent, head);
  observer.headEvent_ = headEvent;
  observer.properTime_s_ = properTime_s;
  return observer;
}

namespace {

/// Half of a step's thrust: a boost of half its rapidity.
Lorentz halfBoost(const Vec3& rapidity, double c_m_s) {
  const double size = glm::length(rapidity);
  return Lorentz::boost(size > 0.0 ? rapidity * (std::sinh(0.5 * size) / size) : Vec3(0.0), c_m_s);
}

/// sinh(x)/x.
double sinhc(double x) { return std::abs(x) < 1e-4 ? 1.0 + x * x / 6.0 : std::sinh(x) / x; }

}  // namespace

// On the hyperbola of proper acceleration a, from rest, after proper time T, with φ = aT/c:
//   (ct, x) = (c²/a) (sinh φ, cosh φ − 1) = (2c²/a) sinh(φ/2) (cosh(φ/2), sinh(φ/2))
// which in the frame boosted by φ/2 is the time T sinh(φ/2)/(φ/2) alone (Rindler 2006, §3.8).
void Observer::step(double dtau_s, const Head& head, double pace, const Vec3& thrust_m_s2) {
  const double c_m_s = boardFromRoom_.lightSpeed_m_s();
  Vec3 step_m = head.roomFromHead.position_m - head_.roomFromHead.position_m;
  if (!(glm::length(step_m) <= kGlitchCelerity_m_s * dtau_s)) step_m = Vec3(0.0);
  // dT = sqrt(dτ² + |dx|²/c²)
  const double lived_s = pace * dtau_s;
  const double roomTime_s = std::hypot(lived_s, glm::length(step_m) / c_m_s);
  const Vec3 rapidity = thrust_m_s2 * (roomTime_s / c_m_s);
  if (rapidity == Vec3(0.0)) {
    headEvent_ = headEvent_ + boardFromRoom_ * Displacement{roomTime_s, step_m};
  } else {
    const Lorentz half = halfBoost(rapidity, c_m_s);
    const double chord_s = roomTime_s * sinhc(0.5 * glm::length(rapidity));
    headEvent_ = headEvent_ + boardFromRoom_ * (half * Displacement{chord_s, step_m});
    boardFromRoom_ = (boardFromRoom_ * half * half).orthonormalised();
  }
  properTime_s_ += lived_s;
  head_ = {head.roomFromHead, head.celerity_m_s / pace};
}

void Observer::moveUnseen(double roomTime_s, const Head& head) {
  const Vec3 step_m = head.roomFromHead.position_m - head_.roomFromHead.position_m;
  headEvent_ = headEvent_ + boardFromRoom_ * Displacement{roomTime_s, step_m};
  head_ = {head.roomFromHead, Vec3(0.0)};
}

void Observer::turn(double angle_rad, const Vec3& axisInRoom) {
  const glm::dquat turned = glm::angleAxis(angle_rad, glm::normalize(axisInRoom));
  boardFromRoom_ =
      (boardFromRoom_ * Lorentz::rotation(turned, boardFromRoom_.lightSpeed_m_s())).orthonormalised();
}

ObserverView Observer::view(double eyeSeparation_m) const {
  const double c_m_s = boardFromRoom_.lightSpeed_m_s();
  const Lorentz boardFromHead = boardFromRoom_ * Lorentz::boost(head_.celerity_m_s / c_m_s, c_m_s);
  const Vec3 right_m = head_.roomFromHead.orientation * Vec3(0.5 * eyeSeparation_m, 0.0, 0.0);
  const auto eye = [&](const Vec3& offset_m) {
    const Vec3 place_m = head_.roomFromHead.position_m + offset_m;
    return EyeView{headEvent_ + boardFromHead * Displacement{0.0, offset_m}, place_m, place_m};
  };
  return {boardFromHead.inverse(), eye(-right_m), eye(right_m), eye(Vec3(0.0)), properTime_s_};
}

ObserverView frozenViewAt(const ObserverView& sight, const ObserverView& now) {
  const auto from = [&](const EyeView& eye) {
    return EyeView{sight.middle.observation, eye.positionInRoom_m, sight.middle.seenFromInRoom_m};
  };
  return {sight.headFromBoard, from(now.left), from(now.right), from(now.middle), sight.properTime_s};
}

}  // namespace carom
