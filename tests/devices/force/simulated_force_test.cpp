// The simulated device in its hand: the balance of forces, the delay, the encoder and the energy.
#include "devices/force/simulated_force.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <glm/geometric.hpp>

namespace carom {
namespace {

constexpr double kHand_n_m = 250.0;

/// Holds a force for that long.
void hold(SimulatedForce& device, const ForceLimits& limits, const glm::dvec3& force_n, double& now_s,
          double for_s) {
  ForceCommand command;
  command.force_n = force_n;
  const double until_s = now_s + for_s;
  for (; now_s < until_s; now_s += limits.period_s) {
    device.read(now_s);
    device.write(command);
  }
}

// At rest the hand holds against the motors: F = 250 N/m (x − wish).
TEST(SimulatedForce, ComesToRestWhereTheHandHoldsTheForce) {
  const ForceLimits limits;
  SimulatedForce device(limits);
  const glm::dvec3 wish_m(0.01, -0.02, 0.03), force_n(2.0, -1.0, 0.5);
  device.wish(wish_m);
  EXPECT_EQ(device.place_m(), wish_m) << "it begins there";
  double now_s = 0.0;
  hold(device, limits, force_n, now_s, 6.0);
  EXPECT_LT(glm::length(device.velocity_m_s()), 1e-6);
  EXPECT_LT(glm::distance(device.place_m(), wish_m + force_n / kHand_n_m), 1e-6);
  // What the encoder says is a whole number of its steps, and the nearest.
  const ForceDeviceState state = device.read(now_s);
  for (int axis = 0; axis < 3; ++axis) {
    const double steps = state.position_m[axis] / limits.count_m;
    EXPECT_NEAR(steps, std::round(steps), 1e-6);
    EXPECT_LE(std::abs(state.position_m[axis] - device.place_m()[axis]), 0.5 * limits.count_m + 1e-12);
  }
}

TEST(SimulatedForce, AForceIsAtItsMotorsAfterTheDelay) {
  for (std::size_t delay = 0; delay <= SimulatedForce::kMostDelay; ++delay) {
    SimulatedForce device(ForceLimits{}, delay);
    for (int tick = 0; tick < 20; ++tick) {
      const ForceDeviceState state = device.read(1e-3 * tick);
      EXPECT_EQ(state.held_n.x, std::max(0, tick - static_cast<int>(delay))) << delay << ", " << tick;
      ForceCommand command;
      command.force_n.x = tick + 1;
      device.write(command);
    }
    device.zero();
    EXPECT_EQ(device.read(1.0).held_n, glm::dvec3(0.0)) << delay;
  }
}

// From rest to rest the hand's work is that against the motor, and what the device's damping takes: its share
// of all damping, 0.3 of 6.3 N s/m, of what the hand's spring lost, which is k/2 way².
TEST(SimulatedForce, TheHandsWorkIsInTheMotorsOrLost) {
  const ForceLimits limits;
  SimulatedForce device(limits);
  const glm::dvec3 force_n(3.0, 0.0, 0.0);
  device.wish(glm::dvec3(0.0));
  double now_s = 0.0;
  hold(device, limits, force_n, now_s, 6.0);
  const double before_j = device.port_j(), from_m = device.place_m().x;
  device.wish(glm::dvec3(-0.1, 0.0, 0.0));
  hold(device, limits, force_n, now_s, 6.0);
  const double way_m = device.place_m().x - from_m;
  EXPECT_NEAR(way_m, -0.1, 1e-6);
  const double lost_j = limits.damping_ns_m / (limits.damping_ns_m + 6.0) * 0.5 * kHand_n_m * way_m * way_m;
  EXPECT_NEAR(device.port_j() - before_j, -force_n.x * way_m + lost_j, 1e-3);
}

}  // namespace
}  // namespace carom
