#pragma once
// Lists the devices that are plugged in.

#include <string>
#include <vector>

namespace carom {

/// A device that Carom can use. (Joysticks belong to the window system and are not listed.)
struct ListedDevice {
  std::string name;     ///< "Polhemus LIBERTY"
  std::string kind;     ///< of a rig's [[tracker]]: "polhemus-usb", "hid-imu", "spacemouse"
  std::string source;   ///< the `source` for a rig: "0f44:ff12"
  std::string serial;   ///< empty if it has none or cannot be asked
  std::string place;    ///< "USB 1-3, /dev/bus/usb/001/003" or "/dev/hidraw0"
  std::string problem;  ///< the fault and its remedy; empty if it can be used
};

/// Returns the devices on USB and HID, in order of place.
std::vector<ListedDevice> listDevices();

}  // namespace carom
