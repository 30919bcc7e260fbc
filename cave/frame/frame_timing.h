#pragma once
// Where the time of each frame goes, on each node: durations measured with that node's own clock. Clocks of
// different nodes are never compared.

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace carom {

/// The parts of a frame, in their order. Only rank 0 measures the first two.
enum class FramePart : std::size_t {
  sample,  ///< age of the newest sample of the head's sensor when the frame began
  decide,  ///< head, observer and game
  share,   ///< sending the record; on the other nodes mostly the wait for the frame to begin
  submit,  ///< emission solve and drawing, until all commands are with the graphics card
  draw,  ///< from then until the card has finished; measured only where a session waits for it, in real time
  wait,  ///< until every node has finished and, on rank 0, the display's tick has come
  swap,  ///< the swap itself
  late,  ///< interval between swaps minus the display's period; below 0 if the interval is shorter
};
inline constexpr std::array<const char*, 8> kFrameParts{"sample", "decide", "share", "submit",
                                                        "draw",   "wait",   "swap",  "late"};

/// One frame on one node. A part that was not measured is NaN.
struct FrameTiming {
  std::uint64_t frame = 0;
  std::array<float, kFrameParts.size()> parts_s{};

  float& operator[](FramePart part) { return parts_s[static_cast<std::size_t>(part)]; }
  float operator[](FramePart part) const { return parts_s[static_cast<std::size_t>(part)]; }
};

/// The state of the lock between a node's swaps and the other nodes' (cave/cluster/frame_lock.h).
enum class LockState : std::uint8_t {
  software,  ///< the nodes keep their swaps together by messages
  pending,   ///< the windows have joined the group; its counter has not been checked since
  joined,    ///< the windows have joined the group and its counter advances
  lost,      ///< a window has left the group or barrier, or the counter stands still
};
inline constexpr std::array<const char*, 4> kLockStates{"software", "swap group pending", "swap group joined",
                                                        "swap group LOST"};

/// A node's report to rank 0 on the previous frame, sent with each frame.
struct NodeReport {
  FrameTiming stamps;
  LockState lock = LockState::software;
  std::uint8_t measured = 0;  ///< 1: `stamps` holds a measured frame
};

/// Measures the parts of a frame as it goes on.
class FrameStopwatch {
 public:
  explicit FrameStopwatch(double display_hz) : period_s_(1.0 / display_hz) {}

  void begin();               ///< starts a frame without any measurement
  void mark(FramePart part);  ///< sets `part` to the time since `begin` or the last mark
  void set(FramePart part, double duration_s) { stamps_[part] = static_cast<float>(duration_s); }
  /// Ends the frame with this number, now that it is on the walls: marks `swap` and, from the second frame
  /// on, `late`.
  const FrameTiming& swapped(std::uint64_t frame);

 private:
  using Time = std::chrono::steady_clock::time_point;

  double period_s_;
  FrameTiming stamps_;
  Time marked_ = std::chrono::steady_clock::now();
  Time swapped_;
  bool begun_ = false;
};

struct PartStatistics {
  std::size_t frames = 0;  ///< frames that measured the part; if there are none, the other members are NaN
  float median_s = std::numeric_limits<float>::quiet_NaN();
  float p99_s = std::numeric_limits<float>::quiet_NaN();  ///< 99 of 100 are at most this (nearest rank)
  float most_s = std::numeric_limits<float>::quiet_NaN();
  float jitter_s = std::numeric_limits<float>::quiet_NaN();  ///< standard deviation
};

/// One part on one node over the last second.
struct LatencyRow {
  double display_s = 0.0;   ///< session clock: time of the frame that reported it
  std::uint64_t frame = 0;  ///< number of the newest frame that is counted
  int node = 0;
  FramePart part = FramePart::sample;
  PartStatistics statistics;
};

/// The timings of one node's last frames. Allocates memory only in its constructor.
class FrameHistory {
 public:
  /// `kept`: how many frames are kept, such as those of a few seconds.
  explicit FrameHistory(std::size_t kept);

  void add(const FrameTiming& stamps);
  std::size_t size() const { return std::min(added_, stamps_.size()); }
  const FrameTiming& newest() const { return stamps_[(added_ - 1) % stamps_.size()]; }

  /// Returns the statistics of `part` over the newest `last` of the kept frames.
  PartStatistics statistics(FramePart part, std::size_t last) const;

 private:
  std::vector<FrameTiming> stamps_;
  mutable std::vector<float> sorted_s_;
  std::size_t added_ = 0;
};

/// How evenly one node's frames followed each other over a whole session. Its size in memory is fixed.
class SessionLateness {
 public:
  explicit SessionLateness(double display_hz) : period_s_(1.0 / display_hz) {}

  void add(float late_s);
  std::uint64_t frames() const { return frames_; }  ///< intervals between frames
  std::uint64_t missed() const { return missed_; }  ///< ticks of the display without a new frame
  /// Returns the lateness that 99 of 100 intervals do not exceed, rounded up to a tenth of a millisecond; at
  /// least 0.
  double p99_s() const;

 private:
  static constexpr double kBin_s = 1e-4;
  static constexpr std::size_t kBins = 100000;  // the last bin, from 10 s on, has no upper end

  double period_s_;
  std::vector<std::uint64_t> bins_ = std::vector<std::uint64_t>(kBins);
  std::uint64_t frames_ = 0, missed_ = 0;
};

}  // namespace carom
