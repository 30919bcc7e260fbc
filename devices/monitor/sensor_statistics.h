#pragma once
// Statistics of the samples of one sensor, for the tables of `carom track`.

#include <cstddef>
#include <limits>
#include <vector>

#include "devices/filter/tracker_noise.h"
#include "devices/tracker/tracker.h"

namespace carom {

/// The figures of the last two seconds, except for the counts. NaN: not known (yet).
struct SensorFigures {
  static constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  double rate_hz = kUnknown;
  double age_s = kUnknown;     ///< of the newest sample: the time since its pose held
  double jitter_s = kUnknown;  ///< standard deviation of the intervals
  /// The noise of a coordinate, measured while the sensor was last at rest. Below 20 Hz it includes the sway
  /// of a person; below 4 Hz it is not known.
  double rest_m = kUnknown;
  double quality = kUnknown;  ///< 0 … 1, if the tracker reports it
  double battery = kUnknown;  ///< 0 … 1, if the tracker reports it
  std::size_t samples = 0;    ///< since the start
  std::size_t dropouts = 0;   ///< intervals longer than one and a half usual ones, since the start
};

class SensorStatistics {
 public:
  /// Takes a sample. Its time must be later than that of the sample before.
  void add(const TrackerSample& sample);
  void setBattery(double share) { battery_ = share; }

  SensorFigures figures(double now_s) const;

 private:
  static constexpr double kMemory_s = 2.0;

  std::vector<double> times_s_;  // of the last two seconds
  double usual_s_ = 0.0;         // interval
  std::size_t samples_ = 0;
  std::size_t dropouts_ = 0;
  double quality_ = SensorFigures::kUnknown;
  double battery_ = SensorFigures::kUnknown;
  TrackerNoise noise_;      // tells whether the sensor is still
  TrackerNoise restNoise_;  // of the samples since it is still
  double stillSince_s_ = SensorFigures::kUnknown;
  double rest_m_ = SensorFigures::kUnknown;
};

}  // namespace carom
