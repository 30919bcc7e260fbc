#include "app/viewer/viewer.h"

namespace carom {
namespace {

Head headOf(const HeadEstimate& estimate) { return {estimate.pose, estimate.celerity_m_s}; }

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
