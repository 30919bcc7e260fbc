// A whole rig file: its unit, its axes, what may be left out, and the shipped ones.
#include "app/rig/rig.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <glm/geometric.hpp>
#include <string>
#include <utility>
#include <vector>

#include "app/rig/rig_text.h"
#include "app/toml/input_file.h"
#include "places.h"

namespace carom {
namespace {

using test::changed;
using test::expectNear;
using test::Fault;
using test::kGood;
using test::kRounding_m;
using test::read;
using test::RigFaults;

TEST(Rig, ReadsLengthsInEveryUnit) {
  const std::vector<std::pair<std::string, double>> units{
      {"m", 1.0}, {"mm", 1e-3}, {"cm", 1e-2}, {"in", 0.0254}, {"ft", 0.3048}};
  for (const auto& [unit, metres] : units) {
    const Rig rig =
        read("unit = '" + unit +
             "'\naxes = 'x-right y-up z-back'\n[head]\ntracker = 'a'\neyes_from_sensor = { translation = [0, "
             "1, 0] }\n"
             "[[tracker]]\nname = 'a'\nkind = 'simulated'\nroom_from_tracker = { translation = [1, 0, 0] }\n"
             "[[wall]]\nname = 'w'\nlower_left = [0, 0, 0]\nlower_right = [4, 0, 0]\nupper_left = [0, 3, 0]\n"
             "pixels = [4, 3]\n");
    expectNear(rig.walls.at(0).lowerRight_m, {4 * metres, 0, 0});
    expectNear(rig.walls.at(0).upperLeft_m, {0, 3 * metres, 0});
    expectNear(rig.viewers.front().head.eyesFromSensor.position_m, {0, metres, 0});
    expectNear(rig.trackers.at(0).roomFromTracker.position_m, {metres, 0, 0});
    EXPECT_NEAR(rig.viewers.front().head.eyeSeparation_m, 0.064, kRounding_m)
        << "the default is in metres whatever the unit";
  }
}

TEST(Rig, KeepsItsAxesAndNamesTheirDirections) {
  for (const char* axes : {"x-right y-up z-back", "x-right y-forward z-up"}) {
    const RoomAxes room = read(changed("x-right y-up z-back", axes)).axes;
    expectNear(glm::cross(room.right, room.forward), room.up);
  }
  expectNear(read(kGood).axes.up, {0, 1, 0});
  expectNear(read(changed("x-right y-up z-back", "x-right y-forward z-up")).axes.forward, {0, 1, 0});
}

TEST(Rig, TurnsAboutXThenYThenZ) {
  const Pose pose = read(changed("eye_separation = 62", "eyes_from_sensor = { rotation_deg = [90, 0, 90] }"))
                        .viewers.front()
                        .head.eyesFromSensor;
  expectNear(pose * glm::dvec3(0, 1, 0), {0, 0, 1});  // x takes y to z, which z leaves
  expectNear(pose * glm::dvec3(0, 0, 1), {1, 0, 0});  // x takes z to −y, z takes that to x
}

TEST(Rig, TheConsoleHasAPlace) {
  const Rig rig = read(std::string(kGood) +
                       "\n[console]\nwindow = { monitor = 1, position = [10, 20], size = [800, 600] }\n");
  const WindowPlacement expected{
      .monitor = 1, .position_px = {10, 20}, .size_px = {800, 600}, .border = true};
  EXPECT_EQ(rig.console, expected);
  EXPECT_FALSE(read(kGood).console);
}

TEST(Rig, LeavesOutWhatIsOptional) {
  const Rig rig = read(kGood);
  EXPECT_EQ(rig.display_hz, 60.0);
  EXPECT_NEAR(rig.viewers.front().head.eyeSeparation_m, 0.062, kRounding_m);
  EXPECT_FALSE(rig.viewers.front().hand);
  EXPECT_FALSE(rig.oneWindow);
  EXPECT_TRUE(rig.nodes.empty());
  EXPECT_EQ(rig.walls.at(0).stereo, StereoMode::mono);
  EXPECT_EQ(rig.walls[0].window.size_px, glm::ivec2(1920, 1280));
  EXPECT_EQ(rig.displayLatency_s, 0.0);
  EXPECT_EQ(rig.frameLock, FrameLock::software);
}

TEST(Rig, MayAskTheGraphicsCardsForTheFrameLock) {
  EXPECT_EQ(read("frame_lock = 'swap-group'\n" + kGood).frameLock, FrameLock::swapGroup);
  EXPECT_EQ(read("frame_lock = 'software'\n" + kGood).frameLock, FrameLock::software);
  EXPECT_THROW(read("frame_lock = 'genlock'\n" + kGood), InputErrors);
}

TEST(Rig, EveryShippedFileIsRight) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(CAROM_CONFIG_DIR "/rigs")) {
    SCOPED_TRACE(entry.path());
    EXPECT_NO_THROW(readRig(entry.path()));
    ++count;
  }
  EXPECT_GE(count, 3);
}

TEST_P(RigFaults, ArePlacedAndExplained) { test::expectExplained(GetParam(), read); }

INSTANTIATE_TEST_SUITE_P(
    Files, RigFaults,
    ::testing::Values(Fault{"unit", changed("'mm'", "'furlong'"), 1, 8, "'mm' or 'cm'"},
                      Fault{"axes", changed("z-back", "z-front"), 2, 8, "x-right y-forward z-up"},
                      Fault{"number with junk", changed("[1500, 0, -1500]", "[1500, 0/05, -1500]"), 12, 23,
                            "expected digit"},
                      Fault{"no walls", kGood.substr(0, kGood.find("[[wall]]")), 1, 1, "[[wall]]"}),
    test::nameOfFault);

}  // namespace
}  // namespace carom
