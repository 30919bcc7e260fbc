#pragma once
// The address by which a rig names a tracker on a network: scheme://host:port?key=value&key=value

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>

#include "devices/network/socket.h"

namespace carom {

struct SourceUrl {
  Endpoint endpoint;
  std::map<std::string, std::string> options;

  /// Returns an option that must be an IPv4 address; 0 if it is absent. Throws std::invalid_argument.
  std::uint32_t address(const std::string& key) const;
  /// Returns its host and port as the address at which datagrams are received: one of this machine, 0.0.0.0
  /// for all of them, or a group. Throws std::invalid_argument.
  Ipv4 local() const;
};

/// Reads `text`. The port is `defaultPort` if the text gives none. Throws std::invalid_argument, which says
/// the fault and the expectation, such as `example`.
SourceUrl readSourceUrl(std::string_view text, std::string_view scheme, std::uint16_t defaultPort,
                        std::span<const std::string_view> optionKeys, std::string_view example);

/// Reads "host" or "host:port". Throws std::invalid_argument.
Endpoint readEndpoint(std::string_view text, std::uint16_t defaultPort);

}  // namespace carom
