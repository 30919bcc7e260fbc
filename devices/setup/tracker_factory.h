#pragma once
// Creates the trackers that a rig describes.

#include <chrono>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "devices/setup/tracker_setup.h"
#include "devices/tracker/device_tracker.h"
#include "devices/tracker/tracker.h"

namespace carom {

/// Whether the kind is a device, whose samples arrive in real time and differ in every run.
bool isDevice(TrackerKind kind);

/// What the source of a kind is.
enum class SourceUse {
  none,
  trace,         ///< a file
  address,       ///< of a device
  maybeAddress,  ///< the same; the device is found without one, too
};

/// A kind of tracker, registered: a new kind is a row of trackerRows().
struct TrackerRow {
  TrackerKind kind;
  std::string_view name;  ///< in rig files
  bool isInRigs;          ///< a [[tracker]] may be of this kind
  SourceUse source;
  std::string_view
      ownKey;  ///< the key that a [[tracker]] has for this kind (and perhaps others); empty: none
  /// Returns the transport that listens to the device that the setup's source names. Throws
  /// std::invalid_argument, which says the fault and the expectation, if it names none of this kind. Null:
  /// the kind has no transport.
  Transport (*make)(const TrackerSetup& setup, const RoomAxes& axes);
};
/// Returns all kinds; those that a rig may name come first.
std::span<const TrackerRow> trackerRows();
std::vector<std::string_view> trackerNamesInRigs();
const TrackerRow& rowOf(TrackerKind kind);

/// Creates the tracker that a rig names. The session's clock reads zero at `sessionStart`. Throws InputError
/// if its trace is at fault. A device that is not there is looked for, and its health says so.
std::unique_ptr<Tracker> createTracker(const TrackerSetup& setup, const RoomAxes& axes,
                                       std::chrono::steady_clock::time_point sessionStart);

}  // namespace carom
