// Rooms of OpenCOVER, as whole files.
#include "app/cave_formats/cover_file.h"

#include <gtest/gtest.h>

#include <string>

#include "app/cave_formats/cover_room.h"
#include "app/room_formats/read_room.h"

namespace carom {
namespace {

namespace cover = test::cover;
using test::allFindings;
using test::expectCorners;
using test::findingWith;
using test::refusalOf;
using test::roomOf;
using test::wallOf;
using test::with;

TEST(CoverFile, RanksGoAsSyncModeHasThem) {
  const Room room = roomOf("room.xml", cover::kCave);
  ASSERT_EQ(room.nodes.size(), 4u);
  EXPECT_EQ(room.nodes[0].host, "s1");
  EXPECT_EQ(room.nodes[3].host, "f2");
  EXPECT_EQ(wallOf(room, "LEFT-left").wall.node, 0);
  EXPECT_EQ(wallOf(room, "LEFT-right").wall.node, 1);
  EXPECT_EQ(wallOf(room, "FRONT-right").wall.node, 3);
}

TEST(CoverFile, NamesByLineWhatItLeavesOut) {
  const Room room = roomOf("room.xml", cover::kCave);
  EXPECT_EQ(findingWith(room, "'SPARE' of computer 's1'").at.line, 9) << allFindings(room);
  EXPECT_EQ(findingWith(room, "'CONTROL' of the master 'boss'").at.line, 11);
  EXPECT_EQ(findingWith(room, "computer 'guest'").at.line, 19);
  EXPECT_EQ(findingWith(room, "'Old'").at.line, 28);
}

TEST(CoverFile, WhatIsNearlyOfARoomIsNamed) {
  const Room room =
      roomOf("room.xml",
             "<COCONFIG>\n<GLOBAL><COVER><ScreenConfig><Screen name='0' p='-90' "
             "comment='F'/></ScreenConfig><FloorHeight value='-900'/>"
             "\n<ChanelConfig><Channel "
             "name='0'/></ChanelConfig><Plugin><ScreenConfg/></Plugin>\n<WindowConfig><Window name='0' "
             "pipeIndex='2'/></WindowConfig></COVER></GLOBAL>\n<LOCAL><COVER/></LOCAL>\n<LOCALE "
             "HOST='a'/>\n</COCONFIG>");
  EXPECT_EQ(findingWith(room, "'ChanelConfig' is left out, expected 'ChannelConfig'?").at.line, 3)
      << allFindings(room);
  EXPECT_EQ(findingWith(room, "FloorHeight -900 is left out: the wall that is the floor is at 0 mm").at.line,
            2)
      << allFindings(room);
  EXPECT_EQ(findingWith(room, "there is no pipe 2").at.line, 4) << allFindings(room);
  EXPECT_EQ(findingWith(room, "this section names no computer").at.line, 5) << allFindings(room);
  EXPECT_EQ(findingWith(room, "'LOCALE' is left out, expected GLOBAL").at.line, 6) << allFindings(room);
  EXPECT_EQ(room.findings.size(), 5u) << allFindings(room);
}

TEST(CoverFile, AMasterAloneHasAWall) {
  const Room room =
      roomOf("room.xml",
             "<COCONFIG><CLUSTER MASTER='a'/><LOCAL HOST='a'><COVER><NumScreens value='0'/><ScreenConfig>"
             "<Screen name='0' comment='ONE'/></ScreenConfig></COVER></LOCAL></COCONFIG>");
  ASSERT_EQ(room.walls.size(), 1u) << allFindings(room);
  expectCorners(room, "ONE", {-1, 0, -0.75}, {1, 0, -0.75}, {-1, 0, 0.75});  // COVER's defaults
  EXPECT_NE(findingWith(room, "NumScreens is 0").at.line, 0);
}

TEST(CoverFile, AFrustumGivesAScreenAtItsRadius) {
  const Room room =
      roomOf("room.xml",
             "<COCONFIG><GLOBAL><COVER><ScreenConfig><Screen name='0' comment='F' radius='1000' "
             "frustum='0;0;500;0;0;0;-45;45;-45;0'/></ScreenConfig></COVER></GLOBAL></COCONFIG>");
  ASSERT_EQ(room.walls.size(), 1u) << allFindings(room);
  expectCorners(room, "F", {-1, 1, -0.5}, {1, 1, -0.5}, {-1, 1, 0.5});
}

TEST(CoverFile, TwoScreensOfOneNameAndPlaceAreTwoEyes) {
  const std::string screen = "comment='W' width='1000' height='1000'/>";
  const Room room =
      roomOf("room.xml", "<COCONFIG><GLOBAL><COVER><ScreenConfig><Screen name='0' " + screen +
                             "<Screen name='1' " + screen + "</ScreenConfig></COVER></GLOBAL></COCONFIG>");
  EXPECT_EQ(wallOf(room, "W-left").wall.stereo, StereoMode::left);
  EXPECT_EQ(wallOf(room, "W-right").wall.stereo, StereoMode::right);
}

TEST(CoverFile, IncludedFilesBesideItAreReadAndOthersNamed) {
  const test::TemporaryFolder folder;
  folder.file("more.xml",
              "<COCONFIG><GLOBAL><COVER><ScreenConfig><Screen name='0' comment='MORE'/></ScreenConfig>"
              "</COVER></GLOBAL></COCONFIG>");
  const Room room = readForeignRoom(folder.file(
      "room.xml",
      "<COCONFIG>\n<INCLUDE global='1'>more.xml </INCLUDE>\n<INCLUDE>../far.xml</INCLUDE>\n</COCONFIG>"));
  ASSERT_EQ(room.walls.size(), 1u) << allFindings(room);
  EXPECT_EQ(room.walls[0].at.wall.line, 2);
  EXPECT_EQ(findingWith(room, "'../far.xml' is not beside").at.line, 3);
}

TEST(CoverFile, AFileThatIncludesItselfIsRefused) {
  EXPECT_NE(refusalOf("room.xml", "<COCONFIG>\n <INCLUDE>room.xml</INCLUDE>\n</COCONFIG>")
                .find("2:2: the file 'room.xml' includes itself"),
            std::string::npos);
}

TEST(CoverFile, FaultsAreNamedAtTheirPlaces) {
  EXPECT_NE(refusalOf("room.xml", with(cover::kCave, "originX=\"-2000\"", "originX=\"-20/00\"")).find("8:"),
            std::string::npos);
  EXPECT_NE(refusalOf("room.xml",
                      with(cover::kCave, "name=\"1\" comment=\"SPARE\"", "name=\"0\" comment=\"SPARE\""))
                .find("9:18: the name '0' is taken in line 8"),
            std::string::npos);
  EXPECT_NE(refusalOf("room.xml", "<COCONFIG/>").find("there is no wall here"), std::string::npos);
  EXPECT_NE(refusalOf("room.xml", with(cover::kCave, "\"F1\"", "\"G1\"")).find("bodyIndex is 'G1'"),
            std::string::npos);
}

}  // namespace
}  // namespace carom
