#include "devices/calibration/pivot_fit.h"

#include <Eigen/Dense>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <limits>

#include "devices/calibration/eigen_glm.h"

namespace carom {

/// The unknowns are (tip, pivot); each pose gives the three equations (R -1)(tip, pivot) = -position. The
/// normal equations have the covariance σ² (Σ AᵀA)⁻¹ with 3n - 6 degrees of freedom.
PivotFit fitPivot(std::span<const Pose> trackerFromSensor) {
  using Matrix6 = Eigen::Matrix<double, 6, 6>;
  using Vector6 = Eigen::Matrix<double, 6, 1>;
  Matrix6 normal = Matrix6::Zero();
  Vector6 right = Vector6::Zero();
  for (const Pose& pose : trackerFromSensor) {
    Eigen::Matrix<double, 3, 6> row;
    row << eigenOf(pose.orientation), -Eigen::Matrix3d::Identity();
    normal += row.transpose() * row;
    right -= row.transpose() * eigenOf(pose.position_m);
  }
  const Vector6 found = normal.completeOrthogonalDecomposition().solve(right);
  PivotFit fit;
  fit.tip_m = {found(0), found(1), found(2)};
  fit.pivot_m = {found(3), found(4), found(5)};
  double sum_m2 = 0.0;
  for (const Pose& pose : trackerFromSensor) {
    const glm::dvec3 miss_m = pose * fit.tip_m - fit.pivot_m;
    sum_m2 += glm::dot(miss_m, miss_m);
  }
  const auto count = static_cast<double>(trackerFromSensor.size());
  fit.rms_m = std::sqrt(sum_m2 / count);
  fit.tipError_m = std::numeric_limits<double>::infinity();
  // What the poses say of the tip once the pivot is free: the Schur complement of the pivot's part.
  const Eigen::Matrix3d ofTip =
      normal.block<3, 3>(0, 0) - normal.block<3, 3>(0, 3) * normal.block<3, 3>(3, 0) / count;
  const double least = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(ofTip).eigenvalues()(0);
  if (trackerFromSensor.size() < 4 || !(least > 1e-9 * count)) return fit;
  fit.tipError_m = fit.rms_m * std::sqrt(count / (3.0 * count - 6.0) / least);
  return fit;
}

}  // namespace carom
