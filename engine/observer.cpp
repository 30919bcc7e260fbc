#include "engine/observer.h"

#include <cmath>

namespace carom {

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

void Observer::step(double dtau_s, const Head& head, double pace) {
  const double c_m_s = boardFromRoom_.lightSpeed_m_s();
  Vec3 step_m = head.roomFromHead.position_m - head_.roomFromHead.position_m;
  if (!(glm::length(step_m) <= kGlitchCelerity_m_s * dtau_s)) step_m = Vec3(0.0);
  // dT = sqrt(dτ² + |dx|²/c²)
  const double lived_s = pace * dtau_s;
  const double roomTime_s = std::hypot(lived_s, glm::length(step_m) / c_m_s);
  headEvent_ = headEvent_ + boardFromRoom_ * Displacement{roomTime_s, step_m};
  properTime_s_ += lived_s;
  head_ = {head.roomFromHead, head.celerity_m_s / pace};
}

void Observer::stroll(double roomTime_s, const Head& head) {
  const Vec3 step_m = head.roomFromHead.position_m - head_.roomFromHead.position_m;
  headEvent_ = headEvent_ + boardFromRoom_ * Displacement{roomTime_s, step_m};
  head_ = {head.roomFromHead, Vec3(0.0)};
}

void Observer::thrust(const Vec3& deltaUInRoom) {
  boardFromRoom_ =
      (boardFromRoom_ * Lorentz::boost(deltaUInRoom, boardFromRoom_.lightSpeed_m_s())).orthonormalised();
}

ObserverView Observer::view(double eyeSeparation_m) const {
  const double c_m_s = boardFromRoom_.lightSpeed_m_s();
  const Lorentz boardFromHead = boardFromRoom_ * Lorentz::boost(head_.celerity_m_s / c_m_s, c_m_s);
  const Vec3 right_m = head_.roomFromHead.orientation * Vec3(0.5 * eyeSeparation_m, 0.0, 0.0);
  const auto eye = [&](const Vec3& offset_m) {
    const Vec3 place_m = head_.roomFromHead.position_m + offset_m;
    return EyeView{headEvent_ + boardFromHead * Displacement{0.0, offset_m}, place_m, place_m};
  };
  return {boardFromHead.inverse(), {eye(-right_m), eye(right_m), eye(Vec3(0.0))}, properTime_s_};
}

ObserverView walkedRound(const ObserverView& sight, const ObserverView& now) {
  const EyeView& middle = sight.eyes[2];
  ObserverView view = sight;
  for (std::size_t eye = 0; eye < view.eyes.size(); ++eye) {
    view.eyes[eye] = {middle.observation, now.eyes[eye].positionInRoom_m, middle.seenFromInRoom_m};
  }
  return view;
}

}  // namespace carom
