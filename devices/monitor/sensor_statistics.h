#pragma once
// How the samples of one sensor come: for the tables of `carom track`.

#include <cstddef>
#include <limits>
#include <vector>

#include "devices/filter/tracker_noise.h"
#include "devices/tracker/tracker.h"

namespace carom {

/// Figures of the last two seconds, but for the counts. NaN: not known (yet).
struct SensorFigures {
  static constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
  double rate_hz = kUnknown;
  double age_s = kUnknown;     ///< of the newest sample: since its pose held
  double jitter_s = kUnknown;  ///< standard deviation of the intervals
  /// The noise of a coordinate, told while the sensor was last at rest, of nothing else. Below 20 Hz a person
  /// who sways counts as noise, too; below 4 Hz it is not told.
  double rest_m = kUnknown;
  double quality = kUnknown;  ///< 0 … 1, where the tracker says
  double battery = kUnknown;  ///< 0 … 1, where the tracker says
  std::size_t samples = 0;    ///< since the beginning
  std::size_t dropouts = 0;   ///< intervals of over one and a half usual ones, since the beginning
};

class SensorStatistics {
 public:
  /// Times increase.
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
  TrackerNoise noise_;      // for whether the sensor is still
  TrackerNoise restNoise_;  // since it is
  double stillSince_s_ = SensorFigures::kUnknown;
  double rest_m_ = SensorFigures::kUnknown;
};

}  // namespace carom
