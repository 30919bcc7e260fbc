#pragma once
// When frames begin and when their light leaves the walls.

#include <cstdint>

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

/// The machine's steady clock, from 0 at its making.
class SteadyClock : public Clock {
 public:
  SteadyClock();
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

/// Frames begin at multiples of the display's period; a frame that came too late for its period takes the
/// next. Its light leaves the walls one period after it began, and `displayLatency_s` later still.
class Pacer {
 public:
  Pacer(Clock& clock, double display_hz, double displayLatency_s);
  FrameTimes next();

 private:
  Clock& clock_;
  double period_s_;
  double latency_s_;
  std::uint64_t number_ = 0;
  std::uint64_t period_ = 0;  // counts the display's periods since the session's start
};

}  // namespace carom
