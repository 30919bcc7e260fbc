#include "app/room_formats/ndisplay_file.h"

#include "app/room_formats/ndisplay_scene.h"
#include "app/room_formats/read_room.h"
#include "places.h"

namespace carom {
namespace {

using test::allFindings;
using test::expectCorners;
using test::findingWith;
using test::refusalOf;
using test::roomOf;
using test::wallOf;
using test::with;

const std::string kJson = R"({"nDisplay": {
 "scene": {
  "xforms": {
   "origin": {"parentId": "", "location": {"x": 0, "y": 0, "z": 10}, "rotation": {"pitch": 0, "yaw": 0, "roll": 0}},
   "glasses": {"parentId": "origin", "location": {"x": 0, "y": 0, "z": 0}, "rotation": {"pitch": 0, "yaw": 0, "roll": 0}},
   "left": {"parentId": "origin", "location": {"x": 0, "y": -150, "z": 100}, "rotation": {"pitch": 0, "yaw": -90, "roll": 0}}},
  "cameras": {
   "L": {"interpupillaryDistance": 6.2, "swapEyes": false, "stereoOffset": "left", "parentId": "glasses"},
   "R": {"interpupillaryDistance": 6.2, "stereoOffset": "right", "parentId": "glasses"}},
  "screens": {
   "s_left": {"size": {"width": 300, "height": 200}, "parentId": "left"},
   "s_floor": {"size": {"width": 300, "height": 300}, "parentId": "origin", "rotation": {"pitch": -90, "yaw": 0, "roll": 0}},
   "s_view": {"size": {"width": 50, "height": 30}, "parentId": "glasses", "location": {"x": 60, "y": 0, "z": 0}}}},
 "cluster": {
  "primaryNode": {"id": "boss"},
  "nodes": {
   "a": {"host": "10.0.0.1", "window": {"x": 5, "y": 6, "w": 600, "h": 400}, "viewports": {
     "v_left": {"camera": "L", "region": {"x": 0, "y": 0, "w": 600, "h": 400}, "projectionPolicy": {"type": "Simple", "parameters": {"screen": "s_left"}}}}},
   "b": {"host": "10.0.0.1", "window": {"x": 0, "y": 0, "w": 800, "h": 400}, "viewports": {
     "v_right": {"camera": "R", "region": {"x": 100, "y": 0, "w": 600, "h": 400}, "projectionPolicy": {"type": "simple", "parameters": {"screen": "s_left"}}}}},
   "boss": {"host": "10.0.0.9", "window": {"x": 0, "y": 0, "w": 500, "h": 500}, "viewports": {
     "v_floor": {"camera": "", "region": {"x": 0, "y": 0, "w": 500, "h": 500}, "projectionPolicy": {"type": "simple", "parameters": {"screen": "s_floor"}}},
     "v_view": {"camera": "L", "region": {"x": 0, "y": 0, "w": 50, "h": 30}, "projectionPolicy": {"type": "simple", "parameters": {"screen": "s_view"}}},
     "v_warp": {"camera": "L", "projectionPolicy": {"type": "mpcdi", "parameters": {"file": "a.mpcdi"}}}}}}}
}}
)";

TEST(NdisplayFile, ScreensHangOnTheirParentsAndAreTurnedRightHanded) {
  const Room room = roomOf("room.ndisplay", kJson);
  EXPECT_FALSE(room.hasErrors()) << allFindings(room);
  ASSERT_EQ(room.walls.size(), 3u) << allFindings(room);
  EXPECT_EQ(room.unit, "cm");
  expectCorners(room, "v_left", {-1.5, 0.1, 1.5}, {-1.5, 0.1, -1.5}, {-1.5, 2.1, 1.5});
  expectCorners(room, "v_right", {-1.5, 0.1, 1.5}, {-1.5, 0.1, -1.5}, {-1.5, 2.1, 1.5});
  expectCorners(room, "v_floor", {-1.5, 0.1, 1.5}, {1.5, 0.1, 1.5}, {-1.5, 0.1, -1.5});
  EXPECT_EQ(wallOf(room, "v_left").wall.stereo, StereoMode::left);
  EXPECT_EQ(wallOf(room, "v_right").wall.stereo, StereoMode::right);
  EXPECT_EQ(wallOf(room, "v_floor").wall.stereo, StereoMode::mono);
  EXPECT_NEAR(room.eyeSeparation_m, 0.062, 1e-12);
}

