#pragma once
// From the rig's head sensor to the person's head in the room: tracker → place of the eyes → filter.

#include <memory>
#include <vector>

#include "app/rig.h"
#include "cave/pacer.h"
#include "devices/head_filter.h"
#include "devices/tracker.h"
#include "engine/observer.h"

namespace carom {

/// The tracker that a rig names. Throws InputError if its trace is at fault.
std::unique_ptr<Tracker> openTracker(const TrackerSetup& setup, const RoomAxes& axes);

class HeadTracking {
 public:
  explicit HeadTracking(const Rig& rig);

  /// Takes what the tracker has up to the frame's begin and predicts the head to its display.
  HeadEstimate at(const FrameTimes& times);

 private:
  HeadSetup setup_;
  Pose roomFromTracker_;
  double latency_s_;
  std::unique_ptr<Tracker> tracker_;
  HeadFilter filter_;
  std::vector<TrackerSample> samples_;
  Pose standing_;         // shown until the first sample
  bool tracked_ = false;  // there has been one
};

}  // namespace carom
