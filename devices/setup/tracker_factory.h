#pragma once
// Creates the trackers that a rig describes.

#include <chrono>
#include <memory>
#include <string>

#include "devices/setup/tracker_setup.h"
#include "devices/tracker/device_tracker.h"
#include "devices/tracker/tracker.h"

namespace carom {

/// Whether the kind is a device, whose samples arrive in real time and differ in every run.
bool isDevice(TrackerKind kind);

/// Returns the transport that listens to the device with that source. Throws std::invalid_argument, which
/// says the fault and the expectation, if the source does not name a device of this kind.
Transport createTransport(TrackerKind kind, const std::string& source, const RoomAxes& axes);

/// Creates the tracker that a rig names. The session's clock reads zero at `sessionStart`. Throws InputError
/// if its trace is at fault. A device that is not there is looked for, and its health says so.
std::unique_ptr<Tracker> createTracker(const TrackerSetup& setup, const RoomAxes& axes,
                                       std::chrono::steady_clock::time_point sessionStart);

}  // namespace carom
