#pragma once
// The description of a force device in a rig file.

#include <optional>
#include <string>

#include "engine/base/pose.h"

namespace carom {

enum class ForceKind { simulated, evdev, vrpn };

struct ForceSetup {
  ForceKind kind = ForceKind::simulated;
  std::string source;                        ///< evdev: a node, or empty; vrpn: Arm@tcp://host
  double forceMax_n = 9.0;                   ///< what the device can do
  std::optional<double> stiffnessMax_n_m{};  ///< without it, that which the kind holds
  double d0_m = 0.08;                        ///< draw of one unit of rapidity
  Pose roomFromDevice;
};

}  // namespace carom
