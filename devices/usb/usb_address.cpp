#include "devices/usb/usb_address.h"

#include <charconv>
#include <cstdio>

namespace carom {
namespace {

std::optional<std::uint16_t> parseId(std::string_view text) {
  std::uint16_t id = 0;
  const char* const end = text.data() + text.size();
  const auto [stopped, error] = std::from_chars(text.data(), end, id, 16);
  if (text.empty() || text.size() > 4 || error != std::errc{} || stopped != end) return std::nullopt;
  return id;
}

}  // namespace

std::optional<UsbAddress> parseUsbAddress(std::string_view text) {
  const std::size_t first = text.find(':');
  if (first == std::string_view::npos) return std::nullopt;
  const std::size_t second = text.find(':', first + 1);
  const auto vendor = parseId(text.substr(0, first));
  const auto product = parseId(text.substr(first + 1, second - first - 1));
  if (!vendor || !product) return std::nullopt;
  if (second == std::string_view::npos) return UsbAddress{*vendor, *product, {}};
  const std::string_view serial = text.substr(second + 1);
  if (serial.empty()) return std::nullopt;
  return UsbAddress{*vendor, *product, std::string(serial)};
}

std::string toString(const UsbAddress& address) {
  char ids[16];
  std::snprintf(ids, sizeof ids, "%04x:%04x", unsigned{address.vendor}, unsigned{address.product});
  return address.serial.empty() ? ids : std::string(ids) + ':' + address.serial;
}

}  // namespace carom
