// `carom calibrate`: its lines, put into the rig, and what it says of wrong arguments and recordings.

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "app/program.h"
#include "app/simulated_calibration.h"

namespace carom {
namespace {

using test::calibratedRig;
using test::CalibratingPerson;
using test::placesOf;
using test::runCarom;
using test::SimulatedRoom;
using test::TemporaryFolder;

/// The lines behind a comment, up to the next comment or the end.
std::string linesBehind(const std::string& comment, const std::string& text) {
  const std::size_t at = text.find("\n# " + comment);
  if (at == std::string::npos) return {};
  const std::size_t begin = text.find('\n', at + 1) + 1;
  return text.substr(begin, text.find("\n#", begin) - begin) + "\n";
}

TEST(Calibrate, ItsLinesInTheRigAreTheTruth) {
  const TemporaryFolder folder;
  for (const std::string unit : {"m", "mm"}) {
    const auto rig = folder.file("rig.toml", calibratedRig("", "", unit));
    const auto corners = cornersOf(readRig(rig));
    const auto targets =
        chosenCorners(corners, "front.upper_left,front.upper_right,front.lower_left,front.lower_right");
    const glm::dvec3 mark_m(-0.1, 1.45, 0.1);
    SimulatedRoom room;
    room.seed = 11;
    CalibratingPerson person(room);
    person.pivot(folder / "");
    auto places_m = placesOf(corners);
    places_m.push_back(mark_m);
    person.touch(folder / "", places_m);
    person.sight(folder / "", mark_m, placesOf(targets));
    const auto result = runCarom(folder, {"calibrate", rig, "--from", folder / "", "--pivot", "--sight"});
    ASSERT_EQ(result.status, 0) << result.err << result.out;
    EXPECT_EQ(result.err, "");
    std::string text =
        calibratedRig(linesBehind("[[tracker]] art", result.out), linesBehind("[head]", result.out), unit);
    text.insert(text.find("[[tracker]]"), linesBehind("[hand]", result.out));
    const Rig read = readRig("rig.toml", text);
    const Pose& found = read.trackers[0].roomFromTracker;
    for (const glm::dvec3& place_m : placesOf(corners)) {
      EXPECT_LT(glm::distance(found * (inverse(room.roomFromTracker) * place_m), place_m), 0.001);
    }
    EXPECT_LT(test::turnBetween_deg(found.orientation, room.roomFromTracker.orientation), 0.1);
    EXPECT_LT(glm::length(read.viewers.front().hand->handFromSensor * room.tip_m), 0.001);
    EXPECT_NEAR(read.viewers.front().head.eyeSeparation_m, room.eyeSeparation_m, 0.003);
    const glm::dvec3 nose_m(0.0);
    EXPECT_LT(glm::distance(inverse(read.viewers.front().head.eyesFromSensor) * nose_m,
                            inverse(room.eyesFromSensor) * nose_m),
              0.003);
  }
}

TEST(Calibrate, AFaultLeavesNoLine) {
  const TemporaryFolder folder;
  const auto rig = folder.file("rig.toml", calibratedRig());
  SimulatedRoom room;
  room.tip_m = glm::dvec3(0.0);
  auto places_m = placesOf(cornersOf(readRig(rig)));
  std::swap(places_m[0], places_m[1]);
  CalibratingPerson(room).touch(folder / "", places_m);
  const auto result = runCarom(folder, {"calibrate", rig, "--from", folder / ""});
  EXPECT_EQ(result.status, 1);
  EXPECT_NE(result.err.find("error: the corners miss their places"), std::string::npos) << result.err;
  EXPECT_NE(result.err.find("front.lower_right where front.lower_left was asked for"), std::string::npos);
  EXPECT_NE(result.out.find("front.lower_left"), std::string::npos);  // the table helps to find it
  EXPECT_EQ(result.out.find("room_from_tracker"), std::string::npos) << result.out;
}

TEST(Calibrate, WrongInputIsNamed) {
  const TemporaryFolder folder;
  const auto rig = folder.file("rig.toml", calibratedRig());
  const auto says = [&](const std::vector<std::string>& arguments, const std::string& words, int status = 1) {
    std::vector<std::string> all{"calibrate", rig};
    all.insert(all.end(), arguments.begin(), arguments.end());
    const auto result = runCarom(folder, all);
    EXPECT_EQ(result.status, status) << words;
    EXPECT_NE(result.err.find(words), std::string::npos) << words << " in " << result.err;
    EXPECT_EQ(result.out.find("room_from_tracker"), std::string::npos);
  };
  says({"--from", folder / ""}, "corners.csv:1:1: there is no such file, expected a trace");
  says({"--from", folder / "", "--pivot"}, "pivot.csv:1:1: there is no such file");
  says({"--from", folder / "", "--corners", "front.top"},
       "'front.top' is no corner of this rig, expected one of "
       "front.lower_left, front.lower_right");
  says({"--from", folder / "", "--sight", "--targets", "roof.lower_left"}, "'roof.lower_left' is no corner");
  says({"--from", folder / "", "--record", folder / "new"}, "--from excludes --record", 2);
  says({"--tool", "foot"}, "--tool", 2);
  folder.file("corners.csv", "time_s,x_m,y_m,z_m\n0,1,2,nonsense\n");
  says({"--from", folder / ""}, "corners.csv:2:7: z_m");
  // A trace without orientation can tell the corners, but neither the tip nor the eyes.
  folder.file("pivot.csv", "time_s,x_m,y_m,z_m\n0,1,2,3\n");
  folder.file("corners.csv", "time_s,x_m,y_m,z_m\n0,1,2,3\n");
  says({"--from", folder / "", "--pivot"}, "the sensor was at rest 0 times");
  const auto handless = calibratedRig();
  const std::size_t hand = handless.find("[hand]");
  folder.file("rig.toml", handless.substr(0, hand) + handless.substr(handless.find("[[tracker]]")));
  says({"--tool", "hand"}, "the rig has no [hand] to touch corners with");
}

}  // namespace
}  // namespace carom
