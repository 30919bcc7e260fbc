#include "devices/force/force_guard.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace carom {
namespace {

constexpr double kWindow_s = 0.100;  // of the rate
constexpr double kRounding_s = 1e-9;

}  // namespace

const char* toString(ForceFall fall) {
  switch (fall) {
    case ForceFall::gameSilent:
      return "the game said nothing for 100 ms";
    case ForceFall::poseOld:
      return "no pose for 20 ms";
    case ForceFall::rateLow:
      return "the loop is too slow";
    case ForceFall::tickLate:
      return "no tick for 20 ms";
    case ForceFall::unplugged:
      return "the device is gone";
    case ForceFall::notFinite:
      return "the device sent no numbers";
    case ForceFall::ended:
      return "the session ended";
    case ForceFall::none:
      break;
  }
  return "";
}

void ForceGuard::measureRate(double now_s) {
  if (windowFrom_s_ < 0.0) windowFrom_s_ = now_s;
  ++ticks_;
  if (now_s - windowFrom_s_ < kWindow_s) return;
  rate_hz_ = (ticks_ - 1) / (now_s - windowFrom_s_);
  windowFrom_s_ = now_s;
  ticks_ = 1;
}

ForceFall ForceGuard::faultAt(double now_s, double posted_s, double pose_s) const {
  if (tick_s_ >= 0.0 && now_s - tick_s_ > std::max(kTickLate_s, 1.5 * limits_.period_s))
    return ForceFall::tickLate;
  if (!(now_s - posted_s <= kGameSilent_s + kRounding_s)) return ForceFall::gameSilent;
  if (!(now_s - pose_s <= kPoseOld_s + kRounding_s)) return ForceFall::poseOld;
  if (rate_hz_ > 0.0 && rate_hz_ < limits_.leastRate_hz) return ForceFall::rateLow;
  return ForceFall::none;
}

bool ForceGuard::look(double now_s, double posted_s, double pose_s, bool pressed) {
  const ForceFall fault = faultAt(now_s, posted_s, pose_s);
  measureRate(now_s);
  before_s_ = tick_s_;
  tick_s_ = now_s;
  if (!pressed) fallen_ = false;
  if (pressed && !fallen_ && fault != ForceFall::none) fall(fault, now_s);
  return pressed && !fallen_;
}

void ForceGuard::fall(ForceFall why, double now_s) {
  if (fallen_) return;
  fallen_ = true;
  ++falls_;
  why_ = why;
  fell_s_ = now_s;
  fellFrom_n_ = last_n_;
}

glm::dvec3 ForceGuard::allowed(const glm::dvec3& wished_n, double now_s, ForceReport::Limit& limit) {
  glm::dvec3 force_n = wished_n;
  if (fallen_) force_n = std::max(0.0, 1.0 - (now_s - fell_s_) / kFalls_s) * fellFrom_n_;
  const double size = glm::length(force_n);
  if (size > limits_.force_n) {
    force_n *= limits_.force_n / size;
    limit = ForceReport::Limit::force;
  }
  const double passed_s =
      before_s_ < 0.0 ? limits_.period_s : std::clamp(now_s - before_s_, 0.0, limits_.period_s);
  const double most_n = limits_.force_n * passed_s / kSlew_s;
  const glm::dvec3 change_n = force_n - last_n_;
  const double changes = glm::length(change_n);
  if (changes > most_n && !fallen_) {
    force_n = last_n_ + most_n / changes * change_n;
    limit = ForceReport::Limit::slew;
  }
  return last_n_ = force_n;
}

}  // namespace carom
