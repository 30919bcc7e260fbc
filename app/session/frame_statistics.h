#pragma once
// How evenly frames follow each other, where their time goes and whether the nodes' swaps are locked:
// measured on every node, gathered on rank 0.

#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "app/session/frame_listener.h"
#include "cave/cluster/cluster.h"
#include "cave/cluster/frame_lock.h"
#include "cave/frame/frame_timing.h"
#include "cave/overlay/latency_overlay.h"

namespace carom {

class FrameStatistics : public FrameListener {
 public:
  /// `realTime`: rank 0 gathers what the nodes measure. Cluster and lock are used as long as this lives.
  FrameStatistics(Cluster& cluster, NodeLock& lock, double display_hz, bool realTime);

  void begin() { stopwatch_.begin(); }
  void mark(FramePart part) { stopwatch_.mark(part); }
  /// The frame has been decided. On ranks other than 0 nothing is known of it.
  void decided(const DecisionTiming& timing);

  /// What this node's overlay says; null where it is off. Its numbers are those of up to a quarter of a
  /// second ago, over the last five.
  const LatencyView* view(const FrameRecord& record);
  /// The same, whether it is on or not.
  const LatencyView& numbers(const FrameRecord& record);

  /// On rank 0 what the nodes said with the frame is taken, and locks that were lost or are back are said on standard
  /// error.
  void shown(const Decision& decision) override;

  /// On rank 0, of the last frame: once a second the statistics of each node and part, else nothing.
  std::span<const LatencyRow> rows() const { return rows_; }

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
  void summarize(const FrameRecord& record);

  Cluster& cluster_;
  NodeLock& lock_;
  double display_hz_;
  bool gathers_;
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
