#pragma once
// How a rig names a USB or HID device: "vid:pid" or "vid:pid:serial".

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace carom {

struct UsbAddress {
  std::uint16_t vendor = 0;
  std::uint16_t product = 0;
  std::string serial;  ///< empty: any
};

/// Reads "0f44:ff12" or "2833:0001:ABC123" (ids of one to four hexadecimal digits); nothing where `text` is
/// neither.
std::optional<UsbAddress> parseUsbAddress(std::string_view text);

/// As parseUsbAddress reads it.
std::string toString(const UsbAddress& address);

}  // namespace carom
