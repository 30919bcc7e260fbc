#pragma once
// The loop that all HID devices share: it looks for a device, opens it, listens to it, and finds it again.

#include <chrono>
#include <cstdint>
#include <span>
#include <stop_token>
#include <string>

#include "devices/tracker/device_tracker.h"
#include "devices/usb/hid_device.h"

namespace carom {

/// Handles one kind of device.
class HidListener {
 public:
  using TimePoint = std::chrono::steady_clock::time_point;

  virtual ~HidListener() = default;
  virtual std::string name() const = 0;  ///< for people
  virtual bool wants(const HidEntry& entry) const = 0;
  virtual void connected(HidDevice& device) = 0;
  virtual void report(std::span<const std::uint8_t> report, TimePoint arrival, DeviceSink& sink) = 0;
  /// Is called after every report, and every 10 ms without one.
  virtual void tick(HidDevice& device, TimePoint now, DeviceSink& sink) = 0;
  virtual void disconnected(TimePoint now, DeviceSink& sink) = 0;
};

/// Serves the first device that the listener wants, until a stop is requested.
void listenToHid(const std::stop_token& stop, DeviceSink& sink, HidListener& listener);

}  // namespace carom
