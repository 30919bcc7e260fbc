#include "devices/monitor/tracker_alarm.h"

#include <fmt/format.h>

#include <algorithm>

namespace carom {
namespace {

constexpr double kSilent_s = 5.0;
constexpr double kUnconnected_s = 2.0;  // most are there within that
constexpr double kLookEvery_s = 0.25;
constexpr std::size_t kMostSensors = 16;  // that a line can list
constexpr std::size_t kMostMessages = 4;  // of one trouble: a connection may fail in many ways in turn

bool isWell(const TrackerHealth& health) {
  return health.state == TrackerHealth::State::delivering || health.state == TrackerHealth::State::untouched;
}

}  // namespace

TrackerAlarm::TrackerAlarm(std::string name, std::optional<int> sensor, std::string withoutIt)
    : name_(std::move(name)), sensor_(sensor), withoutIt_(std::move(withoutIt)) {
  otherSensors_.reserve(kMostSensors);
}

void TrackerAlarm::see(double now_s, std::span<const TrackerSample> samples) {
  for (const TrackerSample& sample : samples) {
    if (sample.sensor == sensor_) {
      seen_s_ = now_s;
      pose_s_ = sample.time_s;
      if (!back_s_) back_s_ = pose_s_;
      wasSeen_ = true;
    } else if (otherSensors_.size() < kMostSensors &&
               std::find(otherSensors_.begin(), otherSensors_.end(), sample.sensor) == otherSensors_.end()) {
      otherSensors_.insert(std::upper_bound(otherSensors_.begin(), otherSensors_.end(), sample.sensor),
                           sample.sensor);
    }
  }
}

std::optional<std::string> TrackerAlarm::look(double now_s, const TrackerHealth& health) {
  due_s_ = now_s + kLookEvery_s;
  if (isWell(health)) well_s_ = now_s;
  const Trouble trouble = troubleOf(now_s, health);
  if (trouble == told_) {
    const bool mayTell = trouble == Trouble::connecting || (trouble == Trouble::none && isWell(health));
    if (!mayTell || !isNew(health)) return {};
    return told(trouble == Trouble::none ? health.message : line(trouble, health));
  }
  if (trouble == Trouble::none) {
    if (sensor_ && now_s - seen_s_ > kLookEvery_s) return {};  // too soon to say so
    told_ = trouble;
    const std::string again = returnLine();
    missedSince_s_.reset();
    return told(again);
  }
  messages_.clear();
  isNew(health);
  if (told_ == Trouble::none && wasSeen_) missedSince_s_ = pose_s_;
  back_s_.reset();
  told_ = trouble;
  return told(line(trouble, health));
}

/// Whether its message has not been told yet; notes it.
bool TrackerAlarm::isNew(const TrackerHealth& health) {
  if (health.message.empty() || messages_.size() == kMostMessages) return false;
  if (std::find(messages_.begin(), messages_.end(), health.message) != messages_.end()) return false;
  messages_.push_back(health.message);
  return true;
}

TrackerAlarm::Trouble TrackerAlarm::troubleOf(double now_s, const TrackerHealth& health) const {
  switch (health.state) {
    case TrackerHealth::State::failed:
      return Trouble::failed;
    case TrackerHealth::State::connecting:
      return now_s - well_s_ >= kUnconnected_s ? Trouble::connecting : told_;
    case TrackerHealth::State::silent:
      if (!sensor_) return Trouble::none;
      return now_s - seen_s_ >= kSilent_s ? Trouble::silent : told_;
    case TrackerHealth::State::untouched:
    case TrackerHealth::State::delivering:
      break;
  }
  return sensor_ && now_s - seen_s_ >= kSilent_s ? Trouble::unseen : Trouble::none;
}

std::string TrackerAlarm::line(Trouble trouble, const TrackerHealth& health) const {
  const std::string held = wasSeen_ ? "; " + withoutIt_ : "";
  switch (trouble) {
    case Trouble::none:
      break;
    case Trouble::failed:
      return health.message + held;
    case Trouble::connecting:
      return (health.message.empty() ? "nothing has come yet" : health.message) +
             (health.connected ? "; it is waited for" : "; it is tried again") + held;
    case Trouble::silent:
      return fmt::format("silent since second {:.1f} of the session{}", pose_s_, held);
    case Trouble::unseen:
      break;
  }
  if (wasSeen_) {
    return fmt::format("sensor {} has not been seen since second {:.1f} of the session{}", *sensor_, pose_s_,
                       held);
  }
  return fmt::format(
      "sensor {} never came; this tracker has sent {}", *sensor_,
      otherSensors_.empty() ? "no poses" : fmt::format("sensors {}", fmt::join(otherSensors_, ", ")));
}

std::string TrackerAlarm::told(const std::string& what) const {
  return fmt::format("Tracker {}: {}", name_, what);
}

std::string TrackerAlarm::returnLine() const {
  if (!missedSince_s_) return "delivers";
  return fmt::format("delivers again, after {:.1f} s", back_s_.value_or(pose_s_) - *missedSince_s_);
}

}  // namespace carom
