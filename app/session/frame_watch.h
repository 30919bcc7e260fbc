#pragma once
// How evenly frames follow each other, where their time goes and whether the nodes' swaps are locked:
// measured on every node, gathered on rank 0.

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "app/session/frame_source.h"
#include "cave/cluster/cluster.h"
#include "cave/cluster/frame_lock.h"
#include "cave/frame/frame_timing.h"
#include "cave/overlay/latency_overlay.h"

namespace carom {

class FrameWatch {
 public:
  FrameWatch(Cluster& cluster, NodeLock& lock, double display_hz);

  void begin() { stopwatch_.begin(); }
  void mark(FramePart part) { stopwatch_.mark(part); }
  /// On rank 0: the frame has been decided.
  void decided(const Deciding& deciding);

  /// What this node's overlay says; null where it is off. Its numbers are those of up to a quarter of a
  /// second ago, over the last five.
  const LatencyView* view(const FrameRecord& record);
  /// The same, whether it is on or not.
  const LatencyView& numbers(const FrameRecord& record);

  /// The frame is on the walls. On rank 0: what the nodes said with it is taken, locks that were lost or are
  /// back are said on standard error, and once a second `source` is given the statistics of each node and
  /// part.
  void swapped(const FrameRecord& record, FrameSource* source);

  /// On rank 0, a line for each node on standard error: frames, ticks of the display without a new one, and
  /// the 99th percentile of lateness.
  void sayHowItWent() const;

 private:
  struct NodeFrames {
    std::string name;
    FrameHistory frames;
    SessionLateness lateness;
    LockState lock = LockState::software;
  };
  void gather();
  void tell(const FrameRecord& record, FrameSource& source);

  Cluster& cluster_;
  NodeLock& lock_;
  double display_hz_;
  std::size_t window_;  // in frames
  FrameStopwatch stopwatch_;
  FrameHistory own_;
  std::vector<NodeFrames> nodes_;  // rank 0's
  std::vector<LatencyRow> rows_;
  std::size_t untold_ = 0;  // frames
  double told_s_ = 0.0;     // session clock
  LatencyView view_;
  std::size_t sinceViewed_ = std::numeric_limits<std::size_t>::max() / 2;  // frames: it never was
};

}  // namespace carom
