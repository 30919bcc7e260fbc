// The tip of a tool that was turned about it.
#include "app/calibration/tip_fit.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "app/simulated_calibration.h"

namespace carom {
namespace {

using test::CalibratingPerson;
using test::SimulatedRoom;
using test::TemporaryFolder;

// A tip that cannot be, and why.
TEST(Calibration, JudgesTheTurnedTool) {
  const auto tipOfRoom = [](const SimulatedRoom& room) {
    const TemporaryFolder folder;
    CalibratingPerson(room).pivot(folder / "");
    return fitTip(readTrace(folder / kPivotFile));
  };
  SimulatedRoom room;
  EXPECT_EQ(tipOfRoom(room).fault, "");
  room.scale = 1000.0;
  EXPECT_NE(tipOfRoom(room).fault.find("181 m from the sensor"), std::string::npos) << tipOfRoom(room).fault;
  room.scale = 1.0;
  room.noise_m = 0.01;
  EXPECT_NE(tipOfRoom(room).fault.find("the tip moved by"), std::string::npos) << tipOfRoom(room).fault;
  std::vector<TrackerSample> still(100);
  for (TrackerSample& sample : still) sample.hasOrientation = true;
  EXPECT_NE(fitTip(still).fault.find("turned too little"), std::string::npos);
  EXPECT_NE(fitTip({still.data(), 10}).fault.find("too few"), std::string::npos);
  still[5].hasOrientation = false;
  EXPECT_NE(fitTip(still).fault.find("no orientation"), std::string::npos);
}

}  // namespace
}  // namespace carom
