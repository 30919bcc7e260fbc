#include "devices/calibration/eye_fit.h"

#include <Eigen/Dense>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "devices/calibration/eigen_glm.h"

namespace carom {
namespace {

/// A line in the sensor's axes.
struct Line {
  glm::dvec3 at_m;
  glm::dvec3 along;  ///< unit vector
};

Line lineOf(const Sighting& sighting) {
  const Pose sensorFromRoom = inverse(sighting.roomFromSensor);
  return {sensorFromRoom * sighting.near_m,
          sensorFromRoom.orientation * glm::normalize(sighting.far_m - sighting.near_m)};
}

}  // namespace

/// The eye e is on the line through q along d: (1 - d dᵀ)(e - q) = 0. Each sighting has two degrees of
/// freedom.
EyeFit fitEye(std::span<const Sighting> sightings) {
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (const Sighting& sighting : sightings) {
    const Line line = lineOf(sighting);
    const Eigen::Vector3d d = eigenOf(line.along);
    const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - d * d.transpose();
    normal += across;
    right += across * eigenOf(line.at_m);
  }
  const Eigen::Vector3d found = normal.completeOrthogonalDecomposition().solve(right);
  EyeFit fit;
  fit.eye_m = {found(0), found(1), found(2)};
  double sum_m2 = 0.0;
  for (const Sighting& sighting : sightings) {
    const Line line = lineOf(sighting);
    const glm::dvec3 miss_m = glm::cross(line.along, fit.eye_m - line.at_m);
    sum_m2 += glm::dot(miss_m, miss_m);
  }
  const auto count = static_cast<double>(sightings.size());
  fit.rms_m = std::sqrt(sum_m2 / count);
  fit.eyeError_m = std::numeric_limits<double>::infinity();
  const double least = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(normal).eigenvalues()(0);
  if (sightings.size() < 2 || !(least > 1e-9 * count)) return fit;
  fit.eyeError_m = fit.rms_m * std::sqrt(count / (2.0 * count - 3.0) / least);
  return fit;
}

}  // namespace carom
