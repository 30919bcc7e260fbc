#pragma once
// The corners of a simulated room, touched by a simulated person.

#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "app/calibration/corner_fit.h"
#include "app/simulated_calibration.h"

namespace carom::test {

inline Rig theRig() { return readRig("rig.toml", calibratedRig()); }

/// The touches of a recording, as `carom calibrate` takes them.
inline std::vector<Touch> touchesOf(const CalibrationData& data) {
  std::vector<Touch> touches;
  for (const HeldAt& held : data.touched) {
    touches.push_back({held.corner, held.rest.at_m, held.rest.pose.position_m});
  }
  return touches;
}

/// Lets a person touch places while the corners of the rig are asked for.
inline std::vector<Touch> touchesIn(const SimulatedRoom& room, const std::vector<glm::dvec3>& places_m) {
  const TemporaryFolder folder;
  CalibrationPlan plan;
  plan.corners = cornersOf(theRig());
  plan.pivot = room.tip_m != glm::dvec3(0.0);
  CalibratingPerson person(room);
  if (plan.pivot) person.pivot(folder / "");
  person.touch(folder / "", places_m);
  return touchesOf(readCalibration(folder / "", plan));
}

inline std::vector<glm::dvec3> corners_m() {
  const TemporaryFolder folder;
  return placesOf(cornersOf(theRig()));
}

inline std::string faultsOf(const SimulatedRoom& room, const std::vector<glm::dvec3>& places_m) {
  std::string all;
  for (const std::string& fault : fitCorners(touchesIn(room, places_m)).faults) all += fault + "\n";
  return all;
}

}  // namespace carom::test
