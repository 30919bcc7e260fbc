#pragma once
// A simulated force device that goes on with the session's clock, tick by tick, whenever a law is posted: the
// same session gives the same forces. It needs no thread.

#include "devices/force/force_channel.h"
#include "devices/force/force_loop.h"
#include "devices/force/simulated_force.h"

namespace carom {

class SteppedForce : public ForceChannel {
 public:
  explicit SteppedForce(const ForceLimits& limits) : limits_(limits), device_(limits), loop_(limits) {}

  /// Goes on to the time of the law, by at most a second.
  void post(const ForceLaw& law) override {
    constexpr double kMost_s = 1.0;
    device_.wish(law.wish_m);
    ForceLaw holds = law;
    if (!(law.posted_s - time_s_ < kMost_s)) time_s_ = law.posted_s - limits_.period_s;
    for (; time_s_ + limits_.period_s <= law.posted_s; time_s_ += limits_.period_s) {
      holds.posted_s = time_s_;
      device_.write(loop_.tick(time_s_, device_.read(time_s_), holds));
    }
  }
  const ForceReport& report() override { return loop_.report(); }
  double now_s(double given_s) const override { return given_s; }
  std::vector<std::string> takeNews() override { return {}; }
  void end() noexcept override {
    device_.zero();
    loop_.end(ForceFall::ended, time_s_);
  }

 private:
  ForceLimits limits_;
  SimulatedForce device_;
  ForceLoop loop_;
  double time_s_ = -1e9;
};

}  // namespace carom
