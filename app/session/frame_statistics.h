#pragma once
// Measures on every node how evenly frames follow each other, how their time is spent and whether the nodes'
// buffer swaps are locked. Rank 0 gathers the results.

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
  /// Measures this node's frames. With `realTime`, rank 0 gathers what all nodes measure. `cluster` and
  /// `lock` must outlive this object.
  FrameStatistics(Cluster& cluster, NodeLock& lock, double display_hz, bool realTime);

  void begin() { stopwatch_.begin(); }
  void mark(FramePart part) { stopwatch_.mark(part); }
  /// Records the decision's timing. On ranks other than 0 its values are NaN.
  void decided(const DecisionTiming& timing);

  /// Returns the content of this node's latency overlay, or null if the overlay is off. The numbers cover the
  /// last five seconds and are updated every quarter of a second.
  const LatencyView* view(const FrameRecord& record);
  /// Returns the same content whether the overlay is on or not.
  const LatencyView& numbers(const FrameRecord& record);

  /// On rank 0, takes the measurements that the nodes sent with the frame, and logs to standard error when a
  /// swap lock is lost or regained.
  void shown(const Decision& decision) override;

  /// On rank 0, returns the statistics of each node and part once a second, with the last frame; otherwise
  /// empty.
  std::span<const LatencyRow> rows() const { return rows_; }

  /// On rank 0, prints a line for each node to standard error: number of frames, display refreshes without a
  /// new frame, and the 99th percentile of lateness.
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
  std::vector<NodeFrames> nodes_;  // on rank 0
  std::vector<LatencyRow> rows_;
  std::size_t untold_ = 0;  // frames
  double told_s_ = 0.0;     // session clock
  LatencyView view_;
  std::size_t sinceViewed_ = std::numeric_limits<std::size_t>::max() / 2;  // frames; initially as if never
};

}  // namespace carom
