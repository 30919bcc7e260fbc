#pragma once
// Estimates how a head is turned from a gyroscope and an accelerometer.

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

namespace carom {

/// The explicit complementary filter with bias correction of R. Mahony, T. Hamel and J.-M. Pflimlin
/// ("Nonlinear complementary filters on the special orthogonal group", IEEE Trans. Automatic Control 53,
/// 2008, eq. 48), with the felt acceleration as the one direction that is known: at rest it points up.
///
/// Fast turns come from the gyroscope; tilt (and the gyroscope's bias about level axes) settles to the
/// accelerometer's within some seconds. Nothing tells the heading: it starts at 0 and drifts with the bias
/// about the vertical, by some degrees a minute with a headset's sensors.
class OrientationFilter {
 public:
  /// Takes a sample, `interval_s` after the last one: the rate of turn and the felt acceleration in the
  /// sensor's axes; y is up when it is level. Numbers that are not finite change nothing.
  void update(double interval_s, const glm::dvec3& rate_rad_s, const glm::dvec3& acceleration_m_s2);

  /// levelFromSensor: y is up. Identity until an acceleration has shown which way up is.
  const glm::dquat& orientation() const { return levelFromSensor_; }

  /// Returns by how much the gyroscope reads too high, as far as known.
  const glm::dvec3& bias_rad_s() const { return bias_rad_s_; }

 private:
  void level(const glm::dvec3& upInSensor);

  glm::dquat levelFromSensor_{1.0, 0.0, 0.0, 0.0};
  glm::dvec3 bias_rad_s_{0.0};
  bool levelled_ = false;
};

}  // namespace carom
