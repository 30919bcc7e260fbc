#pragma once
// Joysticks, wheels and gamepads that push or rumble, through the kernel's input events (evdev): a constant
// force on one or two axes, rumble, and the gain. Devices of the USB class for force (HID PID) come with it.
// Source: Linux, include/uapi/linux/input.h (struct ff_effect) and Documentation/input/ff.rst.

#include <memory>
#include <string>
#include <vector>

#include "devices/force/force_device.h"
#include "engine/base/pose.h"

namespace carom {

/// What a device can do.
struct EvdevForceFacts {
  std::string node;  ///< "/dev/input/event7"
  std::string name;
  bool constant = false, rumble = false, gain = false;
  int effects = 0;      ///< how many it holds
  int axes = 0;         ///< 1 or 2 that have a place
  std::string problem;  ///< why it cannot be used, and the remedy; empty if it can
  bool hasForce() const { return constant || rumble; }
  /// Returns what it can do, in words: "constant force on 2 axes, rumble, gain; 16 effects".
  std::string words() const;
};

/// Returns the devices that have force, and those that may not be asked, in the order of their nodes.
std::vector<EvdevForceFacts> listEvdevForces();

/// Opens the device at `node`, or without one the first that has force. Its stick is at full deflection
/// kStick_m from its middle, along the axes' right and back. Throws NeedsHelp where it has no force, may not
/// be opened, or is another session's, and std::runtime_error where it is not there.
inline constexpr double kStick_m = 0.15;
std::unique_ptr<ForceDevice> openEvdevForce(const std::string& node, double forceMax_n, const RoomAxes& axes);

}  // namespace carom
