#include "app/calibration/eye_places.h"

#include <fmt/format.h>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat3x3.hpp>
#include <string_view>

namespace carom {
namespace {

constexpr double kMostEyeError_m = 0.010;
constexpr double kMostEyeMiss_m = 0.010;
constexpr double kLeastSeparation_m = 0.045, kMostSeparation_m = 0.085;  // of adults and children

void judgeEye(std::string_view which, const EyeFit& fit, std::span<const Sighting> sightings,
              std::vector<std::string>& faults) {
  if (!(fit.eyeError_m <= kMostEyeError_m)) {
    faults.push_back(fmt::format(
        "the place of the {} eye is open: turn the head more from sighting to sighting, left, right, up and "
        "down",
        which));
    return;
  }
  if (!(fit.rms_m <= kMostEyeMiss_m)) {
    faults.push_back(
        fmt::format("the {} eye misses its lines of sight by {:.1f} mm (rms), expected at most {:.0f} mm: "
                    "keep still while "
                    "the mark covers the corner",
                    which, 1e3 * fit.rms_m, 1e3 * kMostEyeMiss_m));
  }
  for (const Sighting& sighting : sightings) {
    const glm::dvec3 eye_m = sighting.roomFromSensor * fit.eye_m;
    if (glm::dot(eye_m - sighting.near_m, sighting.far_m - sighting.near_m) < 0.0) continue;
    faults.push_back(fmt::format("the {} eye would have been between the marks", which));
    return;
  }
}

/// Returns the room's up as the sensor saw it, on average.
glm::dvec3 meanUp(std::span<const Sighting> left, std::span<const Sighting> right, const RoomAxes& axes) {
  glm::dvec3 up(0.0);
  for (const auto& sightings : {left, right}) {
    for (const Sighting& sighting : sightings) {
      up += glm::conjugate(sighting.roomFromSensor.orientation) * axes.up;
    }
  }
  return up;
}

}  // namespace

EyePlaces fitEyes(std::span<const Sighting> left, std::span<const Sighting> right, const RoomAxes& axes) {
  EyePlaces eyes;
  eyes.left = fitEye(left);
  eyes.right = fitEye(right);
  judgeEye("left", eyes.left, left, eyes.faults);
  judgeEye("right", eyes.right, right, eyes.faults);
  if (!eyes.faults.empty()) return eyes;
  const glm::dvec3 across_m = eyes.right.eye_m - eyes.left.eye_m;
  eyes.separation_m = glm::length(across_m);
  if (!(eyes.separation_m >= kLeastSeparation_m && eyes.separation_m <= kMostSeparation_m)) {
    eyes.faults.push_back(
        fmt::format("the eyes come out {:.0f} mm apart, expected {:.0f} to {:.0f} mm: each sighting must be "
                    "made with the "
                    "eye that is asked for, the other one closed",
                    1e3 * eyes.separation_m, 1e3 * kLeastSeparation_m, 1e3 * kMostSeparation_m));
    return eyes;
  }
  // The person's axes in the sensor's, and the turn that takes them to the rig's.
  const glm::dvec3 right1 = across_m / eyes.separation_m;
  const glm::dvec3 up0 = meanUp(left, right, axes);
  const glm::dvec3 up1 = up0 - glm::dot(up0, right1) * right1;
  if (!(glm::length(up1) > 0.5 * glm::length(up0))) {
    eyes.faults.push_back(
        "one eye comes out above the other: each sighting must be made with the eye that is "
        "asked for, the head upright");
    return eyes;
  }
  const glm::dmat3 sensorFromPerson(right1, glm::normalize(up1), glm::cross(glm::normalize(up1), right1));
  const glm::dmat3 rigFromPerson(axes.right, axes.up, axes.forward);
  eyes.eyesFromSensor.orientation =
      glm::normalize(glm::quat_cast(rigFromPerson * glm::transpose(sensorFromPerson)));
  eyes.eyesFromSensor.position_m =
      -(eyes.eyesFromSensor.orientation * (0.5 * (eyes.left.eye_m + eyes.right.eye_m)));
  return eyes;
}

}  // namespace carom
