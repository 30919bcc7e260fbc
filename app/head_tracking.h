#pragma once
// From the rig's head sensor to the person's head in the room: tracker → place of the eyes → filter.

#include <chrono>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "app/rig.h"
#include "app/tracker_watch.h"
#include "cave/frame_state.h"
#include "cave/pacer.h"
#include "devices/head_filter.h"
#include "devices/tracker.h"
#include "engine/observer.h"

namespace carom {

/// The newest pose of one sensor in the room.
class SensorPlace {
 public:
  SensorPlace(int sensor, const Pose& roomFromTracker) : sensor_(sensor), roomFromTracker_(roomFromTracker) {}

  void see(double now_s, std::span<const TrackerSample> samples);
  const Pose& roomFromSensor() const { return roomFromSensor_; }
  /// Whether it has come within kLately_s.
  bool isKnown(double now_s) const { return told_s_ && now_s - *told_s_ <= kLately_s; }

  static constexpr double kLately_s = 0.3;  ///< after which the head, too, counts as lost (head_filter.h)

 private:
  int sensor_;
  Pose roomFromTracker_, roomFromSensor_;
  std::optional<double> told_s_;
};

class HeadTracking {
 public:
  /// `sessionStart`: where the session's clock reads zero. Throws InputError if a trace is at fault.
  HeadTracking(const Rig& rig, std::chrono::steady_clock::time_point sessionStart);

  /// Takes what the tracker has up to the frame's begin and predicts the head to its display. Where the
  /// tracker fails for long, or is well again, a line on standard error says so.
  HeadEstimate at(const FrameTimes& times);

  /// Where the sensors of head and hand were last, as the trackers had told at that frame's begin.
  Tracked tracked() const;

  /// What the tracker had for that frame, of all its sensors.
  std::span<const TrackerSample> samples() const { return samples_; }

 private:
  void followSensors(double now_s);

  HeadSetup setup_;
  Pose roomFromTracker_;
  double latency_s_;
  std::unique_ptr<Tracker> tracker_;
  TrackerWatch watch_;
  HeadFilter filter_;
  std::vector<TrackerSample> samples_;
  SensorPlace headPlace_;
  std::optional<SensorPlace> handPlace_;
  std::unique_ptr<Tracker> handTracker_;  // none where the head's follows the hand, too
  std::vector<TrackerSample> handSamples_;
  double begin_s_ = 0.0;  // of the frame
  Pose standing_;         // shown until the first sample
  std::optional<double> firstTracked_s_;  // display time of the first frame with a sample
};

}  // namespace carom
