// Corners touched in a simulated room: the tracker is found, and every usual mistake is named.
#include "app/calibration/corner_fit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <string>
#include <utility>
#include <vector>

#include "app/calibration/touched_corners.h"
#include "app/simulated_calibration.h"

namespace carom {
namespace {

using test::corners_m;
using test::faultsOf;
using test::SimulatedRoom;
using test::theRig;
using test::touchesIn;
using test::turnBetween_deg;

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

}  // namespace
}  // namespace carom
