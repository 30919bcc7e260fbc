#pragma once
// HID devices through hidapi: what is plugged in, and one that is open.

#include <chrono>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

struct hid_device_;

namespace carom {

/// One that is plugged in, closed.
struct HidEntry {
  std::string node;  ///< "/dev/hidraw0"
  std::uint16_t vendor = 0;
  std::uint16_t product = 0;
  std::string name;    ///< as the device calls itself
  std::string serial;  ///< empty where it has none
  int usagePage = 0;   ///< what the device is for, in HID's words
  int usage = 0;
  bool usb = false;  ///< by cable; else by radio, or it is not known how
};

/// All that are plugged in.
std::vector<HidEntry> listHid();

/// One that is open. To be used on one thread.
class HidDevice {
 public:
  explicit HidDevice(const std::string& node);  ///< asks afterwards isOpen()

  bool isOpen() const { return device_ != nullptr; }

  /// The next report, its number first, into `report`: its size, 0 where none has come in time, −1 where the
  /// device is gone. One report at most; what does not fit is lost.
  int read(std::span<std::uint8_t> report, std::chrono::milliseconds wait);

  /// An output report, its number first. False where the device is gone or does not take it.
  bool write(std::span<const std::uint8_t> report);

  bool sendFeature(std::span<const std::uint8_t> report);

 private:
  struct Close {
    void operator()(hid_device_* device) const;
  };
  std::unique_ptr<hid_device_, Close> device_;
};

}  // namespace carom
