#include "app/viewer/hand_tracking.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace carom {
namespace {

constexpr double kButtonsWithin_s = 5.0;  // most devices send their state at once
constexpr const char* kWithoutWand = "the wand aims at nothing";

/// Returns the first SpaceMouse of the rig, or null if there is none.
const TrackerSetup* spaceMouseOf(const Rig& rig) {
  const auto found = std::find_if(rig.trackers.begin(), rig.trackers.end(), [](const TrackerSetup& tracker) {
    return tracker.kind == TrackerKind::spaceMouse;
  });
  return found == rig.trackers.end() ? nullptr : &*found;
}

bool isFirst(const Rig& rig, const ViewerSetup& viewer) { return &viewer == &rig.viewers.front(); }

HandTracking::Trackers open(const Rig& rig, const ViewerSetup& viewer, SharedTrackers& shared) {
  HandTracking::Trackers trackers;
  const auto opened = [&](std::size_t tracker) -> std::unique_ptr<Tracker> {
    const bool isMouse = rig.trackers[tracker].kind == TrackerKind::spaceMouse;
    if (tracker == viewer.head.sensor.tracker || isMouse) return nullptr;
    return shared.follow(tracker);
  };
  if (viewer.hand) trackers.wand = opened(viewer.hand->tracker);
  if (viewer.hand && viewer.hand->buttons) trackers.buttons = opened(*viewer.hand->buttons);
  const TrackerSetup* mouse = spaceMouseOf(rig);
  if (mouse && isFirst(rig, viewer))
    trackers.spaceMouse = shared.follow(static_cast<std::size_t>(mouse - rig.trackers.data()));
  return trackers;
}

}  // namespace

HandTracking::HandTracking(const Rig& rig, const ViewerSetup& viewer, SharedTrackers& trackers)
    : HandTracking(rig, viewer, open(rig, viewer, trackers)) {}

HandTracking::HandTracking(const Rig& rig, const ViewerSetup& viewer, Trackers trackers)
    : trackers_(std::move(trackers)) {
  samples_.reserve(kMostSamples);
  inputs_.reserve(kMostSamples);
  if (const TrackerSetup* mouse = spaceMouseOf(rig)) spaceMouseName_ = mouse->name;
  if (!viewer.hand) return;
  const TrackerSetup& wand = rig.trackers[viewer.hand->tracker];
  if (wand.kind == TrackerKind::spaceMouse) return;  // it has no pose
  place_.emplace(viewer.hand->sensor, wand.roomFromTracker);
  sensorFromHand_ = inverse(viewer.hand->handFromSensor);
  sensor_ = viewer.hand->sensor;
  wandName_ = buttons_.name = wand.name;
  wandWatch_.emplace(wandName_, sensor_, kWithoutWand);
  buttons_.isOther = viewer.hand->buttons.has_value();
  if (!buttons_.isOther) {
    buttons_.sensor = wand.kind == TrackerKind::vrpn ? 0 : sensor_;  // as vrpn_decoder.h
    return;
  }
  buttons_.name = rig.trackers[*viewer.hand->buttons].name;
  buttons_.watch.emplace(buttons_.name, std::nullopt);
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
  if (trackers_.buttons)
    reports.push_back(reportOf(buttons_.name, "buttons", *trackers_.buttons, nullptr, now_s));
  if (trackers_.spaceMouse)
    reports.push_back(reportOf(spaceMouseName_, "steering", *trackers_.spaceMouse, nullptr, now_s));
}

/// Returns whether a sensor's buttons are the wand's. Another tracker numbers its sensors in its own way, so
/// its first sensor that sends buttons is taken, unless the one with the wand's number sends some too.
bool HandTracking::isOfTheWand(int sensor) {
  if (buttons_.isOther && sensor != buttons_.sensor && (!buttons_.sensor || sensor == sensor_)) {
    buttons_.sensor = sensor;
    releaseWand();
  }
  return sensor == buttons_.sensor;
}

/// Releases all buttons: they must be pressed again.
void HandTracking::releaseWand() {
  devices_.wand = {};
  wandChanges_.forget();
}

