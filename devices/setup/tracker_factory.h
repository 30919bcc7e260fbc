#pragma once
// From what a rig says of a tracker to the tracker itself.

#include <chrono>
#include <memory>
#include <string>

#include "devices/setup/tracker_setup.h"
#include "devices/tracker/device_tracker.h"
#include "devices/tracker/tracker.h"

namespace carom {

/// Whether it is a device: its samples come in real time, and no two runs are alike.
bool isDevice(TrackerKind kind);

/// How the device of that source is listened to. Throws std::invalid_argument, saying what is wrong and what
/// was expected, where the source names none of this kind.
Transport createTransport(TrackerKind kind, const std::string& source, const RoomAxes& axes);

/// The tracker that a rig names. `sessionStart` is where the session's clock reads zero. Throws InputError if
/// its trace is at fault; a device that is not there is looked for, and its health says so.
std::unique_ptr<Tracker> createTracker(const TrackerSetup& setup, const RoomAxes& axes,
                                       std::chrono::steady_clock::time_point sessionStart);

}  // namespace carom
