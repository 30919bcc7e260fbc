#include "app/file_tools/import.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <variant>

#include "app/program.h"
#include "app/room_checks/rig_room.h"
#include "app/room_checks/room_check.h"
#include "cave/screen/curved_screen.h"
#include "places.h"

namespace carom {
namespace {

using test::contentOf;
using test::runCarom;
using test::TemporaryFolder;

// Coordinates are written to a thousandth of a millimetre.
constexpr double kWritten_m = 0.6e-6;

const std::string kCorner =
    "<pvx>\n<EyeSeparation Value='0.063'/>\n"
    "<Machine Name='Front' Geometry='1000x1000+0+0' Environment='DISPLAY=:0' StereoType='Crystal Eyes'\n"
    "  LowerLeft='-1.5 -1.6 -1.5' LowerRight='1.5 -1.6 -1.5' UpperRight='1.5 1.4 -1.5'/>\n"
    "<Machine Name='the floor' Geometry='1000x1000+1000+0' Environment='DISPLAY=:0'\n"
    "  LowerLeft='-1.5 -1.6 1.5' LowerRight='1.5 -1.6 1.5' UpperRight='1.5 -1.6 -1.5'/>\n</pvx>\n";

TEST(Import, MakesARigThatChecksClean) {
  const TemporaryFolder folder;
  const std::string file = folder.file("corner.pvx", kCorner), rig = folder / "corner.toml";
  const auto made = runCarom(folder, {"import", file, "-o", rig});
  ASSERT_EQ(made.status, 0) << made.err;
  EXPECT_EQ(made.err.find("warning"), std::string::npos) << made.err;
  const PlacedRig placed = readPlacedRig(rig);
  ASSERT_EQ(placed.rig.walls.size(), 2u);
  EXPECT_EQ(placed.rig.walls[1].name, "the-floor");
  EXPECT_EQ(placed.rig.walls[1].node, 1);
  EXPECT_EQ(placed.rig.walls[0].stereo, StereoMode::quadBuffer);
  EXPECT_EQ(placed.rig.viewers.front().head.eyeSeparation_m, 0.063);
  // The floor has come up to zero, the walls with it, and the viewer's eyes are where they were before them.
  EXPECT_NEAR(glm::distance(placed.rig.walls[0].lowerLeft_m, {-1.5, 0.0, -1.5}), 0.0, kWritten_m);
  EXPECT_NEAR(glm::distance(placed.rig.walls[0].upperLeft_m, {-1.5, 3.0, -1.5}), 0.0, kWritten_m);
  EXPECT_NEAR(glm::distance(roomOf(placed, rig).viewers.front().eyes_m, {0.0, 1.6, 0.0}), 0.0, kWritten_m);
  EXPECT_TRUE(placed.rig.nodes.empty()) << "one display for all is no difference";
  const auto checked = runCarom(folder, {"check", rig});
  EXPECT_EQ(checked.status, 0) << checked.err;
  EXPECT_EQ(checked.err, "");
}

TEST(Import, StatesWhatItAssumed) {
  const TemporaryFolder folder;
  const std::string file = folder.file("corner.pvx", kCorner), rig = folder / "corner.toml";
  const auto made = runCarom(folder, {"import", file, "-o", rig});
  for (const char* words :
       {"metres", "axes", "tracker", "mono", "rank", "moved by [0.0, 1.6, 0.0] m", "60 Hz"}) {
    EXPECT_NE(made.err.find(words), std::string::npos) << words << '\n' << made.err;
    EXPECT_NE(contentOf(rig).find(words), std::string::npos) << words << '\n' << contentOf(rig);
  }
}

TEST(Import, KeepsDisplaysThatTellRanksApart) {
  const TemporaryFolder folder;
  std::string text = kCorner;
  text.replace(text.rfind(":0"), 2, ":0.1");
  const std::string file = folder.file("corner.pvx", text), rig = folder / "corner.toml";
  ASSERT_EQ(runCarom(folder, {"import", file, "-o", rig}).status, 0);
  const Rig read = readRig(rig);
  ASSERT_EQ(read.nodes.size(), 2u);
  EXPECT_EQ(read.nodes[1].display, ":0.1");
}

TEST(Import, WritesNothingWhereThereIsAnError) {
  const TemporaryFolder folder;
  std::string text = kCorner;
  text.replace(text.find("1.5 -1.6 1.5'"), 12, "1.5 -1/6 1.5");
  const std::string file = folder.file("corner.pvx", text);
  const auto made = runCarom(folder, {"import", file, "-o", folder / "corner.toml"});
  EXPECT_EQ(made.status, 1);
  EXPECT_EQ(made.err.rfind("error: " + file + ":6:", 0), 0u) << made.err;
  EXPECT_EQ(folder.entries(), 1);
}

TEST(Import, WritesOverNothing) {
  const TemporaryFolder folder;
  const std::string file = folder.file("corner.pvx", kCorner), rig = folder.file("corner.toml", "mine");
  const auto made = runCarom(folder, {"import", file, "-o", rig});
  EXPECT_EQ(made.status, 1);
  EXPECT_NE(made.err.find("is there already"), std::string::npos) << made.err;
  EXPECT_EQ(contentOf(rig), "mine");
}

TEST(Import, RefusesWhatIsNoRoomOrNoRig) {
  const TemporaryFolder folder;
  const std::string other = folder.file("room.toml", "unit = 'm'\n");
  EXPECT_NE(runCarom(folder, {"import", other, "-o", folder / "a.toml"}).err.find(".pvx"), std::string::npos);
  EXPECT_EQ(runCarom(folder, {"import", other}).status, 2);
  // Eyes further apart than a rig takes.
  std::string text = kCorner;
  const std::string wide = folder.file("wide.pvx", text.replace(text.find("0.063"), 5, "6.3"));
  const auto made = runCarom(folder, {"import", wide, "-o", folder / "a.toml"});
  EXPECT_EQ(made.status, 1);
  EXPECT_NE(made.err.find("eye_separation"), std::string::npos) << made.err;
  EXPECT_EQ(folder.entries(), 2);
}

TEST(Import, FourRoomsOfOtherPrograms) {
  const std::filesystem::path rooms = CAROM_TESTS_DIR "/data/rooms";
  const TemporaryFolder folder;
  const std::string typo = rooms / "ParaView__Examples__left_right_floor.pvx";
  const auto refused = runCarom(folder, {"import", typo, "-o", folder / "typo.toml"});
  EXPECT_EQ(refused.status, 1);
  EXPECT_NE(refused.err.find("error: " + typo + ":25:30: '0/05'"), std::string::npos) << refused.err;
  EXPECT_NE(refused.err.find("50 mm"), std::string::npos) << refused.err;
  for (const char* name :
       {"ParaView__Examples__trivial.pvx", "sgct-docs__projectionplane.json", "sgct__config__3DTV.json"}) {
    const std::string rig = folder / (std::string(name) + ".toml");
    EXPECT_EQ(runCarom(folder, {"import", rooms / name, "-o", rig}).status, 0) << name;
    const auto checked = runCarom(folder, {"check", rig});
    EXPECT_EQ(checked.status, 0) << name << checked.err;
    EXPECT_EQ(checked.err, "") << name;
  }
}

const std::filesystem::path kOthers = CAROM_TESTS_DIR "/fuzz/fuzz_rooms";

TEST(Import, RoomsOfEachProgramBecomeRigsThatPass) {
  const TemporaryFolder folder;
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kOthers)) {
    const std::string rig = folder / (entry.path().filename().string() + ".toml");
    const auto made = runCarom(folder, {"import", entry.path().string(), "-o", rig});
    EXPECT_EQ(made.status, 0) << entry.path() << made.err;
    const auto checked = runCarom(folder, {"check", rig});
    EXPECT_EQ(checked.status, 0) << entry.path() << checked.err;
    ++count;
  }
  EXPECT_GE(count, 13);
}

