#pragma once
// A headset as a tracker: sensor 0 is the head, between the eyes; sensor 1 is the hand that aims, with its trigger,
// buttons and stick. All are predictions for the moment of the frame's display.

#include <chrono>

#include "app/viewer/shared_trackers.h"
#include "cave/frame/headset_frame.h"
#include "devices/tracker/tracker.h"

namespace carom {

class HeadsetTracker : public Tracker {
 public:
  /// `frame` is that of the headset's newest frame, and must outlive this object.
  explicit HeadsetTracker(const HeadsetFrame& frame) : frame_(frame) {}

  /// Appends the poses for the frame that begins at `now_s`, which is its display time.
  void poll(double now_s, std::vector<TrackerSample>& samples) override;
  void takeInputs(std::vector<Reading>& inputs) override;
  TrackerHealth health(double now_s) const override;

 private:
  const HeadsetFrame& frame_;
};

/// Returns the trackers of a rig; with a headset's newest frame, of a headset that says so.
SharedTrackers trackersOf(const Rig& rig, std::chrono::steady_clock::time_point sessionStart,
                          const HeadsetFrame* headset);

}  // namespace carom
