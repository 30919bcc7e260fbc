#pragma once
// When frames begin and when their light leaves the walls.

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "cave/record/headset_frame.h"

namespace carom {

/// Times of one frame on the session's clock (seconds since its start).
struct FrameTimes {
  std::uint64_t number = 0;
  double begin_s = 0.0;    ///< when the frame begins: newer samples of the head are not used
  double display_s = 0.0;  ///< when the photons leave the wall
  double step_s = 0.0;     ///< display time since the previous frame: the person has lived that long
  bool isLast = false;     ///< no more frames can be shown
  std::optional<HeadsetFrame> headset = {};  ///< that is worn, for the moment of display
};

/// A clock that a pacer reads and waits on.
class Clock {
 public:
  virtual ~Clock() = default;
  virtual double now_s() = 0;
  virtual void sleepUntil(double t_s) = 0;
};

/// The machine's steady clock. It reads 0 at `start`.
class SteadyClock : public Clock {
 public:
  explicit SteadyClock(std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now());
  double now_s() override;
  void sleepUntil(double t_s) override;

 private:
  double start_s_;
};

/// A clock that advances only when it is waited for: sessions of a given number of frames run as fast as they
/// can and give the same bits in every run.
class SimulatedClock : public Clock {
 public:
  double now_s() override { return now_s_; }
  void sleepUntil(double t_s) override { now_s_ = now_s_ < t_s ? t_s : now_s_; }

 private:
  double now_s_ = 0.0;
};

/// Says when frames begin and when they may be swapped. This base class never waits: it serves frames that
/// need no timing, and the nodes that follow the first.
class FramePacer {
 public:
  virtual ~FramePacer() = default;

  /// Waits until the next frame should begin, and returns its times.
  virtual FrameTimes next() { return {number_++, 0.0, 0.0, 0.0}; }
  /// Waits until the frame, which every node has drawn by now, may be swapped. `stay_s`: in a recorded
  /// session, the time from showing the previous frame to showing this one.
  virtual void awaitTick(double /*stay_s*/) {}
  /// Takes note that the frame has been swapped.
  virtual void swapped() {}

 protected:
  std::uint64_t number_ = 0;
};

/// Shows the frames of a recorded session at the intervals at which they were first shown.
class RecordingPacer : public FramePacer {
 public:
  explicit RecordingPacer(Clock& clock) : clock_(clock), due_s_(clock.now_s()) {}

  FrameTimes next() override;
  void awaitTick(double stay_s) override;

 private:
  Clock& clock_;
  double due_s_;  // when the current frame should be on the walls
  double begin_s_ = 0.0;
};

/// Aims each frame at a swap, which is one of the display's ticks. A frame begins before its tick by the time
/// that drawing has recently taken, plus a margin; if it would still be late, it is aimed at a later tick.
///
/// If swaps wait for the display (vsync), their returns show its ticks; the pacer then follows their phase
/// and period, since a "60 Hz" display may run at 59.94 Hz. If swaps return at once, the pacer keeps ticks of
/// its own and `awaitTick` waits for them, so that frames still follow each other evenly.
///
///     for (;;) { times = pacer.next(); …draw…; pacer.awaitTick(0); …swap…; pacer.swapped(); }
class Pacer : public FramePacer {
 public:
  /// `displayLatency_s`: from the swap to the photons. `firstFrame`: number of the first frame; if it is
  /// above 0, the frame before it counts as shown just now, so that the person's time continues from there.
  /// `swapsWait`: whether swaps return at the display's ticks (see swapsWaitFor).
  Pacer(Clock& clock, double display_hz, double displayLatency_s, bool swapsWait = false,
        std::uint64_t firstFrame = 0);

  FrameTimes next() override;
  /// Returns shortly before the frame's tick.
  void awaitTick(double stay_s) override;
  void swapped() override;

 private:
  static constexpr std::size_t kRemembered = 32;

  double usualDrawing_s() const;
  double longestDrawing_s() const;
  void follow(double tick_s);

  Clock& clock_;
  double latency_s_;
  double nominalPeriod_s_;
  double period_s_;
  bool swapsWait_;
  double tick_s_;  // the tick at which the current frame is aimed
  double begin_s_ = 0.0;
  bool begun_;
  std::array<double, kRemembered> drawing_s_;  // how long drawing the last frames took
};

/// Returns whether swaps wait for the ticks of a display of `display_hz`. `returned_s`: the times at which a
/// dozen swaps returned that had nothing to draw.
bool swapsWaitFor(double display_hz, std::span<const double> returned_s);

}  // namespace carom
