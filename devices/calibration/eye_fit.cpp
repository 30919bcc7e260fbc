#include "devices/calibration/eye_fit.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>

#include "devices/calibration/symmetric_matrix.h"

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
  glm::dmat3 normal(0.0);
  glm::dvec3 right(0.0);
  for (const Sighting& sighting : sightings) {
    const Line line = lineOf(sighting);
    const glm::dmat3 across = glm::dmat3(1.0) - glm::outerProduct(line.along, line.along);
    normal += across;
    right += across * line.at_m;
  }
  EyeFit fit;
  fit.eye_m = leastSolution(normal, right);
  double sum_m2 = 0.0;
  for (const Sighting& sighting : sightings) {
    const Line line = lineOf(sighting);
    const glm::dvec3 miss_m = glm::cross(line.along, fit.eye_m - line.at_m);
    sum_m2 += glm::dot(miss_m, miss_m);
  }
  const auto count = static_cast<double>(sightings.size());
  fit.rms_m = std::sqrt(sum_m2 / count);
  fit.eyeError_m = std::numeric_limits<double>::infinity();
  const double least = eigenvaluesOf(normal)[0];
  if (sightings.size() < 2 || !(least > 1e-9 * count)) return fit;
  fit.eyeError_m = fit.rms_m * std::sqrt(count / (2.0 * count - 3.0) / least);
  return fit;
}

}  // namespace carom
