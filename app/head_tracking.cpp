#include "app/head_tracking.h"

#include "devices/recorded_tracker.h"
#include "devices/simulated_tracker.h"
#include "devices/trace.h"

namespace carom {
namespace {

constexpr double kStandingEyes_m = 1.7;  // above the floor, until the tracker has said otherwise

}  // namespace

std::unique_ptr<Tracker> openTracker(const TrackerSetup& setup, const RoomAxes& axes) {
  switch (setup.kind) {
    case TrackerKind::recorded:
      return std::make_unique<RecordedTracker>(readTrace(setup.source), setup.name);
    case TrackerKind::simulated:
      break;
  }
  SimulatedPerson person;
  person.axes = {axes.right, axes.up, axes.forward};
  return std::make_unique<SimulatedTracker>(person);
}

HeadTracking::HeadTracking(const Rig& rig)
    : setup_(rig.head),
      roomFromTracker_(rig.trackers[rig.head.sensor.tracker].roomFromTracker),
      latency_s_(rig.trackers[rig.head.sensor.tracker].latency_s),
      tracker_(openTracker(rig.trackers[rig.head.sensor.tracker], rig.axes)),
      standing_{rig.axes.up * kStandingEyes_m, {1.0, 0.0, 0.0, 0.0}} {
  samples_.reserve(64);
}

HeadEstimate HeadTracking::at(const FrameTimes& times) {
  samples_.clear();
  tracker_->poll(times.begin_s, samples_);
  const Pose sensorFromEyes = inverse(setup_.eyesFromSensor);
  for (const TrackerSample& sample : samples_) {
    if (sample.sensor != setup_.sensor.sensor) continue;
    filter_.add(sample.time_s - latency_s_, roomFromTracker_ * sample.pose * sensorFromEyes);
    tracked_ = true;
  }
  HeadEstimate head = filter_.at(times.display_s);
  if (!tracked_) head.pose = standing_;
  return head;
}

}  // namespace carom
