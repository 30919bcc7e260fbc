#pragma once
// The person of config/traces/walk.csv.

#include <cmath>
#include <vector>

#include "devices/tracker/simulated_tracker.h"

namespace carom {

/// 36 seconds at 60 Hz in a room with x to the right, y up and z to the back, the floor's middle at the
/// origin: standing, shifting, walking about. Rounded to micrometres and microradians, as trackers do.
inline std::vector<TrackerSample> walkTrace() {
  SimulatedPerson person;
  person.seed = 7;
  person.rate_hz = 60.0;
  SimulatedTracker tracker(person);
  std::vector<TrackerSample> samples;
  tracker.poll(36.0, samples);
  const auto rounded = [](double value) { return std::round(value * 1e6) / 1e6; };
  for (TrackerSample& sample : samples) {
    sample.time_s = rounded(sample.time_s);
    for (int i = 0; i < 3; ++i) sample.pose.position_m[i] = rounded(sample.pose.position_m[i]);
    for (int i = 0; i < 4; ++i) sample.pose.orientation[i] = rounded(sample.pose.orientation[i]);
  }
  return samples;
}

}  // namespace carom
