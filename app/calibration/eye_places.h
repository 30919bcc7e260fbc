#pragma once
// Where the eyes are on the head, from sightings of marks that cover each other.

#include <span>
#include <string>
#include <vector>

#include "devices/calibration/eye_fit.h"
#include "engine/base/pose.h"

namespace carom {

struct EyePlaces {
  Pose eyesFromSensor;
  double separation_m = 0.0;
  EyeFit left, right;
  std::vector<std::string> faults;  ///< if there is any, the places must not be used
};

/// Fits both eyes and judges them. The line from the left eye to the right one is the person's right; the
/// person's up is as near to the room's up as that line and the mean pose of the head allow.
EyePlaces fitEyes(std::span<const Sighting> left, std::span<const Sighting> right, const RoomAxes& axes);

}  // namespace carom
