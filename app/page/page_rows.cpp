#include "app/page/page_rows.h"

#include "cave/record/effects.h"
#include "cave/record/time_views.h"

namespace carom {
namespace {

template <typename Flags, typename Named>
std::uint32_t bitsOf(const Flags& flags, const Named& named) {
  std::uint32_t bits = 0;
  for (std::size_t i = 0; i < named.size(); ++i)
    if (flags.*named[i].value) bits |= 1U << i;
  return bits;
}

}  // namespace

std::vector<double> numbersOf(const Knot& k) {
  std::vector<double> numbers;
  const auto add = [&](const Event& event) {
    for (const double value : {event.t_s, event.r_m.x, event.r_m.y, event.r_m.z}) numbers.push_back(value);
  };
  add(k.turn);
  for (int i = 0; i < 3; ++i) numbers.push_back(k.u[i]);
  numbers.push_back(k.properTime_s);
  add(k.signal);
  for (const double value :
       {k.deceleration_m_s2, k.spin.angle_rad, k.spin.omega_rad_s, k.spin.rim_u, k.spin.slowing_1_s})
    numbers.push_back(value);
  return numbers;
}

std::vector<double> numbersOf(const VisitFrame& frame) {
  std::vector<double> numbers{static_cast<double>(frame.number), frame.display_s, frame.observer.properTime_s,
                              frame.fade};
  for (const EyeView& eye : frame.observer.all()) {
    numbers.push_back(eye.observation.t_s);
    for (const Vec3& place : {eye.observation.r_m, eye.positionInRoom_m, eye.seenFromInRoom_m})
      for (int i = 0; i < 3; ++i) numbers.push_back(place[i]);
  }
  for (const Lorentz& transform : {frame.observer.headFromBoard, frame.boardFromRoom})
    for (int column = 0; column < 4; ++column)
      for (int row = 0; row < 4; ++row) numbers.push_back(transform.matrix()[column][row]);
  return numbers;
}

std::vector<std::uint32_t> statesOf(const VisitFrame& frame) {
  return {bitsOf(frame.switches, kNamedSwitches), bitsOf(frame.views, kNamedViews),
          bitsOf(frame.views.beside, kNamedSwitches), static_cast<std::uint32_t>(frame.lesson.phase)};
}

}  // namespace carom
