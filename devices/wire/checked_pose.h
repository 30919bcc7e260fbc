#pragma once
// Turns numbers from outside into a pose, if they are one.

#include <array>
#include <cmath>
#include <optional>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>

#include "engine/base/pose.h"

namespace carom {

inline constexpr double kFarthestPose_m = 1000.0;  // no tracker sees farther
inline constexpr double kMetresPerMillimetre = 1e-3;
inline constexpr double kQuaternionMiss = 0.02;  // from length 1; floats and rounded decimals miss by less

/// Returns the pose with that position and orientation, normalised; none if a number is not finite, the
/// position is farther than 1 km, or the quaternion is no rotation.
inline std::optional<Pose> checkedPose(const glm::dvec3& position_m, const glm::dquat& orientation) {
  const double length = glm::length(orientation);
  if (!(glm::length(position_m) <= kFarthestPose_m)) return {};  // NaN, too
  if (!(std::abs(length - 1.0) <= kQuaternionMiss)) return {};
  return Pose{position_m, orientation / length};
}

/// Returns the rotation whose matrix has these columns, one after another; none if they are far from one.
inline std::optional<glm::dquat> checkedRotation(const std::array<double, 9>& r) {
  constexpr double kMiss = 0.01;                                             // six decimals miss by 1e-5
  const glm::dmat3 m(r[0], r[1], r[2], r[3], r[4], r[5], r[6], r[7], r[8]);  // by columns, as GLM's
  const glm::dmat3 product = glm::transpose(m) * m;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      if (!(std::abs(product[i][j] - (i == j ? 1.0 : 0.0)) <= kMiss)) return {};
    }
  }
  if (!(glm::determinant(m) > 0.0)) return {};
  return glm::normalize(glm::quat_cast(m));
}

}  // namespace carom
