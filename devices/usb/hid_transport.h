#pragma once
// What all HID devices have in common: being looked for, opened, listened to, and found again.

#include <chrono>
#include <cstdint>
#include <span>
#include <stop_token>
#include <string>

#include "devices/tracker/device_tracker.h"
#include "devices/usb/hid_device.h"

namespace carom {

/// One kind of device.
class HidListener {
 public:
  using TimePoint = std::chrono::steady_clock::time_point;

  virtual ~HidListener() = default;
  virtual std::string name() const = 0;  ///< for people
  virtual bool wants(const HidEntry& entry) const = 0;
  virtual void connected(HidDevice& device) = 0;
  virtual void report(std::span<const std::uint8_t> report, TimePoint arrival, DeviceSink& sink) = 0;
  /// After every report, and every 10 ms without one.
  virtual void tick(HidDevice& device, TimePoint now, DeviceSink& sink) = 0;
  virtual void disconnected(TimePoint now, DeviceSink& sink) = 0;
};

/// Serves the first device that the listener wants, until asked to stop.
void listenToHid(const std::stop_token& stop, DeviceSink& sink, HidListener& listener);

}  // namespace carom
