#pragma once
// An ART tracker (DTRACK2, DTRACK3), which sends datagrams to the addresses that its controller is set to.

#include <cstdint>
#include <optional>
#include <string_view>

#include "devices/network/socket.h"
#include "devices/tracker/device_tracker.h"

namespace carom {

struct DtrackSource {
  Ipv4 local;                   ///< where datagrams arrive: an address of this machine, 0 for any, or a group
  std::uint32_t interface = 0;  ///< address of the interface that joins the group; 0: as routed
  std::uint32_t from = 0;       ///< the sender whose datagrams are accepted; 0: any sender
  std::optional<Endpoint> controller{};  ///< its command port
  bool start = false;                    ///< the controller shall measure while the transport runs
};

/// Reads "udp://0.0.0.0:5000" or "udp://224.0.1.0:5000", with ?from=192.168.1.20 and &interface=192.168.1.5
/// if need be, and &controller=10.0.0.7 for its command port, which is 50105 unless given. Throws
/// std::invalid_argument.
DtrackSource readDtrackSource(std::string_view text);

/// Returns the transport of that source. dtrack_decoder.h says how sensors are numbered. With `start`, it
/// starts the measurement and stops it at the end, if it did not run before. While the controller cannot be
/// reached or refuses, the transport says why, listens all the same, and tries again every 5 s as long as
/// nothing comes.
Transport dtrackTransport(const DtrackSource& source);

}  // namespace carom
