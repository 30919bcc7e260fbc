#pragma once
// Counts how often a device reports that it has lost sight of a sensor that it had seen. The number of frames
// without the sensor does not matter.

#include <algorithm>
#include <cstddef>
#include <limits>
#include <span>

#include "devices/tracker/reading.h"
#include "devices/tracker/tracker.h"

namespace carom {

class LossCounter {
 public:
  explicit LossCounter(int sensor) : sensor_(sensor) {}

  /// Takes what one poll delivered, for all sensors of the tracker.
  void see(std::span<const TrackerSample> samples, std::span<const Reading> inputs) {
    for (const Reading& input : inputs) {
      if (input.kind != Reading::Kind::lost || input.sensor != sensor_) continue;
      for (const TrackerSample& sample : samples) {
        if (sample.sensor == sensor_ && sample.time_s <= input.device_s)
          seen_s_ = std::max(seen_s_, sample.time_s);
      }
      if (seen_s_ > lost_s_) ++count_;
      lost_s_ = std::max(lost_s_, input.device_s);
    }
    for (const TrackerSample& sample : samples) {
      if (sample.sensor == sensor_) seen_s_ = std::max(seen_s_, sample.time_s);
    }
  }
  std::size_t count() const { return count_; }

 private:
  static constexpr double kNever_s = -std::numeric_limits<double>::infinity();
  int sensor_;
  double seen_s_ = kNever_s, lost_s_ = kNever_s;  // the newest of each, session's clock
  std::size_t count_ = 0;
};

}  // namespace carom
