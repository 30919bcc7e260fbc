// Recordings of a calibration whose rests are not those that were asked for.
#include "app/calibration/calibration_data.h"

#include <gtest/gtest.h>

#include <string>

#include "app/calibration/touched_corners.h"
#include "app/simulated_calibration.h"
#include "app/toml/input_file.h"

namespace carom {
namespace {

using test::CalibratingPerson;
using test::placesOf;
using test::SimulatedRoom;
using test::TemporaryFolder;
using test::theRig;

TEST(Calibration, SaysWhereTheRestsAreIfTheyAreTooFewOrTooMany) {
  const TemporaryFolder folder;
  CalibrationPlan plan;
  plan.corners = cornersOf(theRig());
  auto places_m = placesOf(plan.corners);
  places_m.pop_back();
  SimulatedRoom room;
  room.tip_m = glm::dvec3(0.0);
  CalibratingPerson(room).touch(folder / "", places_m);
  try {
    readCalibration(folder / "", plan);
    FAIL() << "seven rests for eight corners";
  } catch (const InputErrors& error) {
    EXPECT_NE(std::string(error.what()).find("corners.csv:1:1: the sensor was at rest 7 times (at 1."),
              std::string::npos)
        << error.what();
    EXPECT_NE(
        std::string(error.what()).find("expected 8, once for each of front.lower_left, front.lower_right"),
        std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace carom
