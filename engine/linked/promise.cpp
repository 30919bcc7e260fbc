#include "engine/linked/promise.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace carom {
namespace {

// Q = H − (ρ/c) u, with u the unit vector of the room's time: whatever is done within ρ of the head, at its
// moment in the room or later, lies in J⁺(Q).
Event promisedAt(const Event& head, const Lorentz& boardFromRoom, double reach_m) {
  return head - boardFromRoom * Displacement{reach_m / boardFromRoom.lightSpeed_m_s(), Vec3(0.0)};
}

}  // namespace

double afterLightOf_s(const Event& from, const Event& event, double c_m_s) {
  return event.t_s - from.t_s - glm::distance(event.r_m, from.r_m) / c_m_s;
}

double reachBeside_m(double reach_m, double nearest_m) { return std::min(reach_m, 0.4 * nearest_m); }

Promise::Promise(const Event& head, const Lorentz& boardFromRoom, double reach_m)
    : event_(promisedAt(head, boardFromRoom, reach_m)) {}

void Promise::renew(const Event& head, const Lorentz& boardFromRoom, double reach_m) {
  const Event next = promisedAt(head, boardFromRoom, reach_m);
  if (isInFutureOf(event_, next, boardFromRoom.lightSpeed_m_s())) event_ = next;
}

// With D from the promise to the act, all products those of spacetime, and u the unit vector of the room's
// time, (D + s u)² = 0 at
//   s = −D·u + sqrt((D·u)² − D²),
// which is real and on the future cone, for D² ≤ (D·u)² (the reversed inequality of Cauchy and Schwarz).
Event Promise::putOff(const Event& act, const Lorentz& boardFromRoom) const {
  const double c_m_s = boardFromRoom.lightSpeed_m_s();
  if (isInFutureOf(event_, act, c_m_s)) return act;
  const Displacement second = boardFromRoom * Displacement{1.0, Vec3(0.0)};
  const auto later = [&](double s) { return act + Displacement{s * second.dt_s, s * second.dr_m}; };
  const Displacement way = act - event_;
  const double along_s = way.dt_s * second.dt_s - glm::dot(way.dr_m, second.dr_m) / (c_m_s * c_m_s);
  const double square_s2 = interval_m2(way, c_m_s) / (c_m_s * c_m_s);
  const double wait_s = std::sqrt(std::max(0.0, along_s * along_s - square_s2)) - along_s;
  double rounding_s = 1e-12;
  Event put = later(wait_s);
  for (; rounding_s < 1.0 && !isInFutureOf(event_, put, c_m_s); rounding_s *= 2.0)
    put = later(wait_s + rounding_s);
  return put;
}

Event Promise::drawnHand(const Event& head, const Vec3& fromHead_m, const Lorentz& boardFromRoom,
                         double reach_m) const {
  const double far_m = glm::length(fromHead_m);
  const Vec3 drawn_m = far_m > reach_m ? fromHead_m * (reach_m / far_m) : fromHead_m;
  return putOff(head + boardFromRoom * Displacement{0.0, drawn_m}, boardFromRoom);
}

}  // namespace carom
