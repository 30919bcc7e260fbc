#pragma once
// Where a tracker is in the room, from corners that were touched with its sensor, and the faults of the
// touches if they do not fit.

#include <span>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "app/calibration/corner_names.h"
#include "devices/calibration/rigid_fit.h"

namespace carom {

/// A corner, and where the tracker saw it touched.
struct Touch {
  NamedCorner corner;
  glm::dvec3 tip_m{0.0};     ///< in the tracker's axes
  glm::dvec3 sensor_m{0.0};  ///< the sensor's own place, which is on the person's side of the wall
};

/// A corner that misses its place by more than this deserves a remark; by more than kMostMiss_m, the
/// calibration is refused. A measured corner, a hand and a tracker together are seldom better than the first.
inline constexpr double kGoodMiss_m = 0.010;
inline constexpr double kMostMiss_m = 0.025;

struct CornerFit {
  RigidFit fit;  ///< `aFromB` is roomFromTracker
  FitError error;
  double scale = 1.0;                ///< of the room's lengths to the tracker's
  double mirroredRms_m = 0.0;        ///< of the misses, were the tracker mirrored
  bool flat = false;                 ///< the corners lie in a plane, which is its own mirror image
  std::vector<std::string> faults;   ///< if there is any, the fit must not be used
  std::vector<std::string> remarks;  ///< what deserves a look
};

/// Fits and judges. Where the touches do not fit, every simple explanation is tried: another scale, a
/// mirrored tracker, corners touched twice or in another order, one bad corner.
CornerFit fitCorners(std::span<const Touch> touches);

}  // namespace carom
