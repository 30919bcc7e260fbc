#include "app/viewer/head_tracking.h"

#include <glm/geometric.hpp>

#include "engine/text/log.h"

namespace carom {
namespace {

/// Returns the tracker of a head, which a headset is itself.
std::unique_ptr<Tracker> trackerOf(TrackerKind kind, std::size_t tracker, SharedTrackers& trackers) {
  if (kind == TrackerKind::headset) return std::make_unique<HeadsetTracker>();
  return trackers.follow(tracker);
}

}  // namespace

HeadTracking::HeadTracking(const Rig& rig, const ViewerSetup& viewer, SharedTrackers& trackers)
    : setup_(viewer.head),
      roomFromTracker_(rig.trackers[setup_.sensor.tracker].roomFromTracker),
      latency_s_(rig.trackers[setup_.sensor.tracker].latency_s),
      tracker_(trackerOf(rig.trackers[setup_.sensor.tracker].kind, setup_.sensor.tracker, trackers)),
      headset_(dynamic_cast<HeadsetTracker*>(tracker_.get())),
      watch_(rig.trackers[setup_.sensor.tracker].name, setup_.sensor.sensor),
      headPlace_(setup_.sensor.sensor, roomFromTracker_),
      hand_(rig, viewer, trackers),
      name_(rig.trackers[setup_.sensor.tracker].name),
      standing_{rig.axes.up * kStandingEyes_m, {1.0, 0.0, 0.0, 0.0}} {
  polled_.samples.reserve(kMostSamples);
  polled_.inputs.reserve(kMostSamples);
}

Tracked HeadTracking::tracked() const {
  Tracked tracked;
  tracked.roomFromHeadSensor = headPlace_.roomFromSensor();
  tracked.headKnown = headPlace_.isKnown(begin_s_) ? 1 : 0;
  if (!hand_.place()) return tracked;
  tracked.roomFromHand = hand_.place()->roomFromSensor();
  tracked.handKnown = hand_.place()->isKnown(begin_s_) ? 1 : 0;
  return tracked;
}

std::vector<TrackerReport> HeadTracking::reports(const HeadEstimate& head) const {
  std::vector<TrackerReport> reports{reportOf(name_, "head", *tracker_, &headPlace_, begin_s_)};
  reports.front().known = head.known;
  reports.front().shownAfter_s = head.time_s - (headPlace_.newest_s() - latency_s_);
  reports.front().celerity_m_s = glm::length(head.celerity_m_s);
  reports.front().sigma_m_s = head.sigma_m_s;
  hand_.report(begin_s_, *tracker_, reports);
  return reports;
}

HeadEstimate HeadTracking::at(const FrameTimes& times) {
  polled_.samples.clear();
  polled_.inputs.clear();
  if (headset_) headset_->take(times.headset);
  tracker_->poll(times.begin_s, polled_.samples);
  tracker_->takeInputs(polled_.inputs);
  watch_.see(times.begin_s, polled_.samples);
  if (watch_.isDue(times.begin_s)) {
    if (const auto line = watch_.look(times.begin_s, tracker_->health(times.begin_s)))
      alarms_.push_back(*line);
  }
  begin_s_ = times.begin_s;
  headPlace_.see(begin_s_, polled_.samples);
  hand_.follow(begin_s_, polled_.samples, polled_.inputs);
  if (hand_.isDue(begin_s_)) {
    for (const std::string& line : hand_.look(begin_s_, *tracker_)) alarms_.push_back(line);
  }
  if (headset_ && times.step_s == 0.0) filter_ = HeadFilter();
  const Pose sensorFromEyes = inverse(setup_.eyesFromSensor);
  for (const TrackerSample& sample : polled_.samples) {
    if (sample.sensor != setup_.sensor.sensor) continue;
    if (!filter_.hasStarted()) filter_.fadeInFrom(times.display_s);
    const Pose roomFromHead = roomFromTracker_ * sample.pose * sensorFromEyes;
    filter_.add(sample.time_s - latency_s_, roomFromHead);
    if (headset_) given_ = roomFromHead;
  }
  HeadEstimate head = filter_.at(times.display_s);
  if (!filter_.hasStarted()) head.pose = standing_;
  if (given_) head.pose = *given_;
  return head;
}

}  // namespace carom
