#pragma once
// The place of an eye on the head, from lines along which it looked.

#include <span>

#include <glm/vec3.hpp>

#include "engine/base/pose.h"

namespace carom {

/// A near mark covered a far one: the eye was on their line.
struct Sighting {
  Pose roomFromSensor;     ///< of the head's sensor
  glm::dvec3 near_m{0.0};  ///< the two marks, in the room
  glm::dvec3 far_m{0.0};
};

struct EyeFit {
  glm::dvec3 eye_m{0.0};    ///< in the sensor's axes
  double rms_m = 0.0;       ///< of the distances of the eye from the lines
  double eyeError_m = 0.0;  ///< standard deviation of the eye along the direction that is known worst
};

/// Returns the least-squares place of the eye. The marks of a sighting must be apart. Lines that are parallel
/// as the head sees them leave the eye's place along them open: the error is then infinite, as it is for
/// fewer than two sightings.
EyeFit fitEye(std::span<const Sighting> sightings);

}  // namespace carom
