#pragma once
// The last known place of a tracker's sensor.

#include <limits>
#include <span>

#include "devices/tracker/tracker.h"
#include "engine/base/limits.h"
#include "engine/base/pose.h"

namespace carom {

/// The newest pose of one sensor in the room.
class SensorPlace {
 public:
  SensorPlace(int sensor, const Pose& roomFromTracker) : sensor_(sensor), roomFromTracker_(roomFromTracker) {}

  void see(double now_s, std::span<const TrackerSample> samples) {
    for (const TrackerSample& sample : samples) {
      if (sample.sensor != sensor_) continue;
      roomFromSensor_ = roomFromTracker_ * sample.pose;
      told_s_ = now_s;
      newest_s_ = sample.time_s;
      ++counted_;
    }
    if (now_s - countedFrom_s_ < 1.0) return;
    rate_hz_ = counted_ / (now_s - countedFrom_s_);
    countedFrom_s_ = now_s;
    counted_ = 0;
  }
  const Pose& roomFromSensor() const { return roomFromSensor_; }
  /// Whether a pose has arrived within kHandLost_s.
  bool isKnown(double now_s) const { return now_s - told_s_ <= kHandLost_s; }

  double newest_s() const { return newest_s_; }  ///< time of the newest sample; NaN: none yet
  double rate_hz() const { return rate_hz_; }    ///< of samples, about the last second; NaN at first

 private:
  int sensor_;
  Pose roomFromTracker_, roomFromSensor_;
  double told_s_ = -std::numeric_limits<double>::infinity();
  double newest_s_ = std::numeric_limits<double>::quiet_NaN();
  double rate_hz_ = std::numeric_limits<double>::quiet_NaN();
  double countedFrom_s_ = 0.0;
  int counted_ = 0;
};

}  // namespace carom
