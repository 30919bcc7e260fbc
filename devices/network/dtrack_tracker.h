#pragma once
// An ART tracker (DTRACK2, DTRACK3), which sends datagrams to whom its controller was told to.

#include <cstdint>
#include <string_view>

#include "devices/network/socket.h"
#include "devices/tracker/device_tracker.h"

namespace carom {

struct DtrackSource {
  Ipv4 local;  ///< where datagrams come to: an address of this machine, 0 for any, or a group
  std::uint32_t interface = 0;  ///< by which a group is joined; 0: the one that leads there
  std::uint32_t from = 0;       ///< whose datagrams count; 0: anyone's
};

/// Reads "udp://0.0.0.0:5000" or "udp://224.0.1.0:5000", with ?from=192.168.1.20 and &interface=192.168.1.5
/// if need be. Throws std::invalid_argument.
DtrackSource readDtrackSource(std::string_view text);

/// Sensors are numbered as dtrack_decoder.h says.
Transport dtrackTransport(const DtrackSource& source);

}  // namespace carom
