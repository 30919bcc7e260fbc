// The observer of a page in a browser, on a world line of their own: the celerity clock and the drive of the
// room (engine/spacetime/observers.h), so that light stays the fastest at home.

#include <algorithm>
#include <optional>

#include "app/page/engine/exchange.h"
#include "engine/base/limits.h"
#include "engine/spacetime/observers.h"

namespace carom::page {
namespace {

std::optional<Observers>& observer() {
  static std::optional<Observers> one;
  return one;
}

Head headAt(const Vec3& place_m, const Vec3& celerity_m_s) {
  return {{place_m, glm::dquat(1.0, 0.0, 0.0, 0.0)}, celerity_m_s};
}

}  // namespace

extern "C" {

/// Begins to observe: the given head's event on the board, the room's transform boardFromRoom, the head's
/// place in the room.
CAROM_EXPORTED(beginWalk) void beginWalk(double properTime_s) {
  Given given;
  const Event head = given.event();
  const Lorentz boardFromRoom = given.transform(bodies().lightSpeed_m_s);
  observer() = Observers::at(head, properTime_s, boardFromRoom, headAt(given.vector(), Vec3(0.0)));
}

/// Lives on for so long of the observer's own time while the head moves to the given place of the room at the
/// given celerity, and the room has the given thrust as a share of the strongest (in the room's axes).
CAROM_EXPORTED(walk) void walk(double dt_s) {
  Given given;
  const Vec3 place_m = given.vector(), celerity_m_s = given.vector();
  Vec3 thrust = given.vector();
  const Vec3 u = observer()->boardFromRoom().u();
  thrust *= strongestThrust_m_s2(bodies().lightSpeed_m_s) / std::max(1.0, glm::length(thrust));
  if (glm::length(u) >= kMostPlatformU &&
      glm::dot(Vec3((observer()->boardFromRoom() * Displacement{0.0, thrust}).dr_m), u) > 0.0)
    thrust = Vec3(0.0);
  observer()->beginFrame();
  observer()->step(dt_s, headAt(place_m, celerity_m_s), 1.0, thrust);
}

/// Turns the room about the head, about the given axis of the room.
CAROM_EXPORTED(turnRoom) void turnRoom(double angle_rad) { observer()->turn({angle_rad, Given().vector()}); }

/// What the observer sees by: headFromBoard, the events of the middle, the left and the right eye, which are
/// at the given place beside the head (the right one; room frame), boardFromRoom, own time.
CAROM_EXPORTED(walkView) void walkView() {
  const Vec3 right_m = Given().vector();
  const ObserverView view = observer()->view(-right_m, right_m);
  Answer answer;
  answer.matrix(view.headFromBoard.matrix());
  for (const EyeView& eye : {view.middle, view.left, view.right}) answer.event(eye.observation);
  answer.matrix(observer()->boardFromRoom().matrix());
  answer.number(view.properTime_s);
}

}  // extern "C"

}  // namespace carom::page
