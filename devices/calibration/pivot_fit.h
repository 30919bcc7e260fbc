#pragma once
// The tip of a pointing tool, from its motion about the tip.

#include <span>

#include <glm/vec3.hpp>

#include "engine/base/pose.h"

namespace carom {

struct PivotFit {
  glm::dvec3 tip_m{0.0};    ///< in the sensor's axes
  glm::dvec3 pivot_m{0.0};  ///< where the tip was, in the tracker's axes
  double rms_m = 0.0;       ///< of the distances between the tip and that place
  double tipError_m = 0.0;  ///< standard deviation of the tip along the direction that is known worst
};

/// Returns the least-squares tip of a tool that was turned about its tip, which stayed at one place:
/// orientation_i tip + position_i = pivot. There must be a pose at least. A tool that was turned about one
/// axis only leaves the tip's place along that axis open: its error is then infinite, as it is for fewer than
/// four poses.
PivotFit fitPivot(std::span<const Pose> trackerFromSensor);

}  // namespace carom
