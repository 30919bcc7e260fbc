#pragma once
// Turns numbers from outside into a pose, if they are one.

#include <cmath>
#include <optional>

#include <glm/geometric.hpp>

#include "engine/base/pose.h"

namespace carom {

inline constexpr double kFarthestPose_m = 1000.0;  // no tracker sees farther
inline constexpr double kQuaternionMiss = 0.02;    // from length 1; floats and rounded decimals miss by less

/// Returns the pose with that position and orientation, normalised; none if a number is not finite, the
/// position is farther than 1 km, or the quaternion is no rotation.
inline std::optional<Pose> checkedPose(const glm::dvec3& position_m, const glm::dquat& orientation) {
  const double length = glm::length(orientation);
  if (!(glm::length(position_m) <= kFarthestPose_m)) return {};  // NaN, too
  if (!(std::abs(length - 1.0) <= kQuaternionMiss)) return {};
  return Pose{position_m, orientation / length};
}

}  // namespace carom
