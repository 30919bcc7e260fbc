#pragma once
// A simulated force device in a simulated hand, the same on each of three axes:
//
//   (0.12 + 0.6 kg) x'' = F - (0.3 + 6 N s/m) x' - 250 N/m (x - wish)
//
// The device has an encoder with steps of 20 um and a delay of some ticks before a force is at its motors;
// the hand pulls towards where it wants to be. It is integrated at 20 kHz, in a fixed order: the same wishes
// and forces give the same bits.

#include <array>
#include <cstdint>

#include "devices/force/force_device.h"

namespace carom {

class SimulatedForce : public ForceDevice {
 public:
  static constexpr std::size_t kMostDelay = 8;

  /// `delay`: ticks between a command and the motors, up to kMostDelay.
  explicit SimulatedForce(const ForceLimits& limits, std::size_t delay = 1);

  /// Moves on to `now_s` with the forces that have been commanded.
  ForceDeviceState read(double now_s) override;
  void write(const ForceCommand& command) override;
  void zero() noexcept override { pipeline_.fill(glm::dvec3(0.0)); }
  void wish(const glm::dvec3& place_m) override;
  /// Presses or releases its button.
  void press(bool isDown) { pressed_ = isDown; }

  /// Returns the energy that the hand has put into the device through its handle: the integral of its force
  /// over the way. It is in the motors, -integral of F dx, in the device's motion, or lost to its damping.
  double port_j() const;
  const glm::dvec3& place_m() const { return place_m_; }  ///< true, not counted by the encoder
  const glm::dvec3& velocity_m_s() const { return velocity_m_s_; }

 private:
  void step(const glm::dvec3& force_n);

  ForceLimits limits_;
  std::size_t delay_;
  std::array<glm::dvec3, kMostDelay + 1> pipeline_{};
  glm::dvec3 place_m_{0.0}, velocity_m_s_{0.0}, wish_m_{0.0};
  bool begun_ = false, pressed_ = false;
  std::int64_t steps_ = 0;
  double from_s_ = 0.0, motors_j_ = 0.0, lost_j_ = 0.0;
};

}  // namespace carom
