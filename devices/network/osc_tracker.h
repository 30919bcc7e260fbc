#pragma once
// A program that sends poses, buttons or axes by Open Sound Control.

#include <cstdint>
#include <string_view>

#include "devices/network/socket.h"
#include "devices/osc/osc_mapping.h"
#include "devices/tracker/device_tracker.h"

namespace carom {

struct OscSource {
  Ipv4 local;                   ///< where it is received; a group is joined
  std::uint32_t interface = 0;  ///< address of this machine's interface to the group; 0: as routed
  std::uint32_t from = 0;       ///< whose datagrams are taken; 0: anybody's
};

/// Reads "udp://0.0.0.0:9000", perhaps with ?from=192.168.1.20 and, of a group, &interface=192.168.1.5. The
/// port is 9000 unless given. Throws std::invalid_argument.
OscSource readOscSource(std::string_view text);

/// Returns the transport of that source. If datagrams come and none fits the mapping for 3 s, it says which
/// addresses come.
Transport oscTransport(const OscSource& source, const OscMapping& mapping);

}  // namespace carom
