// Simulated calibrations: what is found is the truth, and every usual mistake is named.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <glm/trigonometric.hpp>

#include "app/calibration/corner_fit.h"
#include "app/calibration/corner_order.h"
#include "app/calibration/eye_places.h"
#include "app/calibration/rig_lines.h"
#include "app/files/input_file.h"
#include "app/simulated_calibration.h"

namespace carom {
namespace {

using test::calibratedRig;
using test::CalibratingPerson;
using test::placesOf;
using test::SimulatedRoom;
using test::TemporaryFolder;
using test::turnBetween_deg;

Rig theRig() { return readRig("rig.toml", calibratedRig()); }

/// The touches of a recording, as `carom calibrate` takes them.
std::vector<Touch> touchesOf(const CalibrationData& data) {
  std::vector<Touch> touches;
  for (const HeldAt& held : data.touched) {
    touches.push_back({held.corner, held.rest.at_m, held.rest.pose.position_m});
  }
  return touches;
}

/// Lets a person touch places while the corners of the rig are asked for.
std::vector<Touch> touchesIn(const SimulatedRoom& room, const std::vector<glm::dvec3>& places_m) {
  const TemporaryFolder folder;
  CalibrationPlan plan;
  plan.corners = cornersOf(theRig());
  plan.pivot = room.tip_m != glm::dvec3(0.0);
  CalibratingPerson person(room);
  if (plan.pivot) person.pivot(folder / "");
  person.touch(folder / "", places_m);
  return touchesOf(readCalibration(folder / "", plan));
}

std::vector<glm::dvec3> corners_m() {
  const TemporaryFolder folder;
  return placesOf(cornersOf(theRig()));
}

std::string faultsOf(const SimulatedRoom& room, const std::vector<glm::dvec3>& places_m) {
  std::string all;
  for (const std::string& fault : fitCorners(touchesIn(room, places_m)).faults) all += fault + "\n";
  return all;
}

TEST(Calibration, NamesEachCornerOnceInTheOrderOfTheRig) {
  const auto corners = cornersOf(theRig());
  ASSERT_EQ(corners.size(), 8u);
  EXPECT_EQ(corners[1].name, "front.lower_right");
  EXPECT_EQ(corners[1].aliases, std::vector<std::string>{"right.lower_left"});
  EXPECT_EQ(wordsFor(corners[1]), "the lower right corner of wall 'front'");
  const auto chosen = chosenCorners(corners, "right.lower_left,left.upper_left");
  ASSERT_EQ(chosen.size(), 2u);
  EXPECT_EQ(chosen[0].at_m, corners[1].at_m);
  for (const char* wrong : {"", "front", "front.lower_left,", "front.middle", ","}) {
    EXPECT_THROW(chosenCorners(corners, wrong), std::invalid_argument) << wrong;
  }
}

// With 1 mm of noise: the tracker's place to 1 mm anywhere between the corners, and 0.1 degrees.
TEST(Calibration, FindsTheTrackerToAMillimetre) {
  const auto places_m = corners_m();
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SimulatedRoom room;
    room.seed = seed;
    const CornerFit fit = fitCorners(touchesIn(room, places_m));
    ASSERT_TRUE(fit.faults.empty()) << "seed " << seed << ": " << fit.faults[0];
    EXPECT_TRUE(fit.remarks.empty()) << "seed " << seed << ": " << fit.remarks[0];
    EXPECT_LT(turnBetween_deg(fit.fit.aFromB.orientation, room.roomFromTracker.orientation), 0.1)
        << "seed " << seed;
    for (const glm::dvec3& place_m : places_m) {
      const glm::dvec3 found_m = fit.fit.aFromB * (inverse(room.roomFromTracker) * place_m);
      EXPECT_LT(glm::distance(found_m, place_m), 0.001) << "seed " << seed;
    }
    EXPECT_LT(fit.fit.rms_m, 0.001) << "seed " << seed;
    EXPECT_GT(fit.mirroredRms_m, 0.2) << "seed " << seed;
  }
}

// A hand that misses each corner by 1 mm in each direction is worse than noise, which a second averages away:
// it is the middle of the corners that is then known to a millimetre or so, as the calibration says itself.
TEST(Calibration, KnowsWhatMissedTouchesCost) {
  const auto places_m = corners_m();
  double off_m2 = 0.0, stated_m2 = 0.0;
  constexpr int kSeeds = 200;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    SimulatedRoom room;
    room.seed = seed;
    room.touch_m = 0.001;
    const CornerFit fit = fitCorners(touchesIn(room, places_m));
    ASSERT_TRUE(fit.faults.empty()) << "seed " << seed << ": " << fit.faults[0];
    EXPECT_LT(turnBetween_deg(fit.fit.aFromB.orientation, room.roomFromTracker.orientation), 0.1)
        << "seed " << seed;
    glm::dvec3 middle_m(0.0);
    for (const glm::dvec3& place_m : places_m) middle_m += place_m / static_cast<double>(places_m.size());
    const glm::dvec3 off_m = fit.fit.aFromB * (inverse(room.roomFromTracker) * middle_m) - middle_m;
    EXPECT_LT(glm::length(off_m), 0.0015) << "seed " << seed;
    off_m2 += glm::dot(off_m, off_m) / 3.0;
    stated_m2 += fit.error.place_m * fit.error.place_m;
  }
  EXPECT_NEAR(std::sqrt(off_m2 / stated_m2), 1.0, 0.15);
}

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

