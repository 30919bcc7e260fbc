#pragma once
// A Qualisys Track Manager (QTM) that streams the poses of bodies.

#include <string>
#include <string_view>
#include <vector>

#include "devices/network/socket.h"
#include "devices/tracker/device_tracker.h"

namespace carom {

/// Reads "tcp://host:22223"; the port, that of the little-endian form of QTM's protocol, may be left out.
/// Throws std::invalid_argument.
Endpoint readQtmServer(std::string_view text);

/// Returns the transport of that server, which keeps a connection to it. The body names[i] is sensor i;
/// without names, QTM's body i is. Device times are those of QTM's frames. It tells the names of QTM's
/// bodies, and says so if a name is none of them. While no frames come it asks for them every 2 s; a
/// connection on which nothing arrives for 6 s is closed and made anew.
Transport qtmTransport(const Endpoint& server, const std::vector<std::string>& names);

}  // namespace carom
