#include "devices/force/simulated_force.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace carom {
namespace {

constexpr double kStep_s = 5e-5;  // 20 kHz
constexpr double kDevice_kg = 0.12, kMass_kg = kDevice_kg + 0.6, kHandDamping_ns_m = 6.0,
                 kHandStiffness_n_m = 250.0;

}  // namespace

SimulatedForce::SimulatedForce(const ForceLimits& limits, std::size_t delay)
    : limits_(limits), delay_(std::min(delay, kMostDelay)) {}

void SimulatedForce::wish(const glm::dvec3& place_m) {
  wish_m_ = place_m;
  if (steps_ == 0) place_m_ = place_m;
}

/// Semi-implicit Euler.
void SimulatedForce::step(const glm::dvec3& force_n) {
  const glm::dvec3 all_n = force_n - (limits_.damping_ns_m + kHandDamping_ns_m) * velocity_m_s_ -
                           kHandStiffness_n_m * (place_m_ - wish_m_);
  velocity_m_s_ += kStep_s / kMass_kg * all_n;
  const glm::dvec3 moved_m = kStep_s * velocity_m_s_;
  motors_j_ -= glm::dot(force_n, moved_m);
  lost_j_ += limits_.damping_ns_m * glm::dot(velocity_m_s_, moved_m);
  place_m_ += moved_m;
}

double SimulatedForce::port_j() const {
  return motors_j_ + lost_j_ + 0.5 * kDevice_kg * glm::dot(velocity_m_s_, velocity_m_s_);
}

ForceDeviceState SimulatedForce::read(double now_s) {
  if (!begun_) from_s_ = now_s;
  begun_ = true;
  const glm::dvec3 held_n = pipeline_[delay_];
  constexpr std::int64_t kMost = 4000;  // a clock that jumps is not made up for
  const auto until = static_cast<std::int64_t>(std::llround((now_s - from_s_) / kStep_s));
  steps_ = std::max(steps_, until - kMost);
  for (; steps_ < until; ++steps_) step(held_n);
  ForceDeviceState state;
  state.position_m = limits_.count_m * glm::round(place_m_ / limits_.count_m);
  state.time_s = now_s;
  state.pressed = pressed_;
  state.held_n = held_n;
  return state;
}

void SimulatedForce::write(const ForceCommand& command) {
  std::copy_backward(pipeline_.begin(), pipeline_.end() - 1, pipeline_.end());
  pipeline_[0] = command.force_n;
}

}  // namespace carom
