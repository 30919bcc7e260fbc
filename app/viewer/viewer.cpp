#include "app/viewer/viewer.h"

#include <algorithm>

namespace carom {
namespace {

Head headOf(const HeadEstimate& estimate) { return {estimate.pose, estimate.celerity_m_s}; }

Head atRest(const HeadEstimate& estimate) { return {estimate.pose, Vec3(0.0)}; }

Observer startOf(const Rig& rig, const Scenario& scenario, const Head& head,
                 const std::optional<FrameRecord>& before) {
  if (before) {
    const ObserverView& last = before->observer;
    return Observer::at(last.middle.observation, last.properTime_s, before->boardFromRoom, head);
  }
  const Lorentz room = startingRoom(scenario.observer, rig.axes, scenario.billiard.lightSpeed_m_s);
  return Observer(room, {0.0, scenario.observer.position_m}, head);
}

/// Returns times one period before the first frame is shown; a continued session keeps its clock.
FrameTimes firstTimes(const Rig& rig, const std::optional<FrameRecord>& before) {
  const double begin_s = before ? before->display_s : 0.0;
  return {0, begin_s, begin_s + 1.0 / rig.display_hz + rig.displayLatency_s, 0.0};
}

}  // namespace

Viewer::Viewer(const Rig& rig, const Scenario& scenario, std::chrono::steady_clock::time_point sessionStart,
               const std::optional<FrameRecord>& before)
    : tracking_(rig, sessionStart),
      head_(tracking_.at(firstTimes(rig, before))),
      observer_(startOf(rig, scenario, headOf(head_), before)) {}

void Viewer::startIn(const Rig& rig, const Scenario& scenario) {
  observer_ = startOf(rig, scenario, headOf(head_), {});
}

void Viewer::startAt(const Rig& rig, const Scenario& scenario, const ObserverStart& start, double board_s) {
  const Lorentz room = startingRoom(start, rig.axes, scenario.billiard.lightSpeed_m_s);
  observer_ = Observer(room, {0.0, start.position_m}, headOf(head_));
  // Board time runs γ times as fast as time in the room: dt = γ dT for a head at rest there.
  observer_.moveUnseen((board_s - observer_.headEvent().t_s) / gammaFromU(room.u()), headOf(head_));
}

ObserverView Viewer::at(const FrameTimes& times, double eyeSeparation_m, double pace) {
  head_ = tracking_.at(times);
  observer_.step(times.step_s, headOf(head_), pace);
  return observer_.view(eyeSeparation_m);
}

ObserverView Viewer::at(const FrameTimes& times, double eyeSeparation_m, double pace, const DriveWish& wish,
                        PlatformMotion& drive) {
  const Head before = headOf(head_);
  head_ = tracking_.at(times);
  drive.live(wish, times.step_s, pace, before, headOf(head_), observer_);
  return observer_.view(eyeSeparation_m);
}

ObserverView Viewer::slowView(const FrameTimes& times, double eyeSeparation_m, double pace, double step_s,
                              const DriveWish& wish, PlatformMotion& drive) {
  const Head before = atRest(head_);
  head_ = tracking_.at(times);
  drive.live(wish, step_s, pace, before, before, observer_);
  observer_.moveUnseen(0.0, headOf(head_));
  return observer_.view(eyeSeparation_m);
}

void Viewer::runTo(double board_s, PlatformMotion& drive) {
  constexpr double kStep_s = 1.0 / 60.0, kThere_s = 1e-9;
  const Head head = atRest(head_);
  for (double left_s = board_s - this->board_s(); left_s > kThere_s; left_s = board_s - this->board_s()) {
    const double step_s = std::min(kStep_s, left_s / gammaFromU(observer_.boardFromRoom().u()));
    drive.live({}, step_s, 1.0, head, head, observer_);
  }
}

ObserverView Viewer::frozenView(const ObserverView& sight, const FrameTimes& times, double eyeSeparation_m) {
  head_ = tracking_.at(times);
  observer_.step(0.0, headOf(head_));
  return frozenViewAt(sight, observer_.view(eyeSeparation_m));
}

ObserverView Viewer::freeView(const FrameTimes& times, double eyeSeparation_m, double roomTime_s) {
  head_ = tracking_.at(times);
  observer_.moveUnseen(roomTime_s, headOf(head_));
  return observer_.view(eyeSeparation_m);
}

}  // namespace carom
