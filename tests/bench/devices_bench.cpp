// What a tick of a force device's loop costs, and how evenly it ticks at 1 kHz: devices_bench [SECONDS].

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <thread>
#include <vector>

#include "counted_new.h"
#include "devices/force/force_loop.h"
#include "devices/force/force_thread.h"
#include "devices/force/simulated_force.h"

namespace {

using namespace carom;
using Clock = std::chrono::steady_clock;

ForceLaw lawOf(ForceLaw::Kind kind) {
  ForceLaw law;
  law.kind = kind;
  law.held = true;
  law.cue = {0.403, 0.08, 0.5};
  law.puck = {0.2, 1.42, {1.136, 0.0, 0.0}, 600.0, 0.0};
  return law;
}

void timeTick(const char* name, ForceLaw::Kind kind) {
  constexpr int kTicks = 200000;
  double least_s = 1e9;
  std::size_t allocations = 0;
  for (int run = 0; run < 5; ++run) {
    ForceLoop loop{ForceLimits{}};
    ForceLaw law = lawOf(kind);
    ForceDeviceState device;
    const std::size_t before = test::allocationCount();
    const Clock::time_point begun = Clock::now();
    for (int i = 0; i < kTicks; ++i) {
      const double now_s = i * 1e-3;
      law.posted_s = device.time_s = now_s;
      device.position_m.x = -0.004 * (i % 100) * 0.01;
      device.held_n = loop.tick(now_s, device, law).force_n;
    }
    least_s = std::min(least_s, std::chrono::duration<double>(Clock::now() - begun).count() / kTicks);
    allocations += test::allocationCount() - before;
  }
  std::printf("tick/%-6s %8.3f us, %zu allocations\n", name, 1e6 * least_s, allocations);
}

/// A device that keeps when it was asked.
class Noted : public SimulatedForce {
 public:
  Noted(const ForceLimits& limits, std::vector<Clock::time_point>& ticks)
      : SimulatedForce(limits), ticks_(ticks) {}
  ForceDeviceState read(double now_s) override {
    if (ticks_.size() < ticks_.capacity()) ticks_.push_back(Clock::now());
    return SimulatedForce::read(now_s);
  }

 private:
  std::vector<Clock::time_point>& ticks_;
};

void timeJitter(double seconds) {
  std::vector<Clock::time_point> ticks;
  ticks.reserve(static_cast<std::size_t>(seconds * 1100.0) + 1000);
  {
    const ForceLimits limits;
    ForceThread thread(
        "simulated", [&](const std::stop_token&) { return std::make_unique<Noted>(limits, ticks); }, limits,
        Clock::now());
    ForceLaw law = lawOf(ForceLaw::Kind::cue);
    const Clock::time_point end =
        Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
    while (Clock::now() < end) {  // the frames of a session
      law.posted_s = thread.now_s(0.0);
      thread.post(law);
      std::this_thread::sleep_for(std::chrono::milliseconds(16));
    }
  }
  std::vector<double> late_s;
  for (std::size_t i = 1; i < ticks.size(); ++i)
    late_s.push_back(std::abs(std::chrono::duration<double>(ticks[i] - ticks[i - 1]).count() - 1e-3));
  std::sort(late_s.begin(), late_s.end());
  const auto at = [&](double share) {
    return 1e3 * late_s[static_cast<std::size_t>(share * static_cast<double>(late_s.size() - 1))];
  };
  std::printf("jitter at 1 kHz, %zu ticks: median %.4f ms, 99 %% within %.4f ms, most %.3f ms\n",
              late_s.size(), at(0.5), at(0.99), at(1.0));
}

}  // namespace

int main(int argc, char** argv) {
  timeTick("cue", ForceLaw::Kind::cue);
  timeTick("puck", ForceLaw::Kind::heldPuck);
  timeJitter(argc > 1 ? std::atof(argv[1]) : 10.0);
}
