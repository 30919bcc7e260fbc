#pragma once
// From the rig's head sensor to the person's head in the room: tracker → place of the eyes → filter.

#include <chrono>
#include <memory>
#include <span>
#include <vector>

#include "app/rig.h"
#include "app/tracker_watch.h"
#include "cave/pacer.h"
#include "devices/head_filter.h"
#include "devices/tracker.h"
#include "engine/observer.h"

namespace carom {

class HeadTracking {
 public:
  /// `sessionStart`: where the session's clock reads zero. Throws InputError if a trace is at fault.
  HeadTracking(const Rig& rig, std::chrono::steady_clock::time_point sessionStart);

  /// Takes what the tracker has up to the frame's begin and predicts the head to its display. Where the
  /// tracker fails for long, or is well again, a line on standard error says so.
  HeadEstimate at(const FrameTimes& times);

  /// What the tracker had for that frame, of all its sensors.
  std::span<const TrackerSample> samples() const { return samples_; }

 private:
  HeadSetup setup_;
  Pose roomFromTracker_;
  double latency_s_;
  std::unique_ptr<Tracker> tracker_;
  TrackerWatch watch_;
  HeadFilter filter_;
  std::vector<TrackerSample> samples_;
  Pose standing_;         // shown until the first sample
  bool tracked_ = false;  // there has been one
};

}  // namespace carom
