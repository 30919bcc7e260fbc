#include "devices/filter/orientation_filter.h"

#include <algorithm>
#include <cmath>

namespace carom {
namespace {

constexpr double kGravity_m_s2 = 9.80665;
constexpr glm::dvec3 kUp{0.0, 1.0, 0.0};

// A tilt error decays with s² + kP s + kI = 0: a little over critical damping, settled within 10 s. A head
// that walks is pushed about by 1 m/s² (6° of false tilt) back and forth in half a second; of that 1° is
// left.
constexpr double kP_1_s = 0.3;
constexpr double kI_1_s2 = 0.02;
// The felt direction means less the further its size is from gravity: nothing from 20 % on.
constexpr double kOtherwise = 0.2;
constexpr double kLongestStep_s = 0.1;       // longer gaps are not guessed
constexpr double kGreatestBias_rad_s = 0.2;  // no gyroscope that works has more

bool finite(const glm::dvec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

/// exp(θ/2) as a quaternion: the turn about θ by its length.
glm::dquat turn(const glm::dvec3& angle_rad) {
  const double half = 0.5 * glm::length(angle_rad);
  const double sinc = half > 1e-6 ? std::sin(half) / half : 1.0 - half * half / 6.0;
  const glm::dvec3 imaginary = 0.5 * sinc * angle_rad;
  return {std::cos(half), imaginary.x, imaginary.y, imaginary.z};
}

}  // namespace

void OrientationFilter::update(double interval_s, const glm::dvec3& rate_rad_s,
                               const glm::dvec3& acceleration_m_s2) {
  if (!finite(rate_rad_s) || !finite(acceleration_m_s2) || !(interval_s > 0.0)) return;
  const double step_s = std::min(interval_s, kLongestStep_s);
  const double felt = glm::length(acceleration_m_s2) / kGravity_m_s2;
  const double weight = std::max(0.0, 1.0 - std::abs(felt - 1.0) / kOtherwise);

  // q̇ = ½ q ⊗ (ω − b + kP ω_mes),   ḃ = −kI ω_mes: the gyroscope's turn first, as the acceleration is
  // that of its end.
  levelFromSensor_ = glm::normalize(levelFromSensor_ * turn(step_s * (rate_rad_s - bias_rad_s_)));
  if (weight == 0.0) return;
  const glm::dvec3 upFelt = acceleration_m_s2 / glm::length(acceleration_m_s2);
  if (!levelled_) return level(upFelt);
  const glm::dvec3 upBelieved = glm::conjugate(levelFromSensor_) * kUp;
  const glm::dvec3 correction = weight * glm::cross(upFelt, upBelieved);  // ω_mes = v × v̂
  levelFromSensor_ = glm::normalize(levelFromSensor_ * turn(step_s * kP_1_s * correction));
  bias_rad_s_ =
      glm::clamp(bias_rad_s_ - step_s * kI_1_s2 * correction, -kGreatestBias_rad_s, kGreatestBias_rad_s);
}

/// The smallest turn that takes `upInSensor` to up.
void OrientationFilter::level(const glm::dvec3& upInSensor) {
  const glm::dvec3 axis = glm::cross(upInSensor, kUp);
  const double cosine = glm::dot(upInSensor, kUp);
  levelFromSensor_ = cosine > -0.999999 ? glm::normalize(glm::dquat(1.0 + cosine, axis.x, axis.y, axis.z))
                                        : glm::dquat(0.0, 0.0, 0.0, 1.0);  // upside down: rolled over
  levelled_ = true;
}

}  // namespace carom
