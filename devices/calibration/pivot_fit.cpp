#include "devices/calibration/pivot_fit.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>
#include <limits>

#include "devices/calibration/symmetric_matrix.h"

namespace carom {

/// The unknowns are the tip t and the pivot p; each pose (R, x) gives the three equations R t - p = -x. By
/// the equations for p, n p = Σ R t + Σ x; with it those for t are (n - Σ Rᵀ Σ R / n) t = Σ Rᵀ Σ x / n - Σ Rᵀ
/// x. The inverse of their matrix, times σ², is the covariance of t, with 3n - 6 degrees of freedom.
PivotFit fitPivot(std::span<const Pose> trackerFromSensor) {
  const auto count = static_cast<double>(trackerFromSensor.size());
  glm::dmat3 turns(0.0);
  glm::dvec3 positions_m(0.0), inSensor_m(0.0);
  for (const Pose& pose : trackerFromSensor) {
    turns += glm::mat3_cast(pose.orientation);
    positions_m += pose.position_m;
    inSensor_m += glm::inverse(pose.orientation) * pose.position_m;
  }
  const glm::dmat3 ofTip = count * glm::dmat3(1.0) - glm::transpose(turns) * turns / count;
  PivotFit fit;
  fit.tip_m = leastSolution(ofTip, glm::transpose(turns) * positions_m / count - inSensor_m);
  fit.pivot_m = (turns * fit.tip_m + positions_m) / count;
  double sum_m2 = 0.0;
  for (const Pose& pose : trackerFromSensor) {
    const glm::dvec3 miss_m = pose * fit.tip_m - fit.pivot_m;
    sum_m2 += glm::dot(miss_m, miss_m);
  }
  fit.rms_m = std::sqrt(sum_m2 / count);
  fit.tipError_m = std::numeric_limits<double>::infinity();
  const double least = eigenvaluesOf(ofTip)[0];
  if (trackerFromSensor.size() < 4 || !(least > 1e-9 * count)) return fit;
  fit.tipError_m = fit.rms_m * std::sqrt(count / (3.0 * count - 6.0) / least);
  return fit;
}

}  // namespace carom
