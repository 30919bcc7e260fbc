#pragma once
// The interface of every force device, whether it is real or simulated. It is used on one thread.

#include <memory>
#include <string>

#include "devices/force_law/cue_force.h"
#include "devices/force_law/force_law.h"

namespace carom {

class ForceDevice {
 public:
  ForceDevice() = default;
  ForceDevice(const ForceDevice&) = delete;
  ForceDevice& operator=(const ForceDevice&) = delete;
  virtual ~ForceDevice() = default;  ///< leaves the device at 0 N

  /// Returns its state at a tick. Throws std::runtime_error if it is gone.
  virtual ForceDeviceState read(double now_s) = 0;
  /// Tells it what to do until the next tick. Throws std::runtime_error if it is gone.
  virtual void write(const ForceCommand& command) = 0;
  /// 0 N, at once and whatever happens.
  virtual void zero() noexcept = 0;
  /// Takes over where the hand of a simulated device wants to be; real ones have a hand.
  virtual void wish(const glm::dvec3& /*place_m*/) {}
};

}  // namespace carom