TEST(Calibration, NamesAnotherScale) {
  const auto places_m = corners_m();
  SimulatedRoom room;
  room.scale = 1.05;
  const std::string faults = faultsOf(room, places_m);
  EXPECT_NE(faults.find("the tracker's lengths are 1.0"), std::string::npos) << faults;
  EXPECT_EQ(faults.find("; or "), std::string::npos) << faults;  // nothing else explains it
  room.scale = 1.0 / 0.3048;
  EXPECT_NE(faultsOf(room, places_m).find("feet"), std::string::npos) << faultsOf(room, places_m);
  room.scale = 1000.0;
  room.noise_m = 1.0;
  room.tip_m = glm::dvec3(0.0);
  EXPECT_NE(faultsOf(room, places_m).find("it sends millimetres as metres"), std::string::npos)
      << faultsOf(room, places_m);
}

// Too little to be refused, too much to be an error of the touching.
TEST(Calibration, RemarksASmallScale) {
  SimulatedRoom room;
  room.scale = 1.004;
  const CornerFit fit = fitCorners(touchesIn(room, corners_m()));
  ASSERT_TRUE(fit.faults.empty()) << fit.faults[0];
  ASSERT_EQ(fit.remarks.size(), 1u);
  EXPECT_NE(fit.remarks[0].find(" % too long: calibrate the tracker"), std::string::npos) << fit.remarks[0];
}

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

TEST(Calibration, NamesAMirroredTracker) {
  SimulatedRoom room;
  room.mirrored = true;
  for (room.seed = 1; room.seed <= 10; ++room.seed) {
    const std::string faults = faultsOf(room, corners_m());
    EXPECT_NE(faults.find("mirrored"), std::string::npos) << faults;
    EXPECT_EQ(faults.find("another order"), std::string::npos)
        << faults;  // though up and down look alike here
  }
}

TEST(Calibration, NamesEveryTwoExchangedCorners) {
  const auto places_m = corners_m();
  const auto corners = cornersOf(theRig());
  for (std::size_t i = 0; i < places_m.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      auto swapped_m = places_m;
      std::swap(swapped_m[i], swapped_m[j]);
      SimulatedRoom room;
      room.seed = 100 * i + j;
      const std::string faults = faultsOf(room, swapped_m);
      for (const auto& [asked, touched] : {std::pair(i, j), std::pair(j, i)}) {
        const std::string words = corners[touched].name + " where " + corners[asked].name + " was asked for";
        EXPECT_NE(faults.find(words), std::string::npos) << words << " in " << faults;
      }
      EXPECT_EQ(faults.find("lengths"), std::string::npos) << faults;
    }
  }
}

TEST(Calibration, NamesACornerThatWasTouchedTwice) {
  auto places_m = corners_m();
  places_m[3] = places_m[6];
  const std::string faults = faultsOf({}, places_m);
  EXPECT_NE(faults.find("front.upper_right and right.lower_right were touched at places"), std::string::npos)
      << faults;
  EXPECT_NE(faults.find("touched twice"), std::string::npos) << faults;
}

TEST(Calibration, NamesTheOneCornerThatIsOff) {
  for (std::size_t i = 0; i < 8; ++i) {
    auto places_m = corners_m();
    places_m[i] += glm::dvec3(0.05, 0.03, -0.04);
    SimulatedRoom room;
    room.seed = 7 + i;
    const std::string faults = faultsOf(room, places_m);
    EXPECT_NE(faults.find(cornersOf(theRig())[i].name + " alone is 7"), std::string::npos) << faults;
  }
}

