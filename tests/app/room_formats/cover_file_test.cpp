#include "app/room_formats/cover_file.h"

#include "app/room_formats/read_room.h"

namespace carom {
namespace {

using test::allFindings;
using test::expectCorners;
using test::findingWith;
using test::refusalOf;
using test::roomOf;
using test::wallOf;
using test::with;

/// A room of two walls with a computer for each eye, whose master shows a preview. Later sections win: the
/// width of the side wall and the windows come from the end of the file.
const std::string kCave = R"(<?xml version="1.0"?>
<COCONFIG>
 <LOCAL HOST="f1,f2">
  <COVER><ScreenConfig><Screen name="0" comment="FRONT" width="4000" height="3000" originX="0" originY="2000" originZ="0" h="0" p="0" r="0"/>
  </ScreenConfig></COVER>
 </LOCAL>
 <LOCAL host="s1,s2">
  <COVER><ScreenConfig><Screen name="0" comment="LEFT" width="1" height="3000" originX="-2000" originY="0" originZ="0" h="90" p="0" r="0"/>
   <Screen name="1" comment="SPARE" width="100" height="100"/></ScreenConfig></COVER>
 </LOCAL>
 <LOCAL HOST="boss"><COVER><ScreenConfig><Screen name="0" comment="CONTROL" width="400" height="300" originY="1000"/></ScreenConfig></COVER></LOCAL>
 <LOCAL HOST="f1,s1"><COVER><ChannelConfig><Channel name="0" stereoMode="LEFT"/></ChannelConfig></COVER></LOCAL>
 <LOCAL HOST="f2,s2"><COVER><ChannelConfig><Channel name="0" stereoMode="RIGHT"/></ChannelConfig></COVER></LOCAL>
 <LOCAL HOST="s1,s2">
  <COVER><ScreenConfig><Screen name="0" width="3000"/></ScreenConfig>
   <WindowConfig><Window name="0" left="100" top="20" width="2000" height="1600"/></WindowConfig>
   <ViewportConfig><Viewport name="0" left="200" bottom="100" width="1500" height="1500"/></ViewportConfig></COVER>
 </LOCAL>
 <LOCAL HOST="guest"><COVER><ScreenConfig><Screen name="0"/></ScreenConfig></COVER></LOCAL>
 <CLUSTER MASTER="boss">
  <COVER>
   <FloorHeight value="-1500"/>
   <NumScreens value="1"/>
   <Stereo separation="62"/>
   <MultiPC><SyncMode hosts="s1,s2,f1,f2"/></MultiPC>
   <Input>
    <Device><Art driver="dtrack" port="5001"><Offset x="10" y="20" z="-1500"/><Orientation h="90" p="0" r="0"/></Art>
     <Old driver="flock"/></Device>
    <Body><Head device="Art" bodyIndex="2"><Offset x="0" y="-10" z="-100"/><Orientation h="0" p="-90" r="0"/></Head>
     <Wand device="Art" bodyIndex="F1"/></Body>
    <Persons><Person name="One" head="Head" hand="Wand"/></Persons>
   </Input>
  </COVER>
 </CLUSTER>
</COCONFIG>
)";

TEST(CoverFile, ComputersSeeWhatConcernsThemAndLaterSectionsWin) {
  const Room room = roomOf("room.xml", kCave);
  EXPECT_FALSE(room.hasErrors()) << allFindings(room);
  ASSERT_EQ(room.walls.size(), 4u) << allFindings(room);
  EXPECT_EQ(room.unit, "mm");
  EXPECT_EQ(room.axes.up, glm::dvec3(0, 0, 1));
  expectCorners(room, "FRONT-left", {-2, 2, -1.5}, {2, 2, -1.5}, {-2, 2, 1.5});
  expectCorners(room, "FRONT-right", {-2, 2, -1.5}, {2, 2, -1.5}, {-2, 2, 1.5});
  // Turned to the left: its right edge is ahead.
  expectCorners(room, "LEFT-left", {-2, -1.5, -1.5}, {-2, 1.5, -1.5}, {-2, -1.5, 1.5});
  EXPECT_EQ(room.eyeSeparation_m, 0.062);
}

TEST(CoverFile, RanksGoAsSyncModeHasThem) {
  const Room room = roomOf("room.xml", kCave);
  ASSERT_EQ(room.nodes.size(), 4u);
  EXPECT_EQ(room.nodes[0].host, "s1");
  EXPECT_EQ(room.nodes[3].host, "f2");
  EXPECT_EQ(wallOf(room, "LEFT-left").wall.node, 0);
  EXPECT_EQ(wallOf(room, "LEFT-right").wall.node, 1);
  EXPECT_EQ(wallOf(room, "FRONT-right").wall.node, 3);
}

TEST(CoverFile, ViewportsCountFromTheLowerLeftOfTheirWindow) {
  const Room room = roomOf("room.xml", kCave);
  const Wall& wall = wallOf(room, "LEFT-left").wall;
  EXPECT_EQ(wall.pixels, glm::ivec2(1500, 1500));
  EXPECT_EQ(wall.window.position_px, glm::ivec2(100, 20));
  EXPECT_EQ(wall.window.size_px, glm::ivec2(2000, 1600));
  ASSERT_TRUE(wall.viewport);
  EXPECT_EQ(wall.viewport->position_px, glm::ivec2(200, 0));
}

TEST(CoverFile, TrackersBodiesAndPersonsAreTakenOver) {
  const Room room = roomOf("room.xml", kCave);
  ASSERT_EQ(room.trackers.size(), 1u);
  EXPECT_EQ(room.trackers[0].source, "udp://0.0.0.0:5001");
  const Pose& tracker = room.trackers[0].roomFromTracker;
  EXPECT_LT(glm::distance(tracker.position_m, {0.01, 0.02, -1.5}), 1e-12);
  EXPECT_LT(glm::distance(tracker.orientation * glm::dvec3(1, 0, 0), {0, 1, 0}), 1e-12);
  const ViewerSetup& viewer = room.people.front().setup;
  EXPECT_TRUE(room.people.front().isTracked);
  EXPECT_EQ(viewer.head.sensor.sensor, 2);
  // The eyes are at the body's offset in the sensor's axes.
  EXPECT_LT(glm::length(viewer.head.eyesFromSensor * glm::dvec3(0, -0.01, -0.1)), 1e-12);
  ASSERT_TRUE(viewer.hand);
  EXPECT_EQ(viewer.hand->sensor, 101);
}

TEST(CoverFile, ChannelsTakeScreensAndViewportsOfTheirNumbers) {
  // Names count, not the order in the file; numbers of a viewport above 1 are pixels, others shares.
  const Room room = roomOf(
      "room.xml",
      "<COCONFIG><GLOBAL><COVER><StereoMode value='ANAGLYPHIC'/><ScreenConfig>"
      "<Screen name='2' comment='DARK' render='off'/><Screen name='1' comment='B' originX='4000'/><Screen "
      "name='0' "
      "comment='A'/></ScreenConfig><ChannelConfig><Channel name='1' stereoMode='RIGHT'/><Channel "
      "name='0'/><Channel "
      "name='2'/></ChannelConfig><ViewportConfig><Viewport name='1' windowIndex='0' left='0.5' bottom='100' "
      "width='0.5' top='700'/><Viewport name='0' windowIndex='0' "
      "width='500'/></ViewportConfig><WindowConfig><Window "
      "name='0' width='1000' height='800'/></WindowConfig></COVER></GLOBAL></COCONFIG>");
  ASSERT_EQ(room.walls.size(), 2u) << allFindings(room);
  const Wall &a = wallOf(room, "A").wall, &b = wallOf(room, "B-right").wall;
  EXPECT_EQ(a.viewport->position_px, glm::ivec2(0, 0));
  EXPECT_EQ(a.pixels, glm::ivec2(500, 800));
  EXPECT_EQ(a.stereo, StereoMode::anaglyph) << "that of the computer";
  EXPECT_EQ(b.viewport->position_px, glm::ivec2(500, 100));
  EXPECT_EQ(b.pixels, glm::ivec2(500, 600));
  EXPECT_NE(findingWith(room, "screen 'DARK' of computer '' is left out: it is not rendered").at.line, 0)
      << allFindings(room);
}

TEST(CoverFile, SharedMemoryAndNatNetAreTrackers) {
  const auto withDriver = [](const std::string& attributes) {
    return roomOf("room.xml", with(kCave, "driver=\"dtrack\" port=\"5001\"", attributes));
  };
  const Room room = withDriver("driver=\"CAVELIB\" SHMID=\"7000\" unit=\"cm\"");
  ASSERT_EQ(room.trackers.size(), 1u) << allFindings(room);
  EXPECT_EQ(room.trackers[0].kind, TrackerKind::trackd);
  EXPECT_EQ(room.trackers[0].source, "shm://7000?wand=4127");
  EXPECT_EQ(room.trackers[0].unit_m, 0.01);
  EXPECT_LT(glm::distance(room.trackers[0].roomFromTracker.position_m, {0.01, 0.02, -1.5}), 1e-12);
  EXPECT_EQ(withDriver("driver=\"cavelib\"").trackers.at(0).unit_m, 0.3048);
  EXPECT_EQ(withDriver("driver=\"cavelib\" unit=\"304.8\"").trackers.at(0).unit_m, 0.3048);
  EXPECT_EQ(findingWith(withDriver("driver=\"cavelib\" unit=\"dm\""), "none that a rig has").at.line, 27);
  EXPECT_EQ(findingWith(withDriver("driver=\"cavelib\" Yup=\"off\""), "turns about z first").at.line, 27);
  const Room natnet = withDriver("driver=\"NatNet\" server=\"10.0.0.7\"");
  ASSERT_EQ(natnet.trackers.size(), 1u) << allFindings(natnet);
  EXPECT_EQ(natnet.trackers[0].source, "udp://10.0.0.7?group=239.255.42.99");
}

TEST(CoverFile, NamesByLineWhatItLeavesOut) {
  const Room room = roomOf("room.xml", kCave);
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

TEST(CoverFile, OneOfSeveralClustersIsChosenByName) {
  const std::string two =
      "<COCONFIG>\n<CLUSTER MASTER='a'><COVER><ScreenConfig><Screen name='0' "
      "comment='A'/></ScreenConfig></COVER>"
      "</CLUSTER>\n<CLUSTER MASTER='b'><COVER><ScreenConfig><Screen name='0' "
      "comment='B'/></ScreenConfig></COVER>"
      "</CLUSTER>\n</COCONFIG>";
  EXPECT_NE(refusalOf("room.xml", two)
                .find("2:1: there are 2 rooms in this file, expected --room with one of 'a', 'b'"),
            std::string::npos)
      << refusalOf("room.xml", two);
  EXPECT_EQ(roomOf("room.xml", two, "b").walls.front().wall.name, "B");
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
  EXPECT_NE(refusalOf("room.xml", with(kCave, "originX=\"-2000\"", "originX=\"-20/00\"")).find("8:"),
            std::string::npos);
  EXPECT_NE(refusalOf("room.xml", with(kCave, "name=\"1\" comment=\"SPARE\"", "name=\"0\" comment=\"SPARE\""))
                .find("9:18: the name '0' is taken in line 8"),
            std::string::npos);
  EXPECT_NE(refusalOf("room.xml", "<COCONFIG/>").find("there is no wall here"), std::string::npos);
  EXPECT_NE(refusalOf("room.xml", with(kCave, "\"F1\"", "\"G1\"")).find("bodyIndex is 'G1'"),
            std::string::npos);
}

}  // namespace
}  // namespace carom
