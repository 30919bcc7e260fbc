#pragma once
// trackd, the tracker daemon of CAVELib, by its shared memory.

#include <optional>
#include <string_view>

#include "devices/tracker/device_tracker.h"

namespace carom {

struct TrackdSource {
  int sensors = 0;            ///< key of the segment of sensors
  std::optional<int> wand{};  ///< key of the segment of a wand's buttons and axes
};

/// The sensor whose buttons and axes are those of the wand.
inline constexpr int kTrackdWand = 100;

/// Reads "shm://4126", perhaps with ?wand=4127. Throws std::invalid_argument.
TrackdSource readTrackdSource(std::string_view text);

/// Returns the transport of that source, whose lengths are in `unit_m`. It looks at the segment 3000 times a
/// second. A pose is taken when its time is new, or, from a daemon that gives sensors no time, when its
/// numbers are; and only if it stays the same for longer than the daemon's usual pause in the midst of a pose
/// (trackd_pause.h), since the daemon may be writing it. Device times are those of the sensor, or else of the
/// segment. The first contents of a segment may be old, and the first poses tell how the daemon writes: they
/// are not taken.
Transport trackdTransport(const TrackdSource& source, double unit_m);

}  // namespace carom
