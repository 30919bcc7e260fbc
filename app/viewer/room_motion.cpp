#include "app/viewer/room_motion.h"

namespace carom {

RoomMotion::RoomMotion(const Rig& rig, const Scenario& scenario, SharedTrackers trackers,
                       const std::optional<FrameRecord>& before)
    : rig_(rig),
      scenario_(scenario),
      viewers_(rig, scenario, std::move(trackers), before),
      drive_(scenario, rig.axes, !before) {}

void RoomMotion::start() {
  viewers_.startIn(rig_, scenario_);
  drive_ = PlatformMotion(scenario_, rig_.axes, true);
}

void RoomMotion::startAt(const ObserverStart& start, double board_s) {
  viewers_.startAt(rig_, scenario_, start, board_s);
  drive_ = PlatformMotion(scenario_, rig_.axes, true);
}

ObserverViews RoomMotion::advance(const RoomStep& step) {
  return viewers_.at(step.times, step.eyeSeparation_m, step.pace, step.wish, drive_, step.steering);
}

ObserverViews RoomMotion::advanceSlowly(const RoomStep& step, double own_s) {
  return viewers_.slowView(step.times, step.eyeSeparation_m, step.pace, own_s, step.wish, drive_,
                           step.steering);
}

}  // namespace carom
