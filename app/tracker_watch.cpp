#include "app/tracker_watch.h"

#include <fmt/format.h>

#include <algorithm>

namespace carom {
namespace {

constexpr double kSilent_s = 5.0;
constexpr double kUnconnected_s = 2.0;  // most are there within that
constexpr double kLookEvery_s = 0.25;
constexpr std::size_t kMostSensors = 16;  // that a line can list

}  // namespace

TrackerWatch::TrackerWatch(std::string name, int sensor) : name_(std::move(name)), sensor_(sensor) {
  otherSensors_.reserve(kMostSensors);
}

void TrackerWatch::see(double now_s, std::span<const TrackerSample> samples) {
  for (const TrackerSample& sample : samples) {
    if (sample.sensor == sensor_) {
      seen_s_ = now_s;
      wasSeen_ = true;
    } else if (otherSensors_.size() < kMostSensors &&
               std::find(otherSensors_.begin(), otherSensors_.end(), sample.sensor) == otherSensors_.end()) {
      otherSensors_.insert(std::upper_bound(otherSensors_.begin(), otherSensors_.end(), sample.sensor),
                           sample.sensor);
    }
  }
}

std::optional<std::string> TrackerWatch::look(double now_s, const TrackerHealth& health) {
  due_s_ = now_s + kLookEvery_s;
  if (health.state == TrackerHealth::State::delivering) well_s_ = now_s;
  const Trouble trouble = troubleOf(now_s, health);
  const bool tooSoon = trouble == Trouble::none && told_ != Trouble::none && now_s - seen_s_ > kLookEvery_s;
  if (trouble == told_ || tooSoon) return {};
  const std::string what = trouble == Trouble::none ? returnLine(now_s) : line(trouble, health);
  if (told_ == Trouble::none && wasSeen_) missedSince_s_ = seen_s_;
  if (trouble == Trouble::none) missedSince_s_.reset();
  told_ = trouble;
  return fmt::format("Tracker {}: {}", name_, what);
}

TrackerWatch::Trouble TrackerWatch::troubleOf(double now_s, const TrackerHealth& health) const {
  switch (health.state) {
    case TrackerHealth::State::failed:
      return Trouble::failed;
    case TrackerHealth::State::connecting:
      return now_s - well_s_ >= kUnconnected_s ? Trouble::connecting : told_;
    case TrackerHealth::State::silent:
      return now_s - seen_s_ >= kSilent_s ? Trouble::silent : told_;
    case TrackerHealth::State::delivering:
      break;
  }
  return now_s - seen_s_ >= kSilent_s ? Trouble::unseen : Trouble::none;
}

std::string TrackerWatch::line(Trouble trouble, const TrackerHealth& health) const {
  const std::string held = wasSeen_ ? "; the head is held" : "";
  switch (trouble) {
    case Trouble::none:
      break;
    case Trouble::failed:
      return health.message + held;
    case Trouble::connecting:
      return (health.message.empty() ? "nothing has come yet" : health.message) + "; it is tried again" +
             held;
    case Trouble::silent:
      return fmt::format("silent since second {:.1f} of the session{}", seen_s_, held);
    case Trouble::unseen:
      break;
  }
  if (wasSeen_) {
    return fmt::format("sensor {} has not been seen since second {:.1f} of the session{}", sensor_, seen_s_,
                       held);
  }
  return fmt::format(
      "sensor {} never came; this tracker has sent {}", sensor_,
      otherSensors_.empty() ? "no poses" : fmt::format("sensors {}", fmt::join(otherSensors_, ", ")));
}

std::string TrackerWatch::returnLine(double now_s) const {
  if (!missedSince_s_) return "delivers";
  return fmt::format("delivers again, after {:.1f} s", now_s - *missedSince_s_);
}

}  // namespace carom