// 5 cm of error in each touch are refused, and taken for nothing else than noise.
TEST(Calibration, RefusesFiveCentimetresOfNoise) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    SimulatedRoom room;
    room.seed = seed;
    room.touch_m = 0.05;
    const std::string faults = faultsOf(room, corners_m());
    EXPECT_NE(faults.find("miss their places"), std::string::npos) << "seed " << seed << ": " << faults;
    EXPECT_EQ(faults.find("mirrored:"), std::string::npos) << "seed " << seed << ": " << faults;
    EXPECT_EQ(faults.find("another order:"), std::string::npos) << "seed " << seed << ": " << faults;
    EXPECT_EQ(faults.find("lengths are"), std::string::npos) << "seed " << seed << ": " << faults;
  }
}

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

TEST(Calibration, FewFlatAndStraightCornersAreJudged) {
  const auto corners = cornersOf(theRig());
  const auto touchesOfCorners = [&](const std::string& names) {
    std::vector<Touch> touches;
    for (const NamedCorner& corner : chosenCorners(corners, names)) {
      touches.push_back({corner, corner.at_m, corner.at_m + 0.2 * corner.normal});
    }
    return touches;
  };
  EXPECT_NE(fitCorners(touchesOfCorners("front.lower_left,front.lower_right,left.upper_left"))
                .faults[0]
                .find("3 touched corners are too few"),
            std::string::npos);
  const CornerFit flat =
      fitCorners(touchesOfCorners("front.lower_left,front.lower_right,front.upper_left,front.upper_right"));
  EXPECT_TRUE(flat.faults.empty());
  ASSERT_EQ(flat.remarks.size(), 1u);
  EXPECT_NE(flat.remarks[0].find("one plane"), std::string::npos);
  // Left and right exchanged on one wall: the points fit, turned round; the sensor's body tells.
  auto exchanged = touchesOfCorners("front.lower_left,front.lower_right,front.upper_left,front.upper_right");
  std::swap(exchanged[0].tip_m, exchanged[1].tip_m);
  std::swap(exchanged[0].sensor_m, exchanged[1].sensor_m);
  std::swap(exchanged[2].tip_m, exchanged[3].tip_m);
  std::swap(exchanged[2].sensor_m, exchanged[3].sensor_m);
  const CornerFit turned = fitCorners(exchanged);
  ASSERT_EQ(turned.faults.size(), 1u);
  EXPECT_NE(turned.faults[0].find("behind the walls"), std::string::npos) << turned.faults[0];
}

// What is printed for a rig, read as a rig, is what was found: whatever the turn and the unit.
TEST(Calibration, ItsLinesMeanWhatItFound) {
  std::mt19937_64 random(9);
  std::normal_distribution<double> one;
  for (int i = 0; i < 300; ++i) {
    const double w = one(random), x = one(random), y = one(random), z = one(random);
    glm::dquat q = glm::normalize(glm::dquat(w, x, y, z));
    // Some with their x along z, where two of the turns are one.
    if (i % 3 == 0)
      q = glm::angleAxis(one(random), glm::dvec3(1, 0, 0)) *
          glm::angleAxis(glm::radians(i % 2 == 0 ? 90.0 : -90.0), glm::dvec3(0, 1, 0));
    const Pose pose{{3.0 * one(random), 3.0 * one(random), 3.0 * one(random)}, q};
    const std::string unit = i % 2 == 0 ? "m" : "mm";
    const std::string line = poseLine("room_from_tracker", pose, i % 2 == 0 ? 1.0 : 1e-3);
    const Rig rig = readRig("rig.toml", calibratedRig(line, "", unit));
    const Pose& read = rig.trackers[0].roomFromTracker;
    EXPECT_LT(glm::distance(read.position_m, pose.position_m), 1e-5) << line;  // 0.005 mm a coordinate
    EXPECT_LT(turnBetween_deg(read.orientation, pose.orientation), 0.002) << line;
  }
}

TEST(Calibration, SaysWhereTheAxesPoint) {
  const RoomAxes axes;
  EXPECT_EQ(directionWords({1, 0, 0, 0}, axes),
            "x to the right (0.0 degrees off), y up (0.0 degrees off), z back (0.0 degrees off)");
  const glm::dquat zUp = glm::angleAxis(glm::radians(-88.0), glm::dvec3(1, 0, 0));
  EXPECT_EQ(directionWords(zUp, axes),
            "x to the right (0.0 degrees off), y ahead (2.0 degrees off), z up (2.0 degrees off)");
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
