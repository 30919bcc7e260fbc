#pragma once
// HID devices through hidapi: a list of those that are plugged in, and an open one.

#include <chrono>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

struct hid_device_;

namespace carom {

/// A device that is plugged in; not open.
struct HidEntry {
  std::string node;  ///< "/dev/hidraw0"
  std::uint16_t vendor = 0;
  std::uint16_t product = 0;
  std::string name;    ///< as the device calls itself
  std::string serial;  ///< empty if it has none
  int usagePage = 0;   ///< the purpose of the device, as HID numbers it
  int usage = 0;
  bool usb = false;  ///< connected by cable; false: by radio, or unknown
};

/// Returns all devices that are plugged in.
std::vector<HidEntry> listHid();

/// An open device. To be used on one thread.
class HidDevice {
 public:
  explicit HidDevice(const std::string& node);  ///< check isOpen() afterwards

  bool isOpen() const { return device_ != nullptr; }

  /// Reads the next report, which begins with its number, into `report`. Returns its size, 0 if none has come
  /// in time, −1 if the device is gone. Reads one report at most; what does not fit is lost.
  int read(std::span<std::uint8_t> report, std::chrono::milliseconds wait);

  /// Sends an output report, which begins with its number. Returns false if the device is gone or does not
  /// take it.
  bool write(std::span<const std::uint8_t> report);

  bool sendFeature(std::span<const std::uint8_t> report);

 private:
  struct Close {
    void operator()(hid_device_* device) const;
  };
  std::unique_ptr<hid_device_, Close> device_;
};

}  // namespace carom
