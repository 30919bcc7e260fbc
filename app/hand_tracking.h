#pragma once
// The hand's devices of a rig: a wand, which has a place, buttons and axes, and a SpaceMouse, which has no
// place and steers alone. A wand may be a sensor of the head's tracker.

#include <array>
#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/rig.h"
#include "app/sensor_place.h"
#include "app/tracker_report.h"
#include "devices/tracker.h"

namespace carom {

/// Buttons that are down (bit i: button i) and where axes stand.
struct Handles {
  std::uint32_t down = 0;
  std::array<double, 6> axes{};
};

/// What the devices of the hand had told at a frame's begin.
struct HandDevices {
  bool wandKnown = false;  ///< its place has come lately (SensorPlace::kLately_s)
  Pose roomFromHand;       ///< of the wand: its origin is the hand, the rig's forward is where it points
  Handles wand;
  Handles spaceMouse;  ///< axes: pushed right, up, back, and turned; each −1 to 1
};

/// How a tracker fares at session time `now_s`; `place`: of the sensor that is used, null where none is.
TrackerReport reportOf(const std::string& name, const char* use, const Tracker& tracker,
                       const SensorPlace* place, double now_s);

class HandTracking {
 public:
  /// The trackers themselves. `wand`: null where the head's tracker follows it, or where there is none.
  struct Trackers {
    std::unique_ptr<Tracker> wand, spaceMouse;
  };

  HandTracking(const Rig& rig, Trackers trackers);
  /// Opens them as the rig has them: the first SpaceMouse among its trackers steers.
  HandTracking(const Rig& rig, std::chrono::steady_clock::time_point sessionStart);

  /// Takes what has come up to a frame's begin. `samples`, `inputs`: of the head's tracker.
  void follow(double now_s, std::span<const TrackerSample> samples, std::span<const Reading> inputs);

  const HandDevices& devices() const { return devices_; }
  const SensorPlace* place() const {
    return place_ ? &*place_ : nullptr;
  }  ///< of the wand's sensor; null: no wand
  /// Adds how its trackers fare.
  void report(double now_s, const Tracker& headTracker, std::vector<TrackerReport>& reports) const;

 private:
  Trackers trackers_;
  std::string wandName_, spaceMouseName_;  ///< in the rig
  std::optional<SensorPlace> place_;
  Pose sensorFromHand_;
  int inputSensor_ = 0;  ///< under which the wand's buttons come
  HandDevices devices_;
  std::vector<TrackerSample> samples_;
  std::vector<Reading> inputs_;
};

}  // namespace carom
