#pragma once
// Tracks a viewer's head in the room: tracker → pose of the eyes → filter.

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "app/rig/rig.h"
#include "app/viewer/hand_tracking.h"
#include "app/viewer/headset_tracker.h"
#include "app/viewer/shared_trackers.h"
#include "cave/frame/pacer.h"
#include "cave/record/frame_state.h"
#include "devices/filter/head_filter.h"
#include "devices/monitor/sensor_place.h"
#include "devices/monitor/tracker_alarm.h"
#include "devices/monitor/tracker_report.h"
#include "devices/tracker/tracker.h"
#include "engine/spacetime/observer.h"

namespace carom {

class HeadTracking {
 public:
  /// Follows the trackers of one of the rig's viewers. Throws InputError if a recorded trace is invalid.
  HeadTracking(const Rig& rig, const ViewerSetup& viewer, SharedTrackers& trackers);

  /// Takes all samples up to the start of the frame and returns the head predicted for its display time. A
  /// headset gives the head, with the times, as predicted already: its pose stays as it is, from which it
  /// shifts the picture as the head goes on moving, and the celerity alone is filtered, anew where no time
  /// passes.
  HeadEstimate at(const FrameTimes& times);

  /// Returns and clears the messages since the last call: that the tracker of head or hand has failed for
  /// long, or works again.
  std::vector<std::string> takeAlarms() { return std::exchange(alarms_, {}); }

  /// Returns the latest poses of the head and hand sensors at the start of that frame.
  Tracked tracked() const;

  /// Returns buttons, axes and pose of the hand devices at the start of that frame.
  const HandDevices& hand() const { return hand_.devices(); }

  /// Returns the state of all trackers; that of the head's tracker includes how `head` is known. Allocates,
  /// so only for displays.
  std::vector<TrackerReport> reports(const HeadEstimate& head) const;

  /// Returns the samples of all sensors of the head's tracker for that frame.
  std::span<const TrackerSample> samples() const { return polled_.samples; }

 private:
  HeadSetup setup_;
  Pose roomFromTracker_;
  double latency_s_;
  std::unique_ptr<Tracker> tracker_;
  HeadsetTracker* headset_;  // the same, if it is one; else null
  TrackerAlarm watch_;
  HeadFilter filter_;
  std::optional<Pose> given_;  // of a headset: the head as it last told it
  SensorPlace headPlace_;
  // What the last poll delivered.
  struct Polled {
    std::vector<TrackerSample> samples;
    std::vector<Reading> inputs;
  };
  Polled polled_;
  HandTracking hand_;
  std::vector<std::string> alarms_;
  std::string name_;      // name of the head's tracker in the rig
  double begin_s_ = 0.0;  // start of the frame
  Pose standing_;         // head pose until the first sample
};

}  // namespace carom
