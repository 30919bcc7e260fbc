// Eyes that look past marks at corners: where they are on the head, and which cannot be.
#include "app/calibration/eye_places.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/geometric.hpp>
#include <utility>
#include <vector>

#include "app/calibration/touched_corners.h"
#include "app/simulated_calibration.h"

namespace carom {
namespace {

using test::CalibratingPerson;
using test::placesOf;
using test::SimulatedRoom;
using test::TemporaryFolder;
using test::theRig;
using test::turnBetween_deg;

// The eyes, too, each to some millimetres: they are sighted over arm's length by a head that sways.
TEST(Calibration, FindsTipAndEyes) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    const TemporaryFolder folder;
    const Rig rig = theRig();
    SimulatedRoom room;
    room.seed = seed;
    CalibrationPlan plan;
    plan.corners = cornersOf(rig);
    plan.targets =
        chosenCorners(plan.corners, "front.upper_left,front.upper_right,front.lower_left,front.lower_right");
    plan.pivot = plan.sight = true;
    const glm::dvec3 mark_m(0.1, 1.5, 0.2);
    CalibratingPerson person(room);
    person.pivot(folder / "");
    auto places_m = placesOf(plan.corners);
    places_m.push_back(mark_m);
    person.touch(folder / "", places_m);
    person.sight(folder / "", mark_m, placesOf(plan.targets));
    const CalibrationData data = readCalibration(folder / "", plan);
    EXPECT_LT(glm::distance(data.tip->fit.tip_m, room.tip_m), 0.001) << "seed " << seed;
    std::array<std::vector<Sighting>, 2> sightings;
    for (std::size_t eye = 0; eye < 2; ++eye) {
      for (const HeldAt& held : data.sighted[eye]) {
        sightings[eye].push_back({room.roomFromTracker * held.rest.pose, mark_m, held.corner.at_m});
      }
    }
    const EyePlaces eyes = fitEyes(sightings[0], sightings[1], rig.axes);
    ASSERT_TRUE(eyes.faults.empty()) << "seed " << seed << ": " << eyes.faults[0];
    EXPECT_NEAR(eyes.separation_m, room.eyeSeparation_m, 0.003) << "seed " << seed;
    for (const double side : {-0.5, 0.5}) {
      const glm::dvec3 eye_m(side * room.eyeSeparation_m, 0.0, 0.0);
      const glm::dvec3 inSensor_m = inverse(room.eyesFromSensor) * eye_m;
      const glm::dvec3 found_m = inverse(eyes.eyesFromSensor) * glm::dvec3(side * eyes.separation_m, 0, 0);
      EXPECT_LT(glm::distance(found_m, inSensor_m), 0.003) << "seed " << seed;
    }
    // The head looked up and down in equal parts, so that its mean is upright to some degrees.
    EXPECT_LT(turnBetween_deg(eyes.eyesFromSensor.orientation, room.eyesFromSensor.orientation), 10.0)
        << "seed " << seed;
  }
}

TEST(Calibration, EyesThatCannotBeAreRefused) {
  const RoomAxes axes;
  std::vector<Sighting> sightings;
  for (const glm::dvec3 far_m : {glm::dvec3(-1, 2, -1), glm::dvec3(1, 1, -1), glm::dvec3(0, 0, -1)}) {
    const glm::dvec3 mark_m(0, 1.5, 0);
    const glm::dvec3 eye_m = mark_m + 0.4 * glm::normalize(mark_m - far_m);
    sightings.push_back({{eye_m - glm::dvec3(0, 0, 0.1), {1, 0, 0, 0}}, mark_m, far_m});
  }
  // The same eye twice.
  ASSERT_EQ(fitEyes(sightings, sightings, axes).faults.size(), 1u);
  EXPECT_NE(fitEyes(sightings, sightings, axes).faults[0].find("0 mm apart"), std::string::npos);
  // One sighting only.
  EXPECT_NE(fitEyes({sightings.data(), 1}, sightings, axes).faults[0].find("left eye is open"),
            std::string::npos);
  // Marks in the wrong order.
  auto between = sightings;
  for (Sighting& sighting : between) std::swap(sighting.near_m, sighting.far_m);
  EXPECT_NE(fitEyes(sightings, between, axes).faults[0].find("between the marks"), std::string::npos);
}

}  // namespace
}  // namespace carom
