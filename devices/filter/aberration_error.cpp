#include "devices/filter/aberration_error.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace carom {

double aberrationError_rad(const glm::dvec3& celerity_m_s, const glm::dmat3& covariance_m2_s2,
                           double lightSpeed_m_s) {
  const double trace = covariance_m2_s2[0][0] + covariance_m2_s2[1][1] + covariance_m2_s2[2][2];
  const double speed_m_s = glm::length(celerity_m_s);
  // At rest no direction is special; any will do.
  const glm::dvec3 along = speed_m_s > 0.0 ? celerity_m_s / speed_m_s : glm::dvec3(1.0, 0.0, 0.0);
  const double alongVariance = glm::dot(along, covariance_m2_s2 * along);
  const double acrossVariance = 0.5 * (trace - alongVariance);  // of one of two components
  const double gamma = std::hypot(1.0, speed_m_s / lightSpeed_m_s);
  const double tanhHalf = speed_m_s / lightSpeed_m_s / (gamma + 1.0);  // sinh η/(cosh η + 1)
  return std::hypot(std::sqrt(std::max(0.0, alongVariance)) / gamma,
                    (1.0 + tanhHalf) * std::sqrt(std::max(0.0, acrossVariance))) /
         lightSpeed_m_s;
}

}  // namespace carom
