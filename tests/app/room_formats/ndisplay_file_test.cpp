// Rooms of nDisplay, as Unreal Engine 4.26 and later write them.
#include "app/room_formats/ndisplay_file.h"

#include <gtest/gtest.h>

#include <string>

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

}  // namespace
}  // namespace carom