void HandTracking::takeButtons(std::span<const Reading> inputs) {
  wandChanges_.beginFrame(devices_.wand);
  for (const Reading& reading : inputs) {
    if (reading.kind != Reading::Kind::button && reading.kind != Reading::Kind::axis) continue;
    if (!isOfTheWand(reading.sensor)) continue;
    wandChanges_.take(reading, devices_.wand);
    if (buttons_.state != Buttons::State::came) buttons_.isTold = buttons_.state == Buttons::State::awaited;
    buttons_.state = Buttons::State::came;
  }
}

void HandTracking::followWand(double now_s, std::span<const TrackerSample> samples,
                              std::span<const Reading> inputs) {
  if (trackers_.wand) {
    samples_.clear();
    inputs_.clear();
    trackers_.wand->poll(now_s, samples_);
    trackers_.wand->takeInputs(inputs_);
    samples = samples_;
    if (!buttons_.isOther) inputs = inputs_;
  }
  place_->see(now_s, samples);
  wandWatch_->see(now_s, samples);
  if (trackers_.buttons) {
    samples_.clear();  // poses from the buttons' tracker are ignored
    inputs_.clear();
    trackers_.buttons->poll(now_s, samples_);
    trackers_.buttons->takeInputs(inputs_);
    inputs = inputs_;
  }
  takeButtons(inputs);
  devices_.wandKnown = place_->isKnown(now_s);
  if (!devices_.wandKnown) releaseWand();
  devices_.roomFromHand = place_->roomFromSensor() * sensorFromHand_;
}

void HandTracking::follow(double now_s, std::span<const TrackerSample> samples,
                          std::span<const Reading> inputs) {
  if (place_) followWand(now_s, samples, inputs);
  if (trackers_.spaceMouse) {
    samples_.clear();  // it has none
    inputs_.clear();
    trackers_.spaceMouse->poll(now_s, samples_);
    trackers_.spaceMouse->takeInputs(inputs_);
    mouseChanges_.beginFrame(devices_.spaceMouse);
    for (const Reading& reading : inputs_) {
      if (reading.sensor == 0) mouseChanges_.take(reading, devices_.spaceMouse);
    }
  }
}

/// Returns the message about the wand's buttons, if any. `tracked` means that the wand has a pose and the
/// tracker of its buttons delivers.
std::optional<std::string> HandTracking::tellOfButtons(double now_s, bool tracked) {
  if (!tracked) trackedSince_s_.reset();
  if (tracked && !trackedSince_s_) trackedSince_s_ = now_s;
  if (buttons_.state == Buttons::State::awaited && trackedSince_s_ &&
      now_s - *trackedSince_s_ >= kButtonsWithin_s) {
    buttons_.state = Buttons::State::missed;
    return fmt::format("Tracker {}: no button or axis of the hand has come yet; {}", buttons_.name,
                       buttons_.isOther
                           ? "without one the wand only points"
                           : "if it has none, name a tracker that has some as buttons of [hand]");
  }
  if (std::exchange(buttons_.isTold, true)) return {};
  return fmt::format("Tracker {}: the hand's buttons have come", buttons_.name);
}

std::vector<std::string> HandTracking::look(double now_s, const Tracker& headTracker) {
  std::vector<std::string> lines;
  if (!place_) return lines;
  const auto tell = [&](const std::optional<std::string>& line) {
    if (line) lines.push_back(*line);
  };
  TrackerHealth well;
  well.state = TrackerHealth::State::delivering;
  tell(wandWatch_->look(now_s, trackers_.wand ? trackers_.wand->health(now_s) : well));
  bool tracked = devices_.wandKnown;
  if (buttons_.isOther) {
    const TrackerHealth health = (trackers_.buttons ? *trackers_.buttons : headTracker).health(now_s);
    if (trackers_.buttons) tell(buttons_.watch->look(now_s, health));
    if (health.state != TrackerHealth::State::delivering && health.state != TrackerHealth::State::untouched) {
      releaseWand();
      tracked = false;
    }
  }
  tell(tellOfButtons(now_s, tracked));
  return lines;
}

}  // namespace carom
