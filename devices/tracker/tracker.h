#pragma once
// What every tracker offers, whether it is a device, a recording or a simulated person: poses of its
// sensors with the times at which they held, buttons and axes, and how it fares.

#include <cstdint>
#include <limits>
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
  double quality = std::numeric_limits<double>::quiet_NaN();  ///< 0 … 1 where the tracker says
};

/// How a tracker fares, for people.
struct TrackerHealth {
  enum class State {
    connecting,  ///< nothing has come yet, or it is being looked for again
    delivering,  ///< samples, buttons or axes come
    silent,      ///< connected, but these are overdue
    failed,      ///< it cannot work without someone's help: `message` says what
  };
  State state = State::connecting;
  std::string message;     ///< one line, empty while all is well
  bool connected = false;  ///< of one that is `connecting`: there is a connection, and nothing has come by it
  std::uint64_t samples = 0;     ///< delivered
  std::uint64_t gaps = 0;        ///< samples that the device numbered and that never came
  std::uint64_t late = 0;        ///< came after a later one, or after over 50 ms, and were dropped or counted
  std::uint64_t refused = 0;     ///< packets that were not understood
  std::uint64_t overflowed = 0;  ///< readings lost because nobody polled
  std::uint64_t reconnections = 0;
};

/// For people: "connecting", "delivering", "silent", "failed".
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

  /// Appends the samples delivered since the last poll with time_s <= now_s (session's clock, never
  /// running back), in order of time for each sensor. Allocates nothing once `samples` has room.
  virtual void poll(double now_s, std::vector<TrackerSample>& samples) = 0;

  /// Appends the buttons, axes, losses and battery levels that came with the last poll's samples, their
  /// `device_s` on the session's clock.
  virtual void takeInputs(std::vector<Reading>& /*inputs*/) {}

  /// How it fares at session time `now_s`. For displays: it may allocate.
  virtual TrackerHealth health(double /*now_s*/) const {
    TrackerHealth well;
    well.state = TrackerHealth::State::delivering;
    return well;
  }
};

}  // namespace carom
