#pragma once
// A tracker that plays a recording.

#include <cstddef>
#include <vector>

#include "devices/tracker/tracker.h"

namespace carom {

/// Delivers a trace's samples at their own spacing, the first of them at session time 0. At its end the
/// person stands where the recording left them: the last pose goes on at the trace's median spacing.
class RecordedTracker : public Tracker {
 public:
  /// `samples`: not empty, times strictly increasing (as readTrace gives them).
  explicit RecordedTracker(std::vector<TrackerSample> samples);

  void poll(double now_s, std::vector<TrackerSample>& samples) override;
  /// Always well; with the number of its samples so far.
  TrackerHealth health(double now_s) const override;

 private:
  TrackerSample at(std::size_t index) const;

  std::vector<TrackerSample> samples_;  // times from 0
  double spacing_s_;
  std::size_t next_ = 0;
};

}  // namespace carom
