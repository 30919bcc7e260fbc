#pragma once
// How long the graphics card works on a piece of a frame, told some frames later, so that the frame does not
// wait for it (OpenGL's timer queries, ARB_timer_query).

#include <array>
#include <cstddef>
#include <vector>

namespace carom {

/// Create, use and destroy it with the drawing context current. Where the driver has no timer queries it
/// measures nothing. It makes what it needs when it first begins; afterwards it allocates nothing.
class GpuTimer {
 public:
  GpuTimer() = default;
  ~GpuTimer();
  GpuTimer(GpuTimer&& other) noexcept;
  GpuTimer& operator=(GpuTimer&&) = delete;

  /// Begins and ends the piece of this frame. Only one timer may have begun at a time.
  void begin();
  void end();

  /// Returns the median of the newest pieces that are known, in seconds; NaN if none is.
  float median_s() const;

 private:
  static constexpr std::size_t kOnTheWay = 6;  // frames until the card's answer is overwritten
  static constexpr std::size_t kKept = 31;
  void take();

  std::vector<unsigned> queries_;  // in turn
  std::size_t begun_ = 0, answered_ = 0;
  bool runs_ = false;
  std::array<float, kKept> durations_s_{};
  std::size_t measured_ = 0;
};

}  // namespace carom
