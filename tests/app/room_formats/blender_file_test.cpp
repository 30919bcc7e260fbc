// Rooms of BlenderCAVE and BlenderVR.
#include "app/room_formats/blender_file.h"

#include <gtest/gtest.h>

#include <string>

#include "app/room_formats/blender_room.h"
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
using test::blender::kCave;

TEST(BlenderFile, WallsAreOfThreeCornersAndTheirComputers) {
  const Room room = roomOf("room.xml", kCave);
  EXPECT_FALSE(room.hasErrors()) << allFindings(room);
  ASSERT_EQ(room.walls.size(), 2u);
  expectCorners(room, "pc-1-main", {-2, -1.6, 1.5}, {-2, -1.6, -1.5}, {-2, 1.1, 1.5});
  expectCorners(room, "pc-2-main", {-2, -1.6, 1.5}, {2, -1.6, 1.5}, {-2, -1.6, -1.5});
  EXPECT_EQ(room.title, "Two");
  ASSERT_EQ(room.nodes.size(), 2u);
  EXPECT_EQ(room.nodes[0].host, "pc-1");
  EXPECT_EQ(room.nodes[0].display, ":0.1");
}

TEST(BlenderFile, BuffersSayWhoseEyeIsInWhichChannel) {
  const Room room = roomOf("room.xml", kCave);
  const Wall& left = wallOf(room, "pc-1-main").wall;
  EXPECT_EQ(left.stereo, StereoMode::quadBuffer);
  EXPECT_EQ(left.viewer, 0u);
  EXPECT_TRUE(left.eyes.empty());
  const Wall& floor = wallOf(room, "pc-2-main").wall;
  ASSERT_EQ(floor.eyes.size(), 2u);
  EXPECT_EQ(floor.eyes[0], (ViewerEye{1, Eye::middle}));
  EXPECT_EQ(floor.eyes[1], (ViewerEye{0, Eye::middle}));
}

TEST(BlenderFile, AViewportIsInTheMiddleOfItsWindow) {
  const Room room = roomOf("room.xml", kCave);
  const Wall& wall = wallOf(room, "pc-1-main").wall;
  EXPECT_EQ(wall.pixels, glm::ivec2(1080, 1080));
  EXPECT_EQ(wall.window.size_px, glm::ivec2(1920, 1080));
  ASSERT_TRUE(wall.viewport);
  EXPECT_EQ(wall.viewport->position_px, glm::ivec2(420, 0));
}

TEST(BlenderFile, SmallSeparationsAreOfOneEye) {
  const Room room = roomOf("room.xml", kCave);
  EXPECT_EQ(room.people[0].setup.head.eyeSeparation_m, 0.06);
  EXPECT_EQ(room.people[1].setup.head.eyeSeparation_m, 0.066);
  EXPECT_EQ(findingWith(room, "eye_separation 0.03").at.line, 6);
}

TEST(BlenderFile, NamesWhatItLeavesOut) {
  const Room room = roomOf("room.xml", kCave);
  EXPECT_EQ(findingWith(room, "'console' is left out").at.line, 9) << allFindings(room);
  EXPECT_EQ(findingWith(room, "'rest.xml' is named here as an entity").at.line, 35);
  EXPECT_EQ(findingWith(room, "button 'FlyStick'").at.line, 33);
  EXPECT_EQ(findingWith(room, "sensor 0 of tracker 'DTrack'").at.line, 31);
}

TEST(BlenderFile, UsersOnTheFloorStandThere) {
  Room room = roomOf("room.xml", with(kCave, "0, 0, 0</def", "0, -1.6, 0</def"));
  EXPECT_NEAR(room.viewers[0].eyes_m.y, -1.6 + kStandingEyes_m, 1e-12);
  EXPECT_EQ(room.viewers[1].eyes_m.y, 0.0);
}

