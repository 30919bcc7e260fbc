#pragma once
// Numbers from outside, made a pose if they are one.

#include <cmath>
#include <optional>

#include <glm/geometric.hpp>

#include "engine/base/pose.h"

namespace carom {

inline constexpr double kFarthestPose_m = 1000.0;  // no tracker sees further
inline constexpr double kQuaternionMiss = 0.02;  // of a length of 1: floats and rounded decimals miss by less

/// The pose of that place and orientation, normalised; none where a number is not finite, the place is beyond
/// 1 km or the quaternion is no rotation.
inline std::optional<Pose> checkedPose(const glm::dvec3& position_m, const glm::dquat& orientation) {
  const double length = glm::length(orientation);
  if (!(glm::length(position_m) <= kFarthestPose_m)) return {};  // NaN, too
  if (!(std::abs(length - 1.0) <= kQuaternionMiss)) return {};
  return Pose{position_m, orientation / length};
}

}  // namespace carom
