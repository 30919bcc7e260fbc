#pragma once
// The moments of a recording in which a sensor was held still: the points that somebody touched with it.

#include <cstddef>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "devices/tracker/tracker.h"

namespace carom {

/// A time in which a point on the sensor did not move.
struct Rest {
  double begin_s = 0.0, end_s = 0.0;
  std::size_t samples = 0;
  Pose pose;  ///< mean pose of the sensor, in the tracker's axes
  bool hasOrientation = false;
  glm::dvec3 at_m{0.0};   ///< mean place of the point
  double spread_m = 0.0;  ///< rms distance of the point from that place
};

struct RestLimits {
  double radius_m = 0.005;  ///< the point stays so near to its mean
  double least_s = 0.8;     ///< for so long
};

/// Returns the rests of a point that is fixed to the sensor at `point_m`, in order of time. A rest ends where
/// the point moves farther than the limit for over 0.1 s, or where no sample comes for 0.25 s. Two rests at
/// one place count as one if the point has not been 50 mm away in between, and samples came all the time.
std::vector<Rest> restsOf(std::span<const TrackerSample> samples, const glm::dvec3& point_m,
                          const RestLimits& limits = {});

/// Returns the standard deviation of a coordinate from sample to sample: what the tracker adds, without what
/// the hand does. 0 for fewer than three samples.
double noiseOf_m(std::span<const TrackerSample> samples);

}  // namespace carom