TEST(Import, CurvedDisplaysAreScreensOfTheRig) {
  const TemporaryFolder folder;
  const std::string rig = folder / "round.toml";
  // A floor 0.4 m below the origin, onto which all moves.
  std::string text = contentOf(kOthers / "hevs_curved.json");
  const auto put = [&](const std::string& before, const std::string& more) {
    text.insert(text.find(before), more);
  };
  put("\"left\", \"right\"]", "\"floor\", ");
  put("\"left\": {",
      R"("floor": {"type": "offaxis", "ul": [-1, -0.4, 1], "ll": [-1, -0.4, -1], "lr": [1, -0.4, -1]}, )");
  const auto made = runCarom(folder, {"import", folder.file("round.json", text), "-o", rig});
  ASSERT_EQ(made.status, 0) << made.err;
  const Rig read = readRig(rig);
  ASSERT_EQ(read.walls.size(), 4u);
  const auto& left = std::get<CylinderScreen>(read.walls[1].screen->shape);
  EXPECT_NEAR(left.foot_m.y, 0.4, kWritten_m);
  EXPECT_NEAR(glm::distance(placeOn_m(left, {1, 1}), {0, 3.3, -4.25}), 0.0, kWritten_m);
  const auto& dome = std::get<DomeScreen>(read.walls[3].screen->shape);
  EXPECT_NEAR(glm::distance(dome.centre_m, {0, 1.4, 0}), 0.0, kWritten_m);
  // Its axis is 60° above the horizon, 30° to the right of ahead.
  EXPECT_NEAR(glm::distance(dome.axis, {0.25, std::sqrt(0.75), -std::sqrt(0.1875)}), 0.0, kWritten_m);
  EXPECT_NE(contentOf(rig).find("# - the file gives no height of the foot of the curved display 'left'"),
            std::string::npos)
      << contentOf(rig);
}

