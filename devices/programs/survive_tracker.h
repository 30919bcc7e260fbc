#pragma once
// Lighthouse trackers without a headset, by libsurvive's program survive-cli.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "devices/network/socket.h"
#include "devices/tracker/device_tracker.h"

namespace carom {

/// Reads "tcp://host:port", where a program passes on the lines of survive-cli. Throws std::invalid_argument.
Endpoint readSurviveServer(std::string_view text);

/// Returns the transport that starts survive-cli of PATH, always with the same arguments, or, given a server,
/// reads its lines from there. survive_decoder.h says how names number the sensors. Device times are those of
/// the lines. A program that ends is started again 2 s later. If a name sends no pose for 5 s, the transport
/// says which devices do.
Transport surviveTransport(const std::optional<Endpoint>& server, const std::vector<std::string>& names);

}  // namespace carom
