// Rooms of ParaView: a whole file, and faults with their places.
#include "app/room_import/pvx_file.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <tuple>
#include <vector>

#include "app/import_faults.h"
#include "app/room_checks/room_check.h"
#include "app/room_import/pvx_text.h"
#include "places.h"

namespace carom {
namespace {

namespace pvx = test::pvx;
using test::pvx::changed;
using test::pvx::kFloor;
using test::pvx::kGood;
using test::pvx::machine;
using test::pvx::PvxFaults;
using Fault = test::ImportFault;

TEST(PvxFile, ReadsAWall) {
  const Room room =
      pvx::read(machine(kFloor + " StereoType='Crystal Eyes' FullScreen='1' Environment='DISPLAY=:0.4'"));
  EXPECT_TRUE(room.findings.empty()) << room.findings[0].text;
  ASSERT_EQ(room.walls.size(), 1u);
  const Wall& wall = room.walls[0].wall;
  EXPECT_EQ(wall.name, "Floor");
  EXPECT_EQ(wall.pixels, glm::ivec2(640, 360));
  EXPECT_EQ(wall.window.position_px, glm::ivec2(740, 1560));
  EXPECT_TRUE(wall.window.fullscreen);
  EXPECT_EQ(wall.stereo, StereoMode::quadBuffer);
  EXPECT_EQ(wall.lowerLeft_m, glm::dvec3(-1.13, -0.635, 0.05));
  EXPECT_EQ(wall.upperLeft_m, glm::dvec3(-1.13, -0.635, -1.22));
  ASSERT_EQ(room.nodes.size(), 1u);
  EXPECT_EQ(room.nodes[0].display, ":0.4");
  EXPECT_EQ(room.eyeSeparation_m, 0.065);
}

TEST(PvxFile, RanksAreThePlacesOfMachines) {
  const std::string one = "<Machine Name='a' LowerLeft='-1 -1 -1' LowerRight='1 -1 -1' UpperRight='1 1 -1'/>";
  const Room room =
      pvx::read("<pvx><Process Type='client'/><Process Type='server'>\n<EyeSeparation Value='0.06'/>" + one +
                one + "</Process></pvx>");
  ASSERT_EQ(room.walls.size(), 2u);
  EXPECT_EQ(room.walls[0].wall.node, 0);
  EXPECT_EQ(room.walls[1].wall.node, 1);
  EXPECT_EQ(room.walls[1].wall.name, "a-2") << "names of a rig are unique";
  EXPECT_EQ(room.eyeSeparation_m, 0.06);
}

TEST_P(PvxFaults, ArePlacedAndExplained) { test::expectFound(GetParam(), pvx::read(GetParam().text)); }

INSTANTIATE_TEST_SUITE_P(
    All, PvxFaults,
    ::testing::Values(
        Fault{"geometry", changed(kGood, "640x360+740+1560", "640x360"), 2, 33, {"WIDTHxHEIGHT+X+Y"}},
        Fault{"geometry with junk", changed(kGood, "+1560", "+1560px"), 2, 33, {"640x360+740+1560px"}},
        Fault{"no pixels", changed(kGood, "640x360", "0x360"), 2, 33, {"0x360"}},
        Fault{"eyes with junk",
              changed(kGood, "<pvx>", "<pvx><EyeSeparation Value='0.065m'/>"),
              1,
              28,
              {"'0.065m'"}},
        Fault{"viewer", changed(kGood, "Name=", "ViewerId='1/' Name="), 2, 20, {"'1/'"}},
        Fault{"second viewer", changed(kGood, "Name=", "ViewerId='1' Name="), 2, 20, {"viewer 1"}, false},
        Fault{"no machine", "<pvx>\n</pvx>", 1, 1, {"<Machine>"}},
        Fault{"another root", "<scene/>", 1, 1, {"<scene>", "<pvx>"}},
        Fault{"unknown key", changed(kGood, "Name=", "IgnoredKey='x' Name="), 2, 10, {"'IgnoredKey'"}, false},
        Fault{"misspelt key",
              changed(kGood, "Geometry=", "Geomtry='1x1+0+0' Geometry="),
              2,
              23,
              {"'Geomtry'", "'Geometry'?"},
              false},
        Fault{"unknown element", changed(kGood, "<pvx>", "<pvx><Wall/>"), 1, 6, {"'Wall'"}, false},
        Fault{"stereo",
              changed(kGood, "Name=", "StereoType='LineInterlaced' Name="),
              2,
              22,
              {"'LineInterlaced'", "'Interlaced'"},
              false}),
    test::nameOfFault);

TEST(PvxFile, RefusesWhatIsNoXml) {
  const std::vector<std::tuple<std::string, int, int>> files{
      {"<pvx>\n  <Machine Name=Left/>\n</pvx>", 2, 17},
      {"<pvx>\n<Machine Name='a' Name='b'/></pvx>", 2, 19},
      {"<!DOCTYPE pvx [<!ENTITY a 'aaaa'>]>\n<pvx>&a;</pvx>", 1, 15},
      {"", 1, 1},
      {"<pvx>", 1, 6}};
  for (const auto& [text, line, column] : files) {
    try {
      pvx::read(text);
      ADD_FAILURE() << "was taken: " << text;
    } catch (const InputErrors& error) {
      EXPECT_EQ(error.line(), line) << text << ": " << error.what();
      EXPECT_EQ(error.column(), column) << text << ": " << error.what();
    }
  }
  std::string deep;
  for (int i = 0; i < 10000; ++i) deep += "<pvx>";
  EXPECT_THROW(pvx::read(deep), InputErrors);
}

TEST(PvxFile, OddRoomsAreJudged) {
  // Halves of a floor with pixels of 840 x 1050 px/m, one of them through the viewer's eyes.
  const Room room = pvx::read(
      "<pvx>\n"
      "<Machine Name='FloorTop' Geometry='2560x1600+0+0' LowerLeft='-1.524 -1.524 0'\n"
      "  LowerRight='1.524 -1.524 0' UpperRight='1.524 -1.524 -1.524'/>\n"
      "<Machine Name='Front2' Geometry='2560x1812+0+0' LowerLeft='-1 -1 1'\n"
      "  LowerRight='1 -1 -1' UpperRight='1 1 -1'/>\n"
      "</pvx>");
  const std::vector<Finding> findings = judgeRoom(room);
  ASSERT_EQ(findings.size(), 2u);
  EXPECT_EQ(findings[0].at.line, 2);
  EXPECT_EQ(findings[0].at.column, 36);
  EXPECT_NE(findings[0].text.find("839.9 px/m across, 1049.9 px/m up"), std::string::npos)
      << findings[0].text;
  EXPECT_EQ(findings[1].at.line, 4);
  EXPECT_NE(findings[1].text.find("in the plane of wall 'Front2'"), std::string::npos) << findings[1].text;
}

TEST(PvxFile, ShippedExamplesOfParaViewAreJudgedRightly) {
  const std::filesystem::path rooms = CAROM_TESTS_DIR "/data/rooms";
  const Room typo = readPvx(rooms / "ParaView__Examples__left_right_floor.pvx");
  ASSERT_EQ(typo.findings.size(), 1u);
  EXPECT_EQ(typo.findings[0].at.line, 25);
  EXPECT_EQ(typo.findings[0].at.column, 30);
  for (const char* words : {"'0/05'", "0.05", "50 mm", "27 mm"}) {
    EXPECT_NE(typo.findings[0].text.find(words), std::string::npos) << typo.findings[0].text;
  }
  EXPECT_TRUE(typo.hasErrors());
  EXPECT_FALSE(readPvx(rooms / "ParaView__Examples__trivial.pvx").hasErrors());
}

}  // namespace
}  // namespace carom
