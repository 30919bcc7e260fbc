#pragma once
// The rumble motors of a gamepad: Sony's DualShock 4 and DualSense on a cable, through hidapi.

#include <cstdint>
#include <memory>
#include <vector>

#include "devices/usb/hid_device.h"

namespace carom {

/// Returns the output report that sets both motors to a strength of 0 to 255 and begins with its number;
/// empty for any other device. Source: Linux, drivers/hid/hid-playstation.c, dualshock4_output_report_usb and
/// dualsense_output_report_usb. (A DualSense with newer firmware has a second way to rumble and still obeys
/// this first one.)
std::vector<std::uint8_t> rumbleReport(const HidEntry& pad, std::uint8_t strength);

/// The first such pad that is plugged in, at any time. The program looks for it only while there is something
/// to feel, and writes to it on a separate thread, so no call here waits for it. The newest request wins.
class Rumble {
 public:
  Rumble();
  ~Rumble();  ///< stops the motors
  Rumble(const Rumble&) = delete;
  Rumble& operator=(const Rumble&) = delete;

  void set(double strength);  ///< sets the strength from now on, 0 to 1
  void pulse();               ///< rumbles once, at full strength, for kPulse_s

  static constexpr double kPulse_s = 0.08;

 private:
  struct Hand;
  std::unique_ptr<Hand> hand_;
};

}  // namespace carom
