#pragma once
// The rigid motion between two sets of measured points.

#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "engine/base/pose.h"

namespace carom {

/// A point that was measured in two frames.
struct PointPair {
  glm::dvec3 inA_m{0.0};
  glm::dvec3 inB_m{0.0};
};

/// The motion that takes the points of B nearest to those of A, and what it leaves.
struct RigidFit {
  Pose aFromB;
  std::vector<glm::dvec3> misses_m;  ///< aFromB * inB - inA of each pair, in A's axes
  double rms_m = 0.0;                ///< of the lengths of the misses
};

/// Returns the least-squares motion (Horn 1987). There must be a pair at least; fewer than three, or points
/// on one line, leave a turn open, which is then arbitrary.
RigidFit fitRigid(std::span<const PointPair> pairs);

/// Returns the same after B is mirrored through its origin: `aFromB` then takes -inB to A. It fits where one
/// of the frames is left-handed, or left and right have been exchanged.
RigidFit fitMirrored(std::span<const PointPair> pairs);

/// Returns the length in A of one unit of length in B: the ratio of the points' spreads, which does not
/// depend on the turn (Horn 1987, section 2.E). NaN where all points of B are one.
double scaleBetween(std::span<const PointPair> pairs);

/// Returns the standard deviations of the points along their principal axes, largest first. The third is 0
/// for points in a plane, and the second for points on a line.
glm::dvec3 extentOf(std::span<const glm::dvec3> points_m);

/// How well a fit is known, if its misses are independent errors of one size.
struct FitError {
  double place_m = 0.0;   ///< standard deviation of a coordinate in the middle of the points
  double turn_rad = 0.0;  ///< standard deviation of the turn about the axis that is known worst
};

/// Returns none-too-small errors only from four pairs on that do not lie on one line; otherwise infinity.
FitError errorOf(const RigidFit& fit, std::span<const PointPair> pairs);

}  // namespace carom
