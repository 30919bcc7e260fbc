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
  std::optional<Ipv4> group;    ///< where it sends to many; none: it sends to us alone
  std::uint32_t interface = 0;  ///< of this machine, towards the server; 0: the one that leads there
};

/// Reads "udp://192.168.1.10" (the server sends to single clients) or
/// "udp://192.168.1.10?group=239.255.42.99" (to a group); the ports are 1510 and 1511 where none are given,
/// and &interface=192.168.1.5 may follow. Throws std::invalid_argument.
NatnetSource readNatnetSource(std::string_view text);

/// Asks the server what it is before anything else, and again while it is silent. Datagrams of others are
/// passed over.
Transport natnetTransport(const NatnetSource& source);

}  // namespace carom
