#pragma once
// Creates the force devices that a rig describes.

#include <chrono>
#include <memory>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "devices/force/force_channel.h"
#include "devices/force/force_thread.h"
#include "devices/setup/force_setup.h"

namespace carom {

/// A kind of force device, registered: a new kind is a row of forceRows().
struct ForceRow {
  ForceKind kind;
  std::string_view name;  ///< in rig files
  bool needsSource;
  bool hasPose;        ///< it says where it is in the room, and can be the hand's tracker
  ForceLimits limits;  ///< of the kind, with the stiffest spring that it holds
  /// Opens the device.
  std::unique_ptr<ForceDevice> (*open)(const ForceSetup& setup, const ForceLimits& limits,
                                       const RoomAxes& axes, const std::stop_token& stop);
};
std::span<const ForceRow> forceRows();
const ForceRow& rowOf(ForceKind kind);
std::vector<std::string_view> forceNames();

/// Returns what the device of a setup can do: its force, and its stiffness, or the stiffest spring that is
/// passive on it if the setup asks for more.
ForceLimits limitsOf(const ForceSetup& setup);
/// Returns a warning if the setup asks for a stiffer spring than is passive; empty if not.
std::string loweredStiffness(const ForceSetup& setup);

/// Throws std::invalid_argument, which says the fault and the expectation, if the source names no device of
/// this kind.
void checkForceSource(const ForceSetup& setup);

/// Returns the name of a device for people: "force device evdev /dev/input/event7".
std::string nameOf(const ForceSetup& setup);

/// What a force device says that is opened for a moment and not pushed.
struct ForceTrial {
  bool works = false;
  std::string words;  ///< "at most 9 N, 600 N/m, 200 Hz; it is there and sends its place", or why it is not
};
ForceTrial tryForce(const ForceSetup& setup, const RoomAxes& axes);

/// Creates the channel to the device: a simulated one goes on with the session's clock, all others have a
/// thread each. A device that is not there is looked for, and the channel's news say so.
std::unique_ptr<ForceChannel> createForce(const ForceSetup& setup, const RoomAxes& axes,
                                          std::chrono::steady_clock::time_point sessionStart);

}  // namespace carom
