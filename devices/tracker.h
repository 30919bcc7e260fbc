#pragma once
// What every tracker offers, whether it is a device, a recording or a simulated person: poses of its
// sensors with the times at which they held.

#include <string>
#include <vector>

#include "engine/pose.h"

namespace carom {

/// One pose of one sensor.
struct TrackerSample {
  double time_s = 0.0;          ///< when the pose held, on the session's clock (a known latency taken off)
  int sensor = 0;               ///< counts from 0
  Pose pose;                    ///< trackerFromSensor, metres; identity orientation where none is measured
  bool hasOrientation = false;  ///< whether the tracker measures orientation
};

/// A source of samples. A tracker that waits for a device does so on a thread of its own and keeps what
/// arrives in a queue: polling never blocks. The session's clock is given with each poll, so that a
/// recorded or simulated tracker can run in simulated time and deliver the same bits in every run.
class Tracker {
 public:
  Tracker() = default;
  Tracker(const Tracker&) = delete;
  Tracker& operator=(const Tracker&) = delete;
  virtual ~Tracker() = default;

  /// Appends the samples delivered since the last poll with time_s <= now_s (session's clock, never
  /// running back), in order of time for each sensor. Allocates nothing once `samples` has room.
  virtual void poll(double now_s, std::vector<TrackerSample>& samples) = 0;

  /// For people: what this tracker is, in a few words.
  virtual std::string description() const = 0;
};

}  // namespace carom
