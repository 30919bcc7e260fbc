#include "cave/frame/pacer.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>

namespace carom {
namespace {

constexpr double kMargin_s = 0.0015;    // added to the longest recent drawing time when a frame is scheduled
constexpr double kSwapAhead_s = 0.001;  // a swap that waits is requested this long before its tick
constexpr double kPhaseGain = 0.1, kPeriodGain = 0.005;  // of the control loop: settles within some 30 frames
constexpr double kOffNominal = 0.01;  // greatest relative difference of a display's period from the rig's
constexpr double kSamePeriod = 0.05;  // swaps this near to the display's period (relative) wait for it

double steadySeconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

SteadyClock::SteadyClock(std::chrono::steady_clock::time_point start)
    : start_s_(std::chrono::duration<double>(start.time_since_epoch()).count()) {}

double SteadyClock::now_s() { return steadySeconds() - start_s_; }

void SteadyClock::sleepUntil(double t_s) {
  const double wait_s = t_s - now_s();
  if (wait_s > 0.0) std::this_thread::sleep_for(std::chrono::duration<double>(wait_s));
}

FrameTimes RecordingPacer::next() {
  begin_s_ = clock_.now_s();
  return {number_++, begin_s_, begin_s_, 0.0};
}

/// A late frame is shown at once; the frames after it follow the schedule again.
void RecordingPacer::awaitTick(double stay_s) {
  due_s_ = std::max(due_s_ + stay_s, begin_s_);
  clock_.sleepUntil(due_s_);
}

Pacer::Pacer(Clock& clock, double display_hz, double displayLatency_s, bool swapsWait,
             std::uint64_t firstFrame)
    : clock_(clock),
      latency_s_(displayLatency_s),
      nominalPeriod_s_(1.0 / display_hz),
      period_s_(nominalPeriod_s_),
      swapsWait_(swapsWait),
      tick_s_(clock.now_s()),
      begun_(firstFrame > 0) {
  number_ = firstFrame;
  drawing_s_.fill(period_s_ / 2);  // until drawing has been measured
}

FrameTimes Pacer::next() {
  const double previous_s = tick_s_;
  const double now_s = clock_.now_s();
  const double ticks = std::ceil((now_s + usualDrawing_s() - tick_s_) / period_s_);
  tick_s_ += std::max(ticks, 1.0) * period_s_;
  begin_s_ = std::max(now_s, tick_s_ - longestDrawing_s() - kMargin_s);
  clock_.sleepUntil(begin_s_);
  const double step_s = begun_ ? tick_s_ - previous_s : 0.0;
  begun_ = true;
  return {number_++, begin_s_, tick_s_ + latency_s_, step_s};
}

void Pacer::awaitTick(double) {
  drawing_s_[number_ % kRemembered] = clock_.now_s() - begin_s_;
  clock_.sleepUntil(tick_s_ - (swapsWait_ ? kSwapAhead_s : 0.0));
}

void Pacer::swapped() {
  if (swapsWait_) follow(clock_.now_s());
}

/// Corrects phase and period by a second-order loop, given the time of the display's latest tick.
void Pacer::follow(double tick_s) {
  const double off_s =
      std::remainder(tick_s - tick_s_, period_s_);  // from the nearest tick: a tick may have been missed
  tick_s_ += kPhaseGain * off_s;
  const double nominal_s = nominalPeriod_s_;
  period_s_ = std::clamp(period_s_ + kPeriodGain * off_s, nominal_s * (1 - kOffNominal),
                         nominal_s * (1 + kOffNominal));
}

double Pacer::usualDrawing_s() const {
  auto sorted_s = drawing_s_;
  std::nth_element(sorted_s.begin(), sorted_s.begin() + kRemembered / 2, sorted_s.end());
  return sorted_s[kRemembered / 2];
}

double Pacer::longestDrawing_s() const { return *std::max_element(drawing_s_.begin(), drawing_s_.end()); }

bool swapsWaitFor(double display_hz, std::span<const double> returned_s) {
  if (returned_s.size() < 3) return false;
  const std::span<const double> settled_s = returned_s.subspan(returned_s.size() / 3);  // with full queues
  const double interval_s =
      (settled_s.back() - settled_s.front()) / static_cast<double>(settled_s.size() - 1);
  return std::abs(interval_s * display_hz - 1.0) < kSamePeriod;
}

}  // namespace carom
