#pragma once
// An OptiTrack system that streams NatNet 3 or 4.

#include <cstdint>
#include <optional>
#include <string_view>

#include "devices/network/socket.h"
#include "devices/tracker/device_tracker.h"

namespace carom {

struct NatnetSource {
  Endpoint server;              ///< its command port
  std::optional<Ipv4> group;    ///< the group to which it sends; none: it sends to this program only
  std::uint32_t interface = 0;  ///< address of this machine's interface to the server; 0: as routed
};

/// Reads "udp://192.168.1.10" (the server sends to single clients) or
/// "udp://192.168.1.10?group=239.255.42.99" (to a group), perhaps with &interface=192.168.1.5. The ports are
/// 1510 and 1511 unless given. Throws std::invalid_argument.
NatnetSource readNatnetSource(std::string_view text);

/// Returns the transport of that source. It asks the server for its version first, and again while it is
/// silent, and ignores the datagrams of other senders.
Transport natnetTransport(const NatnetSource& source);

}  // namespace carom
