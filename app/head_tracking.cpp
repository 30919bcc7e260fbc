#include "app/head_tracking.h"

#include <fmt/format.h>

#include "app/open_tracker.h"

namespace carom {

HeadTracking::HeadTracking(const Rig& rig, std::chrono::steady_clock::time_point sessionStart)
    : setup_(rig.head),
      roomFromTracker_(rig.trackers[rig.head.sensor.tracker].roomFromTracker),
      latency_s_(rig.trackers[rig.head.sensor.tracker].latency_s),
      tracker_(openTracker(rig.trackers[rig.head.sensor.tracker], rig.axes, sessionStart)),
      watch_(rig.trackers[rig.head.sensor.tracker].name, rig.head.sensor.sensor),
      standing_{rig.axes.up * kStandingEyes_m, {1.0, 0.0, 0.0, 0.0}} {
  constexpr std::size_t kMostSamples = 4096;  // of one frame: more than a device's queue holds
  samples_.reserve(kMostSamples);
}

HeadEstimate HeadTracking::at(const FrameTimes& times) {
  samples_.clear();
  tracker_->poll(times.begin_s, samples_);
  watch_.see(times.begin_s, samples_);
  if (watch_.isDue(times.begin_s)) {
    if (const auto line = watch_.look(times.begin_s, tracker_->health(times.begin_s))) {
      fmt::print(stderr, "{}\n", *line);
    }
  }
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
