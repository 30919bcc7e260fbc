#pragma once
// The interface of every tracker, whether it is a device, a recording or a simulated person: poses of its
// sensors with the times at which they held, buttons and axes, and its health.

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "devices/tracker/reading.h"
#include "engine/base/pose.h"

namespace carom {

/// One pose of one sensor.
struct TrackerSample {
  double time_s = 0.0;          ///< when the pose held, on the session's clock (a known latency taken off)
  int sensor = 0;               ///< counts from 0
  Pose pose;                    ///< trackerFromSensor, metres; identity orientation where none is measured
  bool hasOrientation = false;  ///< whether the tracker measures orientation
  double quality = std::numeric_limits<double>::quiet_NaN();  ///< 0 … 1 if the tracker reports it
};

/// Samples of one of several trackers.
struct TrackerSamples {
  std::size_t tracker = 0;  ///< index of the rig's trackers
  std::span<const TrackerSample> samples;
};

/// The health of a tracker, for display.
struct TrackerHealth {
  enum class State {
    connecting,  ///< nothing has arrived yet, or the device is being looked for again
    untouched,   ///< connected to a device that sends only while it is used: nothing was pressed yet
    delivering,  ///< samples, buttons or axes arrive
    silent,      ///< connected, but they are overdue
    failed,      ///< it cannot work without help: `message` says which
  };
  State state = State::connecting;
  std::string message;           ///< one line, empty while all is well
  bool connected = false;        ///< while `connecting`: there is a connection, but nothing has arrived yet
  std::string names;             ///< what the device calls its sensors, in words; empty if it says nothing
  std::uint64_t samples = 0;     ///< delivered
  std::uint64_t gaps = 0;        ///< samples that the device numbered and that never arrived
  std::uint64_t late = 0;        ///< arrived after a later one (dropped), or after over 50 ms (counted)
  std::uint64_t refused = 0;     ///< packets that could not be read
  std::uint64_t overflowed = 0;  ///< readings lost because they were not polled
  std::uint64_t reconnections = 0;
};

/// Returns the name for people: "connecting", "no presses yet", "delivering", "silent" or "failed".
const char* toString(TrackerHealth::State state);

/// A source of samples. A tracker that waits for a device does so on a thread of its own and keeps what
/// arrives in a queue: polling never blocks. The session's clock is given with each poll, so that a
/// recorded or simulated tracker can run in simulated time and deliver the same bits in every run.
class Tracker {
 public:
  Tracker() = default;
  Tracker(const Tracker&) = delete;
  Tracker& operator=(const Tracker&) = delete;
  virtual ~Tracker() = default;

  /// Appends the samples delivered since the last poll with time_s <= now_s (the session's clock, which never
  /// runs back), in order of time for each sensor. Does not allocate once `samples` has room.
  virtual void poll(double now_s, std::vector<TrackerSample>& samples) = 0;

  /// Appends the buttons, axes, losses and battery levels that came with the last poll's samples, their
  /// `device_s` on the session's clock.
  virtual void takeInputs(std::vector<Reading>& /*inputs*/) {}

  /// Returns the health at session time `now_s`. For displays: it may allocate.
  virtual TrackerHealth health(double /*now_s*/) const {
    TrackerHealth well;
    well.state = TrackerHealth::State::delivering;
    return well;
  }
};

}  // namespace carom
