#pragma once
// When frames begin and when their light leaves the walls.

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <span>

namespace carom {

/// Times of one frame on the session's clock (seconds since its start).
struct FrameTimes {
  std::uint64_t number = 0;
  double begin_s = 0.0;    ///< what is known of the head is known up to now
  double display_s = 0.0;  ///< when the photons leave the wall
  double step_s = 0.0;     ///< display time since the previous frame's: the person has lived so long
};

/// Time that a pacer reads and waits on.
class Clock {
 public:
  virtual ~Clock() = default;
  virtual double now_s() = 0;
  virtual void sleepUntil(double t_s) = 0;
};

/// The machine's steady clock, from 0 at its making or at a moment before.
class SteadyClock : public Clock {
 public:
  explicit SteadyClock(std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now());
  double now_s() override;
  void sleepUntil(double t_s) override;

 private:
  double start_s_;
};

/// Time that passes only when waited for: sessions of a given number of frames run as fast as they can and
/// give the same bits in every run.
class SimulatedClock : public Clock {
 public:
  double now_s() override { return now_s_; }
  void sleepUntil(double t_s) override { now_s_ = now_s_ < t_s ? t_s : now_s_; }

 private:
  double now_s_ = 0.0;
};

/// Says when frames begin and when they may be swapped. This one never waits: it is for frames that nobody waits for
/// and for nodes that follow the first.
class FramePacer {
 public:
  virtual ~FramePacer() = default;

  /// Waits until the next frame should begin.
  virtual FrameTimes next() { return {number_++, 0.0, 0.0, 0.0}; }
  /// The frame is drawn, on every node: waits until it may be swapped. `stay_s`: of a recorded session, how long after
  /// the frame before it was shown.
  virtual void awaitTick(double /*stay_s*/) {}
  /// It has been swapped.
  virtual void swapped() {}

 protected:
  std::uint64_t number_ = 0;
};

/// Shows each frame of a recorded session as long after the one before as it was then.
class RecordingPacer : public FramePacer {
 public:
  explicit RecordingPacer(Clock& clock) : clock_(clock), due_s_(clock.now_s()) {}

  FrameTimes next() override;
  void awaitTick(double stay_s) override;

 private:
  Clock& clock_;
  double due_s_;  // when the frame at hand should be on the walls
  double begin_s_ = 0.0;
};

/// Aims each frame at a swap: one of the display's ticks. A frame begins before its tick by as long as
/// drawing has lately taken, and a margin; if it would come too late all the same it is aimed at a later
/// tick.
///
/// A display whose swaps wait for it (vsync) shows its ticks; their phase and period are then followed, since
/// a "60 Hz" display may run at 59.94. Where swaps return at once the pacer's own ticks hold, and `awaitTick`
/// waits for them, so that frames follow each other evenly all the same.
///
///     for (;;) { times = pacer.next(); …draw…; pacer.awaitTick(0); …swap…; pacer.swapped(); }
class Pacer : public FramePacer {
 public:
  /// `displayLatency_s`: from the swap to the photons. `firstFrame`: the number of the first one; above 0,
  /// the one before it is taken to have been shown just now, so that the person lives on from there.
  /// `swapsWait`: whether swaps return at the display's ticks (swapsWaitFor tells).
  Pacer(Clock& clock, double display_hz, double displayLatency_s, bool swapsWait = false,
        std::uint64_t firstFrame = 0);

  FrameTimes next() override;
  /// Returns a moment before the frame's tick.
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
  double tick_s_;  // that the frame at hand is aimed at
  double begin_s_ = 0.0;
  bool begun_;
  std::array<double, kRemembered> drawing_s_;  // how long the last frames took
};

/// Whether swaps wait for a display of so many ticks a second, from the times at which a dozen of them
/// returned that had nothing to draw.
bool swapsWaitFor(double display_hz, std::span<const double> returned_s);

}  // namespace carom
