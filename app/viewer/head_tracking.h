#pragma once
// From the rig's head sensor to the person's head in the room: tracker → place of the eyes → filter.

#include <chrono>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "app/files/rig.h"
#include "app/viewer/hand_tracking.h"
#include "cave/frame/frame_state.h"
#include "cave/frame/pacer.h"
#include "devices/filter/head_filter.h"
#include "devices/monitor/sensor_place.h"
#include "devices/monitor/tracker_alarm.h"
#include "devices/monitor/tracker_report.h"
#include "devices/tracker/tracker.h"
#include "engine/spacetime/observer.h"

namespace carom {

class HeadTracking {
 public:
  /// `sessionStart`: where the session's clock reads zero. Throws InputError if a trace is at fault.
  HeadTracking(const Rig& rig, std::chrono::steady_clock::time_point sessionStart);

  /// Takes what the trackers have up to the frame's begin and predicts the head to its display.
  HeadEstimate at(const FrameTimes& times);

  /// Returns what there is to say since it was asked last: that the tracker of head or hand fails for long, or is well
  /// again.
  std::vector<std::string> takeAlarms() { return std::exchange(alarms_, {}); }

  /// Where the sensors of head and hand were last, as the trackers had told at that frame's begin.
  Tracked tracked() const;

  /// Buttons, axes and place of the hand, as the trackers had told at that frame's begin.
  const HandDevices& hand() const { return hand_.devices(); }

  /// How the trackers fare; of the head, how `head` is known. For displays: it allocates.
  std::vector<TrackerReport> reports(const HeadEstimate& head) const;

  /// What the tracker had for that frame, of all its sensors.
  std::span<const TrackerSample> samples() const { return samples_; }

 private:
  HeadSetup setup_;
  Pose roomFromTracker_;
  double latency_s_;
  std::unique_ptr<Tracker> tracker_;
  TrackerAlarm watch_;
  HeadFilter filter_;
  std::vector<TrackerSample> samples_;
  SensorPlace headPlace_;
  std::vector<Reading> inputs_;
  HandTracking hand_;
  std::vector<std::string> alarms_;
  std::string name_;      // of the head's tracker, in the rig
  double begin_s_ = 0.0;  // of the frame
  Pose standing_;         // shown until the first sample
};

}  // namespace carom
