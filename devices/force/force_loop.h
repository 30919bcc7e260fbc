#pragma once
// One tick of the loop of a force device: from where the device is and from the law that the game has posted
// to the force. Pure: it knows no clock, no device and no thread, and allocates nothing.
//
//   law (cue, held puck, blows) → passivity → at most F_max, slew, falls → command

#include <optional>

#include "devices/force/force_guard.h"
#include "devices/force_law/force_law.h"
#include "devices/force_law/held_puck.h"
#include "devices/force_law/passivity.h"
#include "devices/force_law/shown_mass.h"

namespace carom {

class ForceLoop {
 public:
  explicit ForceLoop(const ForceLimits& limits) : limits_(limits), guard_(limits), passivity_(limits) {}

  /// Computes the force of a tick at `now_s`.
  ForceCommand tick(double now_s, const ForceDeviceState& device, const ForceLaw& law);

  /// The device is gone, or the session ends: 0 N at once. It is a fall if there was a force.
  void end(ForceFall why, double now_s);

  const ForceReport& report() const { return report_; }

 private:
  ForceCommand commandOf(const ForceDeviceState& device, const ForceLaw& law);
  glm::dvec3 cueForce(const glm::dvec3& place_m, const ForceLaw& law, ForceCommand& command);
  glm::dvec3 puckForce(const glm::dvec3& place_m, const glm::dvec3& moved_m, const ForceLaw& law);
  double storedBy(const ForceLaw& law) const;

  ForceLimits limits_;
  ForceGuard guard_;
  PortPassivity passivity_;
  ShownMass shown_;
  std::optional<glm::dvec3> anchor_m_;  ///< where the cue's draw began
  std::optional<HeldPuck> puck_;
  std::optional<glm::dvec3> place_m_;  ///< in the tick before
  glm::dvec3 moved_m_{0.0};
  double begun_s_ = 0.0;  ///< when the law began to hold
  ForceReport report_;
};

}  // namespace carom
