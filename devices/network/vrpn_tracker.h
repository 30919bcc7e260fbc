#pragma once
// A tracker behind a VRPN server, reached by TCP.

#include <string>
#include <string_view>

#include "devices/network/socket.h"
#include "devices/tracker/device_tracker.h"

namespace carom {

/// The device `sender` of a server.
struct VrpnSource {
  std::string sender;
  Endpoint server;
};

/// Reads "Head@tcp://host:3883"; the port may be left out. Throws std::invalid_argument.
VrpnSource readVrpnSource(std::string_view text);

/// Keeps a connection to the server. Device times are the server's clock; a connection on which nothing comes
/// for 5 s, not even the answers to our pings, is given up and made anew. A sender that the server does not
/// have, or that answers no ping for 3 s, is remarked on, with the senders that there are, and waited for.
Transport vrpnTransport(const VrpnSource& source);

}  // namespace carom
