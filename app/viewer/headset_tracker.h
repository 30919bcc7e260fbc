#pragma once
// A headset as a tracker: sensor 0 is the head, between the eyes; sensor 1 is the hand that aims, with its
// trigger, buttons and stick. All are predictions for the moment of the frame's display.

#include <optional>
#include <vector>

#include "cave/record/headset_frame.h"
#include "devices/tracker/tracker.h"

namespace carom {

class HeadsetTracker : public Tracker {
 public:
  /// Takes the headset's data of the frame that begins; none while it is not worn.
  void take(const std::optional<HeadsetFrame>& frame) { frame_ = frame.value_or(HeadsetFrame{}); }

  /// Appends the poses for the frame that begins at `now_s`, which is its display time.
  void poll(double now_s, std::vector<TrackerSample>& samples) override;
  void takeInputs(std::vector<Reading>& inputs) override;
  TrackerHealth health(double now_s) const override;

 private:
  HeadsetFrame frame_;
};

}  // namespace carom
