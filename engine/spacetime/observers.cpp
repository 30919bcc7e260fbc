#include "engine/spacetime/observers.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <stdexcept>

namespace carom {
namespace {

/// Half of a step's thrust: a boost of half its rapidity.
Lorentz halfBoost(const Vec3& rapidity, double c_m_s) {
  const double size = glm::length(rapidity);
  return Lorentz::boost(size > 0.0 ? rapidity * (std::sinh(0.5 * size) / size) : Vec3(0.0), c_m_s);
}

/// sinh(x)/x.
double sinhc(double x) { return std::abs(x) < 1e-4 ? 1.0 + x * x / 6.0 : std::sinh(x) / x; }

glm::dquat rotationOf(const RoomTurn& turn) {
  return glm::angleAxis(turn.angle_rad, glm::normalize(turn.axisInRoom));
}

void expectSomebody(std::size_t observers) {
  if (observers < 1 || observers > kMostViewers)
    throw std::invalid_argument("Observers: a room holds one to four observers");
}

}  // namespace

Observers::Observers(const Lorentz& boardFromRoom, const Event& roomOrigin, std::span<const Head> heads)
    : boardFromRoom_(boardFromRoom), size_(heads.size()) {
  expectSomebody(size_);
  for (std::size_t i = 0; i < size_; ++i) {
    const Vec3& place_m = heads[i].roomFromHead.position_m;
    observers_[i] = {roomOrigin + boardFromRoom * Displacement{0.0, place_m}, place_m, heads[i]};
  }
  beginFrame();
}

Observers::Observers(const Lorentz& boardFromRoom, double room_s, std::span<const OneObserver> observers)
    : boardFromRoom_(boardFromRoom), room_s_(room_s), size_(observers.size()) {
  expectSomebody(size_);
  std::copy(observers.begin(), observers.end(), observers_.begin());
  beginFrame();
}

Observers Observers::at(const Event& headEvent, double properTime_s, const Lorentz& boardFromRoom,
                        const Head& head) {
  const OneObserver alone{headEvent, head.roomFromHead.position_m, head, properTime_s};
  return Observers(boardFromRoom, properTime_s, {&alone, 1});
}

void Observers::beginFrame() {
  frameFrom_ = observers_;
  frameFrom_s_ = room_s_;
  stepsOfFrame_ = 0;
  livedOfFrame_s_ = 0.0;
  ahead_s_ = {};
}

double Observers::farthestFrom_m(std::size_t steering) const {
  double farthest_m = 0.0;
  for (std::size_t i = 0; i < size_; ++i)
    farthest_m =
        std::max(farthest_m, glm::distance(observers_[i].placeInRoom_m, observers_[steering].placeInRoom_m));
  return farthest_m;
}

// The rigid room accelerates with g at the one who steers. At the place r from there a clock at rest runs by
//   N = 1 + g·r/c²
// times the room's time (Rindler 2006, §3.8; Misner, Thorne, Wheeler 1973, eq. 6.18). r is the mean over the
// step: then the chord of a world line agrees with its proper time to the third order of the step.
Observers::Steps Observers::stepsTo(double dt_s, std::span<const Head> heads, const Vec3& thrust_m_s2,
                                    std::size_t steering, const RoomTurn& turn) const {
  const double c_m_s = boardFromRoom_.lightSpeed_m_s();
  const double most_m = (size_ > 1 ? kGlitchOfSeveral_m_s : kGlitchCelerity_m_s) * dt_s;
  Steps steps;
  for (std::size_t i = 0; i < size_; ++i) {
    Step& step = steps[i];
    step.inRoom_m = heads[i].roomFromHead.position_m - observers_[i].head.roomFromHead.position_m;
    if (!(glm::length(step.inRoom_m) <= most_m)) step.inRoom_m = Vec3(0.0);
    step.ahead_s = ahead_s_[i];
  }
  for (std::size_t i = 0; i < size_; ++i) {
    if (i == steering) continue;
    Step& step = steps[i];
    const Vec3 before_m = observers_[i].placeInRoom_m - observers_[steering].placeInRoom_m;
    const Vec3 after_m = before_m + step.inRoom_m - steps[steering].inRoom_m;
    step.lapse = 1.0 + glm::dot(thrust_m_s2, 0.5 * (before_m + after_m)) / (c_m_s * c_m_s);
    step.carried_m = carried_m_[i];
    if (turn.angle_rad != 0.0) step.carried_m += rotationOf(turn) * after_m - after_m;
  }
  return steps;
}

/// Returns the own time that somebody who is ahead must at least live in a step of so much of the fastest's.
static double leastOwnTime_s(double elapsed_s, double ahead_s) { return std::max(0.0, elapsed_s - ahead_s); }

// dT = max over the observers of hypot(dt, |dx|/c)/N. Where the thrust changes within a frame, an observer
// who has lived more than dt so far lives less in the rest of it: over a whole frame the fastest lives dt.
double Observers::roomTimeOf_s(const Steps& steps, double elapsed_s) const {
  double most_s = 0.0;
  for (std::size_t i = 0; i < size_; ++i) {
    const double way_m = glm::length(steps[i].inRoom_m + steps[i].carried_m);
    most_s = std::max(most_s, std::hypot(leastOwnTime_s(elapsed_s, steps[i].ahead_s),
                                         way_m / boardFromRoom_.lightSpeed_m_s()) /
                                  steps[i].lapse);
  }
  return most_s;
}

double Observers::roomTimeOf_s(double dt_s, std::span<const Head> heads, double pace, const Vec3& thrust_m_s2,
                               std::size_t steering) const {
  return roomTimeOf_s(stepsTo(dt_s, heads, thrust_m_s2, steering, {}), pace * dt_s);
}

// dτ = sqrt((N dT)² − |dx|²/c²), which is dt for the observer who determines dT, and longer for the others.
// Celerity is motion per own time; of this the frame so far has had dt and the observer's lead.
void Observers::advance(const Steps& steps, double roomTime_s, double elapsed_s) {
  livedOfFrame_s_ += elapsed_s;
  for (std::size_t i = 0; i < size_; ++i) {
    const Step& step = steps[i];
    const double way_s = glm::length(step.inRoom_m + step.carried_m) / boardFromRoom_.lightSpeed_m_s();
    const double least_s = leastOwnTime_s(elapsed_s, step.ahead_s);
    double own_s = least_s;
    if (const double here_s = step.lapse * roomTime_s; std::hypot(least_s, way_s) / step.lapse < roomTime_s)
      own_s = std::max(least_s, std::sqrt((here_s - way_s) * (here_s + way_s)));
    ahead_s_[i] = std::max(0.0, step.ahead_s + (own_s - elapsed_s));
    observers_[i].properTime_s += own_s;
    observers_[i].head.celerity_m_s /= livedOfFrame_s_ > 0.0 ? 1.0 + ahead_s_[i] / livedOfFrame_s_ : 1.0;
    observers_[i].placeInRoom_m += step.inRoom_m;
    observers_[i].lapse = step.lapse;
  }
  room_s_ += roomTime_s;
}

// On the hyperbola of proper acceleration a, from rest, after proper time T, with φ = aT/c:
//   (ct, x) = (c²/a) (sinh φ, cosh φ − 1) = (2c²/a) sinh(φ/2) (cosh(φ/2), sinh(φ/2))
// which in the frame boosted by φ/2 is the time T sinh(φ/2)/(φ/2) alone (Rindler 2006, §3.8).
void Observers::step(double dt_s, std::span<const Head> heads, double pace, const Vec3& thrust_m_s2,
                     std::size_t steering, const RoomTurn& turn) {
  const double c_m_s = boardFromRoom_.lightSpeed_m_s();
  const double elapsed_s = pace * dt_s;
  const Steps steps = stepsTo(dt_s, heads, thrust_m_s2, steering, turn);
  const double roomTime_s = roomTimeOf_s(steps, elapsed_s);
  const Vec3& step_m = steps[steering].inRoom_m;
  const Vec3 rapidity = thrust_m_s2 * (roomTime_s / c_m_s);
  Event& steered = observers_[steering].headEvent;
  if (rapidity == Vec3(0.0)) {
    steered = steered + boardFromRoom_ * Displacement{roomTime_s, step_m};
  } else {
    const Lorentz half = halfBoost(rapidity, c_m_s);
    const double chord_s = roomTime_s * sinhc(0.5 * glm::length(rapidity));
    steered = steered + boardFromRoom_ * (half * Displacement{chord_s, step_m});
    boardFromRoom_ = (boardFromRoom_ * half * half).orthonormalised();
  }
  for (std::size_t i = 0; i < size_; ++i)
    observers_[i].head = {heads[i].roomFromHead, heads[i].celerity_m_s / pace};
  advance(steps, roomTime_s, elapsed_s);
  carried_m_ = {};
  if (turn.angle_rad != 0.0) rotate(rotationOf(turn));
  placeOthers(steering);
  reportLapses();
}

/// Places the others where they are at the present of the one who steers, in the room's frame.
void Observers::placeOthers(std::size_t steering) {
  const OneObserver& steered = observers_[steering];
  for (std::size_t i = 0; i < size_; ++i) {
    if (i == steering) continue;
    const Vec3 apart_m = observers_[i].placeInRoom_m - steered.placeInRoom_m;
    observers_[i].headEvent = steered.headEvent + boardFromRoom_ * Displacement{0.0, apart_m};
  }
}

/// A frame of several steps reports the lapse with which its proper time follows from its beginning and end:
/// N = hypot(dτ, |dx|/c)/dT.
void Observers::reportLapses() {
  if (++stepsOfFrame_ < 2 || !(room_s_ > frameFrom_s_)) return;
  for (std::size_t i = 0; i < size_; ++i) {
    OneObserver& now = observers_[i];
    const double way_m = glm::distance(now.placeInRoom_m, frameFrom_[i].placeInRoom_m);
    now.lapse =
        std::hypot(now.properTime_s - frameFrom_[i].properTime_s, way_m / boardFromRoom_.lightSpeed_m_s()) /
        (room_s_ - frameFrom_s_);
  }
}

void Observers::moveUnseen(double roomTime_s, std::span<const Head> heads) {
  for (std::size_t i = 0; i < size_; ++i) {
    const Vec3 step_m = heads[i].roomFromHead.position_m - observers_[i].head.roomFromHead.position_m;
    observers_[i].headEvent = observers_[i].headEvent + boardFromRoom_ * Displacement{roomTime_s, step_m};
    observers_[i].placeInRoom_m += step_m;
    observers_[i].head = {heads[i].roomFromHead, Vec3(0.0)};
  }
  room_s_ += roomTime_s;
  placeOthers(0);
}

void Observers::turn(const RoomTurn& turn, std::size_t steering) {
  const glm::dquat turned = rotationOf(turn);
  for (std::size_t i = 0; i < size_; ++i) {
    // In the turned axes, an observer at r was at R⁻¹r before.
    const Vec3 apart_m = observers_[i].placeInRoom_m - observers_[steering].placeInRoom_m;
    if (i != steering) carried_m_[i] = apart_m + glm::conjugate(turned) * (carried_m_[i] - apart_m);
  }
  rotate(turned);
}

void Observers::rotate(const glm::dquat& turned) {
  boardFromRoom_ =
      (boardFromRoom_ * Lorentz::rotation(turned, boardFromRoom_.lightSpeed_m_s())).orthonormalised();
}

ObserverView Observers::view(double eyeSeparation_m, std::size_t observer) const {
  const glm::dquat& attitude = observers_[observer].head.roomFromHead.orientation;
  const Vec3 right_m = attitude * Vec3(0.5 * eyeSeparation_m, 0.0, 0.0);
  return view(-right_m, right_m, observer);
}

ObserverView Observers::view(const Vec3& left_m, const Vec3& right_m, std::size_t observer) const {
  const double c_m_s = boardFromRoom_.lightSpeed_m_s();
  const auto& [headEvent, place_m, head, properTime_s, lapse] = observers_[observer];
  const Lorentz boardFromHead = boardFromRoom_ * Lorentz::boost(head.celerity_m_s / c_m_s, c_m_s);
  const auto eye = [&](const Vec3& offset_m) {
    const Vec3 inRoom_m = head.roomFromHead.position_m + offset_m;
    return EyeView{headEvent + boardFromHead * Displacement{0.0, offset_m}, inRoom_m, inRoom_m};
  };
  return {boardFromHead.inverse(), eye(left_m), eye(right_m), eye(Vec3(0.0)), properTime_s};
}

}  // namespace carom
