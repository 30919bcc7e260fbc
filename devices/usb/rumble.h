#pragma once
// A gamepad that trembles in the hand: Sony's DualShock 4 and DualSense on a cable, through hidapi.

#include <cstdint>
#include <memory>
#include <vector>

#include "devices/usb/hid_device.h"

namespace carom {

/// The output report that sets both motors to a strength of 0 to 255, its number first; empty for any other
/// device. Source: Linux, drivers/hid/hid-playstation.c, dualshock4_output_report_usb and
/// dualsense_output_report_usb. (Of a DualSense whose newer firmware has a second way to rumble, this is the
/// first, which it still obeys.)
std::vector<std::uint8_t> rumbleReport(const HidEntry& pad, std::uint8_t strength);

/// The first such pad that is plugged in, whenever that is. It is looked for only while there is something to
/// feel, and written to on a thread of its own: no call here waits for it. The newest wish wins.
class Rumble {
 public:
  Rumble();
  ~Rumble();  ///< stops the motors
  Rumble(const Rumble&) = delete;
  Rumble& operator=(const Rumble&) = delete;

  void set(double strength);  ///< from now on, 0 to 1
  void pulse();               ///< once, as strong as it can, for kPulse_s

  static constexpr double kPulse_s = 0.08;

 private:
  struct Hand;
  std::unique_ptr<Hand> hand_;
};

}  // namespace carom
