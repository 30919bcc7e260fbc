#pragma once
// The address by which a rig names a USB or HID device: "vid:pid" or "vid:pid:serial".

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

/// Reads "0f44:ff12" or "2833:0001:ABC123" (ids of one to four hexadecimal digits); returns nothing if `text`
/// is neither.
std::optional<UsbAddress> parseUsbAddress(std::string_view text);

/// Returns the text that parseUsbAddress reads.
std::string toString(const UsbAddress& address);

}  // namespace carom
