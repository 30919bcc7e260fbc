#pragma once
// The tracked hand devices of a viewer: a wand with a pose, buttons and axes, and a SpaceMouse, which has no
// pose and only steers. The wand may be a sensor of the head's tracker. Its buttons may come from another
// tracker: from whichever sensor there sends some or, if several do, from the one with the wand's sensor
// number.

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/rig/rig.h"
#include "app/viewer/button_changes.h"
#include "app/viewer/shared_trackers.h"
#include "devices/monitor/sensor_place.h"
#include "devices/monitor/tracker_alarm.h"
#include "devices/monitor/tracker_report.h"
#include "devices/tracker/tracker.h"

namespace carom {

/// The state of the hand devices at the start of a frame.
struct HandDevices {
  bool wandKnown = false;  ///< its pose is recent (kHandLost_s)
  Pose roomFromHand;       ///< wand pose: its origin is the hand, and it points along the rig's forward axis
  ButtonState wand;
  ButtonState spaceMouse;  ///< axes: pushed right, up, back, and turned; each −1 to 1
};

/// Returns the state of a tracker at session time `now_s`. `place` is that of the sensor in use, or null if
/// none is.
TrackerReport reportOf(const std::string& name, const char* use, const Tracker& tracker,
                       const SensorPlace* place, double now_s);

class HandTracking {
 public:
  /// The trackers. `wand` is null if the head's tracker follows the wand, or if there is no wand; `buttons`
  /// is null if the wand's own tracker or the head's sends them.
  struct Trackers {
    std::unique_ptr<Tracker> wand, spaceMouse, buttons;
  };

  HandTracking(const Rig& rig, const ViewerSetup& viewer, Trackers trackers);
  /// Follows the trackers of one of the rig's viewers. The first SpaceMouse among them steers, for the first
  /// viewer.
  HandTracking(const Rig& rig, const ViewerSetup& viewer, SharedTrackers& trackers);

  /// Takes everything received up to the start of a frame. `samples` and `inputs` are those of the head's
  /// tracker.
  void follow(double now_s, std::span<const TrackerSample> samples, std::span<const Reading> inputs);

  /// Returns whether the trackers should be checked again, which is a few times per second.
  bool isDue(double now_s) const { return wandWatch_ && wandWatch_->isDue(now_s); }
  /// Checks the trackers and returns the messages for the operator, except those about the head's tracker,
  /// which HeadTracking reports. Releases the buttons of a tracker that has failed.
  std::vector<std::string> look(double now_s, const Tracker& headTracker);

  const HandDevices& devices() const { return devices_; }
  const SensorPlace* place() const {
    return place_ ? &*place_ : nullptr;
  }  ///< of the wand's sensor; null without a wand
  /// Appends the state of its trackers to `reports`.
  void report(double now_s, const Tracker& headTracker, std::vector<TrackerReport>& reports) const;

 private:
  void followWand(double now_s, std::span<const TrackerSample> samples, std::span<const Reading> inputs);
  void takeButtons(std::span<const Reading> inputs);
  bool isOfTheWand(int sensor);
  void releaseWand();
  std::optional<std::string> tellOfButtons(double now_s, bool tracked);

  Trackers trackers_;
  std::string wandName_, spaceMouseName_;  ///< as named in the rig
  std::optional<SensorPlace> place_;
  Pose sensorFromHand_;
  int sensor_ = 0;  ///< sensor number of the wand
  HandDevices devices_;
  ButtonChanges wandChanges_, mouseChanges_;
  std::vector<TrackerSample> samples_;
  std::vector<Reading> inputs_;
  std::optional<TrackerAlarm> wandWatch_;
  /// Where the buttons come from, and whether they have.
  struct Buttons {
    enum class State { awaited, missed, came };
    std::string name;           ///< of their tracker, as in the rig
    bool isOther = false;       ///< another tracker than that of the pose
    std::optional<int> sensor;  ///< number that sends them; empty until one has
    std::optional<TrackerAlarm> watch;
    State state = State::awaited;
    bool isTold = true;  ///< the state has been reported
  } buttons_;
  std::optional<double> trackedSince_s_;  ///< when both trackers began to deliver
};

}  // namespace carom
