#pragma once
// A tracker that plays a recording.

#include <cstddef>
#include <vector>

#include "devices/tracker/tracker.h"

namespace carom {

/// Delivers a trace's samples at their own spacing, the first of them at session time 0. After the end of the
/// trace the person stands where it ended: the last pose repeats at the trace's median spacing.
class RecordedTracker : public Tracker {
 public:
  /// `samples` must not be empty and their times must strictly increase (as readTrace returns them).
  explicit RecordedTracker(std::vector<TrackerSample> samples);

  void poll(double now_s, std::vector<TrackerSample>& samples) override;
  /// Always delivering, with the number of samples so far.
  TrackerHealth health(double now_s) const override;

 private:
  TrackerSample at(std::size_t index) const;

  std::vector<TrackerSample> samples_;  // times from 0
  double spacing_s_;
  std::size_t next_ = 0;
};

}  // namespace carom
