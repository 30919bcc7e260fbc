#pragma once
// The hand's devices of a rig: a wand, which has a place, buttons and axes, and a SpaceMouse, which has no
// place and steers alone. A wand may be a sensor of the head's tracker, and its buttons may be those of
// another tracker: of whatever sensor there sends some, or, where several do, of the one numbered as the
// wand's own.

#include <array>
#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/files/rig.h"
#include "devices/monitor/sensor_place.h"
#include "devices/monitor/tracker_alarm.h"
#include "devices/monitor/tracker_report.h"
#include "devices/tracker/tracker.h"

namespace carom {

/// Buttons that are down (bit i: button i) and where axes stand.
struct ButtonState {
  std::uint32_t down = 0;
  std::array<double, 6> axes{};
};

/// What the devices of the hand had told at a frame's begin.
struct HandDevices {
  bool wandKnown = false;  ///< its place has come lately (kTrackLost_s)
  Pose roomFromHand;       ///< of the wand: its origin is the hand, the rig's forward is where it points
  ButtonState wand;
  ButtonState spaceMouse;  ///< axes: pushed right, up, back, and turned; each −1 to 1
};

/// How a tracker fares at session time `now_s`; `place`: of the sensor that is used, null where none is.
TrackerReport reportOf(const std::string& name, const char* use, const Tracker& tracker,
                       const SensorPlace* place, double now_s);

class HandTracking {
 public:
  /// The trackers themselves. `wand`: null where the head's tracker follows it, or where there is none;
  /// `buttons`: null where the wand's own tracker or the head's has them.
  struct Trackers {
    std::unique_ptr<Tracker> wand, spaceMouse, buttons;
  };

  HandTracking(const Rig& rig, Trackers trackers);
  /// Opens them as the rig has them: the first SpaceMouse among its trackers steers.
  HandTracking(const Rig& rig, std::chrono::steady_clock::time_point sessionStart);

  /// Takes what has come up to a frame's begin. `samples`, `inputs`: of the head's tracker.
  void follow(double now_s, std::span<const TrackerSample> samples, std::span<const Reading> inputs);

  /// Whether it is time to look at its trackers again: a few times a second.
  bool isDue(double now_s) const { return wandWatch_ && wandWatch_->isDue(now_s); }
  /// What the person should be told of them; of the head's tracker its own watch tells. Buttons of a tracker
  /// that is gone are let go.
  std::vector<std::string> look(double now_s, const Tracker& headTracker);

  const HandDevices& devices() const { return devices_; }
  const SensorPlace* place() const {
    return place_ ? &*place_ : nullptr;
  }  ///< of the wand's sensor; null: no wand
  /// Adds how its trackers fare.
  void report(double now_s, const Tracker& headTracker, std::vector<TrackerReport>& reports) const;

 private:
  void followWand(double now_s, std::span<const TrackerSample> samples, std::span<const Reading> inputs);
  void takeButtons(std::span<const Reading> inputs);
  bool isOfTheWand(int sensor);
  std::optional<std::string> tellOfButtons(double now_s, bool tracked);

  Trackers trackers_;
  std::string wandName_, spaceMouseName_, buttonsName_;  ///< in the rig
  std::optional<SensorPlace> place_;
  Pose sensorFromHand_;
  int sensor_ = 0;                    ///< of the wand
  bool otherButtons_ = false;         ///< they are another tracker's than its place
  std::optional<int> buttonsSensor_;  ///< under which they come; none: it has not shown yet
  HandDevices devices_;
  std::vector<TrackerSample> samples_;
  std::vector<Reading> inputs_;
  std::optional<TrackerAlarm> wandWatch_, buttonsWatch_;
  enum class Buttons { awaited, missed, came } buttons_ = Buttons::awaited;
  bool buttonsTold_ = true;               ///< of what `buttons_` is
  std::optional<double> trackedSince_s_;  ///< both trackers have delivered since then
};

}  // namespace carom
