#include "app/link/link_address.h"

#include <charconv>
#include <stdexcept>

#include <fmt/format.h>

namespace carom {
namespace {

constexpr std::string_view kListen = "listen:";

[[noreturn]] void refuse(std::string_view text) {
  throw std::invalid_argument(
      fmt::format("'{}' is wrong, expected listen:PORT, listen:ADDRESS:PORT, HOST or HOST:PORT, with IPv6 "
                  "addresses in brackets, such as [2001:db8::1]:7314",
                  text));
}

}  // namespace

std::string LinkAddress::text() const {
  const std::string name = host.find(':') == std::string::npos ? host : "[" + host + "]";
  if (!listens) return fmt::format("{}:{}", name, port);
  return host.empty() ? fmt::format("{}{}", kListen, port) : fmt::format("{}{}:{}", kListen, name, port);
}

LinkAddress linkAddressOf(std::string_view text) {
  LinkAddress address;
  std::string_view rest = text;
  address.listens = rest.starts_with(kListen);
  if (address.listens) rest.remove_prefix(kListen.size());
  std::string_view port;
  if (rest.starts_with('[')) {
    const std::size_t end = rest.find(']');
    if (end == std::string_view::npos || end == 1) refuse(text);
    address.host = rest.substr(1, end - 1);
    port = rest.substr(end + 1);
    if (!port.empty() && !port.starts_with(':')) refuse(text);
    if (!port.empty()) port.remove_prefix(1);
    if (port.empty() && rest.ends_with(':')) refuse(text);
  } else {
    const std::size_t colon = rest.find(':');
    if (colon != rest.rfind(':')) refuse(text);  // an IPv6 address without brackets
    const bool isPortAlone = address.listens && colon == std::string_view::npos;
    if (!isPortAlone) address.host = rest.substr(0, colon);
    if (!isPortAlone && address.host.empty()) refuse(text);
    if (isPortAlone) port = rest;
    if (colon != std::string_view::npos) port = rest.substr(colon + 1);
    if (colon != std::string_view::npos && port.empty()) refuse(text);
  }
  if (port.empty() && address.listens) refuse(text);
  if (port.empty()) return address;
  const auto [end, error] = std::from_chars(port.data(), port.data() + port.size(), address.port);
  if (error != std::errc() || end != port.data() + port.size() || address.port == 0) refuse(text);
  return address;
}

}  // namespace carom
