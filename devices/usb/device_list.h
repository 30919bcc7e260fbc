#pragma once
// What is plugged in.

#include <string>
#include <vector>

namespace carom {

/// A device that Carom can use. (Joysticks are the window system's and not among them.)
struct ListedDevice {
  std::string name;     ///< "Polhemus LIBERTY"
  std::string kind;     ///< of a rig's [[tracker]]: "polhemus-usb", "hid-imu", "spacemouse"
  std::string source;   ///< what a rig's `source` has to say: "0f44:ff12"
  std::string serial;   ///< empty where it has none or may not be asked
  std::string place;    ///< "USB 1-3, /dev/bus/usb/001/003" or "/dev/hidraw0"
  std::string problem;  ///< empty: it can be used; else what is wrong and what to do
};

/// Devices on USB and HID, in order of place.
std::vector<ListedDevice> listDevices();

}  // namespace carom
