#include "app/hand_tracking.h"

#include <algorithm>

#include "devices/open_tracker.h"

namespace carom {
namespace {

constexpr std::size_t kMostSamples = 4096;  // of one frame: more than a device's queue holds

void take(const Reading& reading, Handles& handles) {
  if (reading.index < 0) return;
  const auto index = static_cast<unsigned>(reading.index);
  if (reading.kind == Reading::Kind::button && index < 32) {
    const std::uint32_t bit = 1U << index;
    handles.down = reading.value != 0.0 ? handles.down | bit : handles.down & ~bit;
  }
  if (reading.kind == Reading::Kind::axis && index < handles.axes.size())
    handles.axes[index] = std::clamp(reading.value, -1.0, 1.0);
}

void takeOf(int sensor, std::span<const Reading> inputs, Handles& handles) {
  for (const Reading& reading : inputs) {
    if (reading.sensor == sensor) take(reading, handles);
  }
}

/// The first one of the rig; null: there is none.
const TrackerSetup* spaceMouseOf(const Rig& rig) {
  const auto found = std::find_if(rig.trackers.begin(), rig.trackers.end(), [](const TrackerSetup& tracker) {
    return tracker.kind == TrackerKind::spaceMouse;
  });
  return found == rig.trackers.end() ? nullptr : &*found;
}

HandTracking::Trackers open(const Rig& rig, std::chrono::steady_clock::time_point sessionStart) {
  HandTracking::Trackers trackers;
  if (rig.hand && rig.hand->tracker != rig.head.sensor.tracker &&
      rig.trackers[rig.hand->tracker].kind != TrackerKind::spaceMouse)
    trackers.wand = openTracker(rig.trackers[rig.hand->tracker], rig.axes, sessionStart);
  if (const TrackerSetup* mouse = spaceMouseOf(rig))
    trackers.spaceMouse = openTracker(*mouse, rig.axes, sessionStart);
  return trackers;
}

}  // namespace

HandTracking::HandTracking(const Rig& rig, std::chrono::steady_clock::time_point sessionStart)
    : HandTracking(rig, open(rig, sessionStart)) {}

HandTracking::HandTracking(const Rig& rig, Trackers trackers) : trackers_(std::move(trackers)) {
  samples_.reserve(kMostSamples);
  inputs_.reserve(kMostSamples);
  if (const TrackerSetup* mouse = spaceMouseOf(rig)) spaceMouseName_ = mouse->name;
  if (!rig.hand) return;
  const TrackerSetup& wand = rig.trackers[rig.hand->tracker];
  if (wand.kind == TrackerKind::spaceMouse) return;  // it has no place
  place_.emplace(rig.hand->sensor, wand.roomFromTracker);
  sensorFromHand_ = inverse(rig.hand->handFromSensor);
  inputSensor_ = wand.kind == TrackerKind::vrpn ? 0 : rig.hand->sensor;  // as vrpn_decoder.h
  wandName_ = wand.name;
}

TrackerReport reportOf(const std::string& name, const char* use, const Tracker& tracker,
                       const SensorPlace* place, double now_s) {
  TrackerReport report;
  report.name = name;
  report.use = use;
  report.health = tracker.health(now_s);
  if (!place) return report;
  report.rate_hz = place->rate_hz();
  report.age_s = now_s - place->newest_s();
  return report;
}

void HandTracking::report(double now_s, const Tracker& headTracker,
                          std::vector<TrackerReport>& reports) const {
  const Tracker& wand = trackers_.wand ? *trackers_.wand : headTracker;
  if (place_) reports.push_back(reportOf(wandName_, "hand", wand, &*place_, now_s));
  if (trackers_.spaceMouse)
    reports.push_back(reportOf(spaceMouseName_, "steering", *trackers_.spaceMouse, nullptr, now_s));
}

void HandTracking::follow(double now_s, std::span<const TrackerSample> samples,
                          std::span<const Reading> inputs) {
  samples_.clear();
  if (place_) {
    inputs_.clear();
    if (trackers_.wand) {
      trackers_.wand->poll(now_s, samples_);
      trackers_.wand->takeInputs(inputs_);
      samples = samples_;
      inputs = inputs_;
    }
    place_->see(now_s, samples);
    takeOf(inputSensor_, inputs, devices_.wand);
    devices_.wandKnown = place_->isKnown(now_s);
    if (!devices_.wandKnown) devices_.wand = {};  // who finds it again presses anew
    devices_.roomFromHand = place_->roomFromSensor() * sensorFromHand_;
  }
  if (trackers_.spaceMouse) {
    samples_.clear();  // it has none
    inputs_.clear();
    trackers_.spaceMouse->poll(now_s, samples_);
    trackers_.spaceMouse->takeInputs(inputs_);
    takeOf(0, inputs_, devices_.spaceMouse);
  }
}

}  // namespace carom
