#include "cave/pacer.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>

namespace carom {
namespace {

double steadySeconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

SteadyClock::SteadyClock() : start_s_(steadySeconds()) {}

double SteadyClock::now_s() { return steadySeconds() - start_s_; }

void SteadyClock::sleepUntil(double t_s) {
  const double wait_s = t_s - now_s();
  if (wait_s > 0.0) std::this_thread::sleep_for(std::chrono::duration<double>(wait_s));
}

Pacer::Pacer(Clock& clock, double display_hz, double displayLatency_s)
    : clock_(clock), period_s_(1.0 / display_hz), latency_s_(displayLatency_s) {}

FrameTimes Pacer::next() {
  const auto soonest = static_cast<std::uint64_t>(std::ceil(clock_.now_s() / period_s_ - 1e-9));
  const std::uint64_t previous = period_;
  period_ = number_ == 0 ? soonest : std::max(previous + 1, soonest);
  const double begin_s = static_cast<double>(period_) * period_s_;
  clock_.sleepUntil(begin_s);
  const double step_s = number_ == 0 ? 0.0 : static_cast<double>(period_ - previous) * period_s_;
  return {number_++, begin_s, begin_s + period_s_ + latency_s_, step_s};
}

}  // namespace carom
