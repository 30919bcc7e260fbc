#pragma once
// A force device behind a VRPN server, which runs the fast loop beside it: it gets the law's force and
// stiffness at its last place, and holds them until the next.

#include <memory>
#include <stop_token>

#include "devices/force/force_device.h"
#include "devices/network/vrpn_tracker.h"

namespace carom {

/// The field around the last place reaches so far; beyond, the server gives no force.
inline constexpr double kFieldRadius_m = 0.02;

/// Connects to the server. Throws NeedsHelp or std::runtime_error (devices/tracker/retry.h), also if
/// `stop` is requested first.
std::unique_ptr<ForceDevice> openVrpnForce(const VrpnSource& source, const std::stop_token& stop);

}  // namespace carom