TEST(Import, SharedMemoryKeepsItsUnit) {
  const TemporaryFolder folder;
  const std::string rig = folder / "memory.toml";
  const auto made = runCarom(folder, {"import", kOthers / "cluster.jconf", "-o", rig});
  ASSERT_EQ(made.status, 0) << made.err;
  const Rig read = readRig(rig);
  ASSERT_EQ(read.trackers.size(), 1u);
  EXPECT_EQ(read.trackers[0].source, "shm://4126?wand=4127");
  EXPECT_EQ(read.trackers[0].unit_m, 0.3048);
  EXPECT_NEAR(read.trackers[0].roomFromTracker.position_m.z, -1.0, kWritten_m);
  EXPECT_EQ(read.viewers[0].hand->sensor, 1);
}

TEST(Import, KeepsTheUnitAxesHostsAndTrackersOfTheFile) {
  const TemporaryFolder folder;
  const std::string rig = folder / "cover.toml";
  const auto made = runCarom(folder, {"import", kOthers / "cover.xml", "-o", rig});
  ASSERT_EQ(made.status, 0) << made.err;
  const std::string text = contentOf(rig);
  EXPECT_NE(text.find("unit = \"mm\"\naxes = \"x-right y-forward z-up\""), std::string::npos) << text;
  EXPECT_NE(text.find("everything is moved by [0.0, 0.0, 1500.0] mm"), std::string::npos) << text;
  EXPECT_NE(text.find("# - line 9: screen 'SPARE' of computer 's1' is left out"), std::string::npos) << text;
  const Rig read = readRig(rig);
  ASSERT_EQ(read.walls.size(), 4u);
  EXPECT_NEAR(glm::distance(read.walls[0].lowerLeft_m, {-2.0, -1.5, 0.0}), 0.0, kWritten_m);
  EXPECT_EQ(read.nodes.at(0).host, "s1");
  ASSERT_EQ(read.trackers.size(), 1u);
  EXPECT_EQ(read.trackers[0].kind, TrackerKind::dtrack);
  // With the room, its tracker has come up; the eyes stay where they are on the head.
  EXPECT_NEAR(glm::distance(read.trackers[0].roomFromTracker * glm::dvec3(0.0), {0.01, 0.02, 0.0}), 0.0,
              kWritten_m);
  EXPECT_NEAR(glm::length(read.viewers[0].head.eyesFromSensor * glm::dvec3(0.0, -0.01, -0.1)), 0.0,
              2 * kWritten_m);
  EXPECT_EQ(read.viewers[0].hand->sensor, 101);
}

TEST(Import, PeopleBecomeViewersWithTheirEyes) {
  const TemporaryFolder folder;
  const std::string rig = folder / "two.toml";
  const auto made = runCarom(folder, {"import", kOthers / "blender.xml", "-o", rig});
  ASSERT_EQ(made.status, 0) << made.err;
  const Rig read = readRig(rig);
  ASSERT_EQ(read.viewers.size(), 2u);
  EXPECT_EQ(read.viewers[1].name, "user-B");
  EXPECT_EQ(read.viewers[1].head.sensor.sensor, 4);
  EXPECT_EQ(read.trackers.at(read.viewers[0].head.sensor.tracker).kind, TrackerKind::simulated);
  EXPECT_EQ(read.walls.at(1).eyes.at(0), (ViewerEye{1, Eye::middle}));
}

TEST(Import, CutFilesAreRefusedAndLeaveNothing) {
  const TemporaryFolder folder;
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kOthers)) {
    if (entry.path().extension() == ".cfg") continue;  // half of its lines are a file, too
    const std::string whole = contentOf(entry.path());
    const std::string file = folder.file(entry.path().filename().string(), whole.substr(0, whole.size() / 2));
    const auto made = runCarom(folder, {"import", file, "-o", folder / "cut.toml"});
    EXPECT_EQ(made.status, 1) << entry.path();
    EXPECT_EQ(made.err.rfind("error: " + file + ":", 0), 0u) << made.err;
    EXPECT_EQ(folder.entries(), ++files);
  }
}

TEST(Import, OneOfSeveralRoomsIsAskedFor) {
  const TemporaryFolder folder;
  const std::string file = std::filesystem::path(CAROM_TESTS_DIR "/data/rooms/hevs_example_config.json");
  const auto asked = runCarom(folder, {"import", file, "-o", folder / "a.toml"});
  EXPECT_EQ(asked.status, 1);
  EXPECT_NE(asked.err.find("--room with one of 'LocalCluster', 'Anaglyph', 'CAVE', 'EPICylinder'"),
            std::string::npos)
      << asked.err;
  EXPECT_EQ(runCarom(folder, {"import", file, "--room", "CAVE", "-o", folder / "a.toml"}).status, 0);
  EXPECT_EQ(readRig(folder / "a.toml").walls.size(), 4u);
  EXPECT_EQ(runCarom(folder, {"check", file, "--room", "StereoWall"}).status, 0);
}

}  // namespace
}  // namespace carom
