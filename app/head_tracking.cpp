#include "app/head_tracking.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/open_tracker.h"

namespace carom {
namespace {

/// From its first samples the filter cannot tell noise from motion: so long the velocity comes in little by
/// little, or the hall would hop when a session begins.
constexpr double kFirst_s = 0.5;

}  // namespace

HeadTracking::HeadTracking(const Rig& rig, std::chrono::steady_clock::time_point sessionStart)
    : setup_(rig.head),
      roomFromTracker_(rig.trackers[rig.head.sensor.tracker].roomFromTracker),
      latency_s_(rig.trackers[rig.head.sensor.tracker].latency_s),
      tracker_(openTracker(rig.trackers[rig.head.sensor.tracker], rig.axes, sessionStart)),
      watch_(rig.trackers[rig.head.sensor.tracker].name, rig.head.sensor.sensor),
      headPlace_(rig.head.sensor.sensor, roomFromTracker_),
      standing_{rig.axes.up * kStandingEyes_m, {1.0, 0.0, 0.0, 0.0}} {
  constexpr std::size_t kMostSamples = 4096;  // of one frame: more than a device's queue holds
  samples_.reserve(kMostSamples);
  if (!rig.hand) return;
  const TrackerSetup& hand = rig.trackers[rig.hand->tracker];
  if (hand.kind == TrackerKind::spaceMouse) return;  // it has no place
  handPlace_.emplace(rig.hand->sensor, hand.roomFromTracker);
  if (rig.hand->tracker == rig.head.sensor.tracker) return;
  handTracker_ = openTracker(hand, rig.axes, sessionStart);
  handSamples_.reserve(kMostSamples);
}

void SensorPlace::see(double now_s, std::span<const TrackerSample> samples) {
  for (const TrackerSample& sample : samples) {
    if (sample.sensor != sensor_) continue;
    roomFromSensor_ = roomFromTracker_ * sample.pose;
    told_s_ = now_s;
  }
}

void HeadTracking::followSensors(double now_s) {
  begin_s_ = now_s;
  headPlace_.see(now_s, samples_);
  if (!handPlace_) return;
  handSamples_.clear();
  if (handTracker_) handTracker_->poll(now_s, handSamples_);
  handPlace_->see(now_s, handTracker_ ? std::span<const TrackerSample>(handSamples_) : samples_);
}

Tracked HeadTracking::tracked() const {
  Tracked tracked;
  tracked.roomFromHeadSensor = headPlace_.roomFromSensor();
  tracked.headKnown = headPlace_.isKnown(begin_s_) ? 1 : 0;
  if (!handPlace_) return tracked;
  tracked.roomFromHand = handPlace_->roomFromSensor();
  tracked.handKnown = handPlace_->isKnown(begin_s_) ? 1 : 0;
  return tracked;
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
  followSensors(times.begin_s);
  const Pose sensorFromEyes = inverse(setup_.eyesFromSensor);
  for (const TrackerSample& sample : samples_) {
    if (sample.sensor != setup_.sensor.sensor) continue;
    filter_.add(sample.time_s - latency_s_, roomFromTracker_ * sample.pose * sensorFromEyes);
    if (!firstTracked_s_) firstTracked_s_ = times.display_s;
  }
  HeadEstimate head = filter_.at(times.display_s);
  if (!firstTracked_s_) {
    head.pose = standing_;
  } else {
    head.celerity_m_s *= std::min((times.display_s - *firstTracked_s_) / kFirst_s, 1.0);
  }
  return head;
}

}  // namespace carom
