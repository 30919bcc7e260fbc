// nDisplay's text form of before Unreal Engine 4.26.
#include "app/room_formats/ndisplay_file.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <string>

#include "app/room_formats/read_room.h"
#include "places.h"

namespace carom {
namespace {

using test::allFindings;
using test::expectCorners;
using test::findingWith;
using test::roomOf;
using test::wallOf;

const std::string kCfg = R"(# a room
[cluster_node] id=boss addr=10.0.0.9 screen=view viewport=vp master=true
[cluster_node] id=front_eye_left addr=10.0.0.1 screen=front viewport=vp
[cluster_node] id=front_eye_right addr=10.0.0.1 screen=front viewport=vp
[screen] id=view  loc="X=0.4,Y=0,Z=0" rot="P=0,Y=0,R=0" size="X=0.4,Y=0.3" parent=glasses
[screen] id=front loc="X=2,Y=0.5,Z=+1.5" rot="P=0,Y=0,R=0" size="X=3,Y=2" parent=origin
[viewport] id=vp x=10 y=20 width=1500 height=1000 flip_h=True flip_v=False
[camera] id=cam loc="X=0,Y=0,Z=0" parent=glasses
[scene_node] id=origin loc="X=0,Y=0,Z=0" rot="P=0,Y=0,R=0"
[scene_node] id=glasses loc="X=0,Y=0,Z=0" rot="P=0,Y=0,R=0" parent=origin tracker_id=art tracker_ch=3
[scene_node] id=stick loc="X=0,Y=0,Z=0" parent=origin tracker_id=art tracker_ch=7
[input] id=art type=tracker addr=DTrack@10.0.0.29 loc="X=1,Y=0,Z=0" rot="P=0,Y=0,R=0" right=X up=Y front=-Z
[input] id=axes type=analog addr=DTrack@10.0.0.29
[stereo] eye_swap=False eye_dist=0.061
)";

TEST(NdisplayFile, TheTextFormIsInMetres) {
  const Room room = roomOf("room.cfg", kCfg);
  EXPECT_FALSE(room.hasErrors()) << allFindings(room);
  ASSERT_EQ(room.walls.size(), 2u) << allFindings(room);
  expectCorners(room, "front_eye_left", {-1, 0.5, -2}, {2, 0.5, -2}, {-1, 2.5, -2});
  EXPECT_EQ(wallOf(room, "front_eye_right").wall.stereo, StereoMode::right);
  EXPECT_EQ(wallOf(room, "front_eye_right").wall.flip, Flip::horizontal);
  EXPECT_EQ(wallOf(room, "front_eye_right").wall.pixels, glm::ivec2(1500, 1000));
  EXPECT_EQ(room.eyeSeparation_m, 0.061);
  EXPECT_EQ(findingWith(room, "'boss' is left out").at.line, 2);
  EXPECT_EQ(findingWith(room, "input 'axes'").at.line, 13);
  ASSERT_EQ(room.trackers.size(), 1u);
  EXPECT_EQ(room.trackers[0].source, "DTrack@tcp://10.0.0.29");
  // The tracker has y up and −z ahead as the room does; it is moved a metre ahead.
  EXPECT_LT(glm::distance(room.trackers[0].roomFromTracker * glm::dvec3(1, 2, 3), {1, 2, 2}), 1e-9);
  EXPECT_EQ(room.people[0].setup.head.sensor.sensor, 3);
  ASSERT_TRUE(room.people[0].setup.hand);
  EXPECT_EQ(room.people[0].setup.hand->sensor, 7);
}

TEST(NdisplayFile, TheRealRoomIsRefusedForItsMistakes) {
  const Room room = readForeignRoom(CAROM_TESTS_DIR "/data/rooms/aixcave.cfg");
  EXPECT_TRUE(room.hasErrors());
  EXPECT_EQ(findingWith(room, "'0.40.0' in loc").at.line, 208) << allFindings(room);
  EXPECT_EQ(findingWith(room, "'screen_front_lower_left' is taken in line 108").at.line, 109);
  EXPECT_EQ(findingWith(room, "'display_front_lower_left' is taken in line 217").at.line, 218);
}

TEST(NdisplayCfg, ALineIsAPartWithItsKeys) {
  const test::TemporaryFolder folder;
  const Part root = readCfgLines(
      folder.file("a.cfg", "# text\n\n  [screen] id=a  loc=\"X=1,Y=2\"\nno line\n[Screen] id=b\r\n"));
  const auto screens = root.all("screen");
  ASSERT_EQ(screens.size(), 2u);
  EXPECT_EQ(screens[0]->at.line, 3);
  EXPECT_EQ(screens[0]->at.column, 3);
  EXPECT_EQ(screens[0]->textOf("loc"), "X=1,Y=2");
  EXPECT_EQ(screens[1]->textOf("id"), "b");
  EXPECT_EQ(root.parts.size(), 2u);
}

}  // namespace
}  // namespace carom
