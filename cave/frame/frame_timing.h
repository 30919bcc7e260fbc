#pragma once
// Where the time of each frame goes, on each node: durations by that node's own clock. No clocks are
// compared.

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace carom {

/// In the order of a frame. The first two are of rank 0 alone.
enum class FramePart : std::size_t {
  sample,  ///< age of the newest sample of the head's sensor when the frame began
  decide,  ///< head, observer and game
  share,   ///< the record on its way; on other nodes than the first, mostly the wait for the frame to begin
  submit,  ///< solve and drawing, handed to the graphics card
  draw,    ///< from there until the card is done; only where a session waits for it, in real time
  wait,    ///< until every node is done and, on rank 0, the display's tick has come
  swap,    ///< the swap itself
  late,  ///< of the interval between swaps, what is beyond the display's period; below 0 where it is shorter
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

/// What holds a node's swaps together with the others' (cave/cluster/frame_lock.h).
enum class LockState : std::uint8_t {
  software,  ///< the nodes' swaps are held together by their messages
  pending,   ///< the windows have joined; the counter has not been looked at since
  joined,    ///< and the counter goes on
  lost,      ///< a window has left the group or barrier, or the counter stands still
};
inline constexpr std::array<const char*, 4> kLockStates{"software", "swap group pending", "swap group joined",
                                                        "swap group LOST"};

/// What a node tells rank 0 of the frame before, with each frame.
struct NodeReport {
  FrameTiming stamps;
  LockState lock = LockState::software;
  std::uint8_t measured = 0;  ///< 1: the stamps are of a frame
};

/// Takes a frame's stamps as it goes.
class FrameStopwatch {
 public:
  explicit FrameStopwatch(double display_hz) : period_s_(1.0 / display_hz) {}

  void begin();               ///< nothing is measured yet
  void mark(FramePart part);  ///< it took from the last mark, or the last frame's, until now
  void set(FramePart part, double duration_s) { stamps_[part] = static_cast<float>(duration_s); }
  /// The frame of this number is on the walls: marks `swap`, and from the second frame on `late`.
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
  std::size_t frames = 0;  ///< that measured it; the rest is NaN if none did
  float median_s = std::numeric_limits<float>::quiet_NaN();
  float p99_s = std::numeric_limits<float>::quiet_NaN();  ///< 99 of 100 are at most this (nearest rank)
  float most_s = std::numeric_limits<float>::quiet_NaN();
  float jitter_s = std::numeric_limits<float>::quiet_NaN();  ///< standard deviation
};

/// One part on one node over the last second.
struct LatencyRow {
  double display_s = 0.0;   ///< session clock, of the frame at which it was told
  std::uint64_t frame = 0;  ///< the newest that is counted
  int node = 0;
  FramePart part = FramePart::sample;
  PartStatistics statistics;
};

/// The last frames of one node. Allocates only when made.
class FrameHistory {
 public:
  /// `kept`: how many frames, such as those of a few seconds.
  explicit FrameHistory(std::size_t kept);

  void add(const FrameTiming& stamps);
  std::size_t size() const { return std::min(added_, stamps_.size()); }
  const FrameTiming& newest() const { return stamps_[(added_ - 1) % stamps_.size()]; }

  /// Over the newest `last` of those that are kept.
  PartStatistics statistics(FramePart part, std::size_t last) const;

 private:
  std::vector<FrameTiming> stamps_;
  mutable std::vector<float> sorted_s_;
  std::size_t added_ = 0;
};

/// How evenly one node's frames followed each other over a whole session. Of fixed size.
class SessionLateness {
 public:
  explicit SessionLateness(double display_hz) : period_s_(1.0 / display_hz) {}

  void add(float late_s);
  std::uint64_t frames() const { return frames_; }  ///< intervals
  std::uint64_t missed() const { return missed_; }  ///< ticks of the display at which no new frame came
  /// So late were 99 of 100 intervals at most, to a tenth of a millisecond upwards; 0 or more.
  double p99_s() const;

 private:
  static constexpr double kBin_s = 1e-4;
  static constexpr std::size_t kBins = 100000;  // the last, of 10 s, holds all that is later

  double period_s_;
  std::vector<std::uint64_t> bins_ = std::vector<std::uint64_t>(kBins);
  std::uint64_t frames_ = 0, missed_ = 0;
};

}  // namespace carom
