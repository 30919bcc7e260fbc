#pragma once
// A tracker behind a VRPN server, reached by TCP.

#include <string>
#include <string_view>

#include "devices/network/socket.h"
#include "devices/tracker/device_tracker.h"

namespace carom {

/// A device of a VRPN server, which calls it `sender`.
struct VrpnSource {
  std::string sender;
  Endpoint server;
};

/// Reads "Head@tcp://host:3883"; the port may be left out. Throws std::invalid_argument.
VrpnSource readVrpnSource(std::string_view text);

/// Returns the transport of that source, which keeps a connection to the server. Device times are the
/// server's clock. A connection on which nothing arrives for 5 s, not even the answers to pings, is closed
/// and made anew. If the server does not have the sender, or the sender answers no ping for 3 s, the
/// transport says so, names the senders that there are, and waits.
Transport vrpnTransport(const VrpnSource& source);

}  // namespace carom