TEST(NdisplayFile, RotationsAreThoseOfThreePlainTurns) {
  // By another way: FRotator turns by roll about x, then pitch, then yaw, each with Unreal's sign.
  for (const glm::dvec3 turn : {glm::dvec3(10, 20, 30), glm::dvec3(-80, 170, 5), glm::dvec3(90, 0, 45)}) {
    const glm::dvec3 a = glm::radians(turn);
    const auto about = [](int from, int to, double angle) {
      glm::dmat3 m(1.0);
      m[from][from] = m[to][to] = std::cos(angle);
      m[from][to] = std::sin(angle);
      m[to][from] = -std::sin(angle);
      return m;
    };
    // Yaw takes x to y, pitch x to z; roll takes z to y.
    const glm::dmat3 expected = about(0, 1, a.y) * about(0, 2, a.x) * about(2, 1, a.z);
    const glm::dmat3 got = unrealRotation(turn.x, turn.y, turn.z);
    for (int i = 0; i < 3; ++i)
      EXPECT_LT(glm::distance(expected[i], got[i]), 1e-12) << turn.x << " column " << i;
  }
}

TEST(NdisplayFile, EachProcessIsARankThePrimaryFirst) {
  const Room room = roomOf("room.ndisplay", kJson);
  EXPECT_EQ(wallOf(room, "v_floor").wall.node, 0);
  EXPECT_EQ(wallOf(room, "v_left").wall.node, 1);
  EXPECT_EQ(wallOf(room, "v_right").wall.node, 2);
  ASSERT_EQ(room.nodes.size(), 2u);
  EXPECT_EQ(room.nodes[1].host, "10.0.0.1");
  EXPECT_EQ(room.nodes[1].slots, 2);
  EXPECT_EQ(wallOf(room, "v_right").wall.viewport->position_px, glm::ivec2(100, 0));
  EXPECT_FALSE(wallOf(room, "v_left").wall.viewport);
}

TEST(NdisplayFile, LeavesOutPreviewsAndWarpedProjections) {
  const Room room = roomOf("room.ndisplay", kJson);
  EXPECT_EQ(findingWith(room, "hangs on the head 'glasses'").at.line, 23) << allFindings(room);
  EXPECT_EQ(findingWith(room, "'v_warp' by the projection policy 'mpcdi'").at.line, 24);
}

TEST(NdisplayFile, AParentThatIsItsOwnChildIsNamed) {
  const std::string self = with(kJson, R"("left": {"parentId": "origin")", R"("left": {"parentId": "left")");
  EXPECT_NE(refusalOf("room.ndisplay", self).find("6:25: 'left' hangs on itself"), std::string::npos)
      << refusalOf("room.ndisplay", self);
  const std::string round = with(kJson, R"("origin": {"parentId": "")", R"("origin": {"parentId": "left")");
  EXPECT_NE(refusalOf("room.ndisplay", round).find("hangs on itself"), std::string::npos);
  EXPECT_NE(refusalOf("room.ndisplay", with(kJson, R"("b": {"host")", R"("a": {"host")"))
                .find("'a' is taken in line 17"),
            std::string::npos)
      << refusalOf("room.ndisplay", with(kJson, R"("b": {"host")", R"("a": {"host")"));
  EXPECT_NE(refusalOf("room.ndisplay", with(kJson, R"("screen": "s_floor")", R"("screen": "nix")"))
                .find("there is no screen 'nix'"),
            std::string::npos);
}

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

}  // namespace
}  // namespace carom