TEST(BlenderFile, UsersWithoutAWallAreNamedAndLeftOut) {
  const std::string alone =
      with(kCave, R"(name="left" user="user B" eye="middle")", R"(name="left" user="user A" eye="middle")");
  const Room room = roomOf("room.xml", alone);
  ASSERT_EQ(room.people.size(), 1u);
  EXPECT_EQ(room.viewers.size(), 1u);
  EXPECT_EQ(findingWith(room, "viewer 'user-B' is left out").at.line, 7) << allFindings(room);
}

const std::string kVr = R"(<blendervr>
 <starter><config name="Wall">front</config><config name="Both">front, side</config></starter>
 <users><user name="me"/></users>
 <computers><computer name="One" hostname="10.0.0.1"/></computers>
 <screens>
  <screen name="front" computer="One"><display options="-f -s sidebyside"><environment>DISPLAY=:0.0</environment>
    <graphic_buffer buffer="left" user="me" eye="left"/><graphic_buffer buffer="right" user="me" eye="right"/></display>
   <wall><corner name="topRightCorner">1, 1, -1</corner><corner name="topLeftCorner">-1, 1, -1</corner>
    <corner name="bottomRightCorner">1, -1, -1</corner></wall></screen>
  <screen name="side" computer="One"><display options="-w 400 300 20 30"><graphic_buffer user="me"/></display>
   <wall><corner name="topRightCorner">1, 1, 1</corner><corner name="topLeftCorner">1, 1, -1</corner>
    <corner name="bottomRightCorner">1, -1, 1</corner></wall></screen>
 </screens>
</blendervr>
)";

TEST(BlenderFile, BlenderVrHasConfigurations) {
  EXPECT_NE(refusalOf("room.xml", kVr).find("--room with one of 'Wall', 'Both'"), std::string::npos);
  const Room one = roomOf("room.xml", kVr, "Wall");
  ASSERT_EQ(one.walls.size(), 1u) << allFindings(one);
  EXPECT_EQ(one.walls[0].wall.stereo, StereoMode::sideBySide);
  EXPECT_EQ(one.nodes.at(0).host, "10.0.0.1");
  const Room both = roomOf("room.xml", kVr, "Both");
  EXPECT_EQ(wallOf(both, "side").wall.window.position_px, glm::ivec2(20, 30));
  EXPECT_EQ(wallOf(both, "side").wall.stereo, StereoMode::mono);
}

TEST(BlenderFile, EntitiesWithATextAreRefused) {
  const std::string bomb =
      "<?xml version='1.0'?>\n<!DOCTYPE a [\n <!ENTITY a 'aaaa'>\n <!ENTITY b "
      "'&a;&a;'>\n]>\n<blender_cave>&b;</blender_cave>";
  const std::string said = refusalOf("room.xml", bomb);
  EXPECT_EQ(said.rfind("3:", 0), 0u) << said;
  EXPECT_NE(said.find("defines an entity with a text of its own"), std::string::npos) << said;
}

TEST(BlenderFile, FaultsAreNamedAtTheirPlaces) {
  EXPECT_NE(
      refusalOf("room.xml", with(kCave, "user=\"0\"", "user=\"9\"")).find("15:94: there is no user '9'"),
      std::string::npos)
      << refusalOf("room.xml", with(kCave, "user=\"0\"", "user=\"9\""));
  EXPECT_NE(refusalOf("room.xml", with(kCave, "user name=\"user B\"", "user name=\"user A\""))
                .find("'user A' is taken in line 6"),
            std::string::npos);
  EXPECT_NE(refusalOf("room.xml", with(kCave, "-2, 1.1, -1.5", "-2, 1.1")).find("has 2 values"),
            std::string::npos);
  EXPECT_NE(refusalOf("room.xml", with(kCave, "-2, 1.1, -1.5", "-2, 1.1, -1.4")).find("mm"),
            std::string::npos);
}

}  // namespace
}  // namespace carom
