#include "app/room_formats/hevs_file.h"

#include <cmath>
#include <numbers>

#include "app/room_formats/read_room.h"
#include "cave/screen/curved_screen.h"

namespace carom {
namespace {

using test::allFindings;
using test::expectCorners;
using test::findingWith;
using test::refusalOf;
using test::roomOf;
using test::wallOf;
using test::with;

const std::string kRooms = R"({ // two platforms, and "text // that stays"
 "platforms": {
  "Cave": {
   "cluster": {"master": "pc2"},
   "nodes": {
    "pc1": {"address": "10.0.0.1", "display": ["front", "dome"], "resolution": [1600, 800], "fullscreen": false},
    "pc2": {"address": "10.0.0.2", "displays": "left", "resolution": [1000, 500]}},
   "displays": {
    "base": {"type": "offaxis", "ul": [-1, 2, 2], "ll": [-1, 0, 2], "lr": [1, 0, 2]},
    "front": {"inherit": "base", "viewport": "half", "stereo_mode": "topbottom"},
    "left": {"type": "offaxis", "ul": [-1, 2, 0], "ll": [-1, 0, 0], "lr": [-1, 0, 2], "monitor": 2},
    "dome": {"type": "vr", "radius": 3.0},
    "spare": {"type": "offaxis"}},
   "viewports": {"half": {"x": 0.5, "y": 0, "width": 0.5, "height": 1}},
   "stereo": {"mode": "sidebyside", "separation": 0.063, "swap_eyes": true, "tracker": "Glasses"},
   "trackers": {
    "Glasses": {"type": "vrpn", "address": "Head@tracks", "forward": "Y", "right": "X", "up": "Z", "handedness": "right",
      "transform": {"translate": [1, 2, 3], "rotate": [0, 0, 0]}},
    "Wand": {"type": "vrpn", "address": "Wand@tracks", "forward": "Y", "right": "X", "up": "Z", "handedness": "right"},
    "Phone": {"type": "osc"}}
  },
  "Mono": {"inherit": "Cave", "stereo": {"mode": "mono", "swap_eyes": false}}
 }
}
)";

TEST(HevsFile, PlatformsAreChosenByName) {
  EXPECT_NE(refusalOf("room.json", kRooms)
                .find("3:3: there are 2 rooms in this file, expected --room with one of 'Cave', 'Mono'"),
            std::string::npos)
      << refusalOf("room.json", kRooms);
  EXPECT_NE(refusalOf("room.json", kRooms, "Nix").find("there is no room 'Nix'"), std::string::npos);
}

TEST(HevsFile, DisplaysInheritAndAreTurnedRightHanded) {
  const Room room = roomOf("room.json", kRooms, "Cave");
  EXPECT_FALSE(room.hasErrors()) << allFindings(room);
  ASSERT_EQ(room.walls.size(), 2u) << allFindings(room);
  expectCorners(room, "front", {-1, 0, -2}, {1, 0, -2}, {-1, 2, -2});
  expectCorners(room, "left", {-1, 0, 0}, {-1, 0, -2}, {-1, 2, 0});
  EXPECT_EQ(wallOf(room, "left").wall.node, 0) << "the master comes first";
  EXPECT_EQ(wallOf(room, "left").wall.window.monitor, 2);
  EXPECT_EQ(wallOf(room, "front").wall.stereo, StereoMode::topBottom);
  EXPECT_EQ(wallOf(room, "left").wall.stereo, StereoMode::sideBySide);
  EXPECT_EQ(wallOf(room, "left").wall.eyes.at(0).eye, Eye::right);
  EXPECT_EQ(wallOf(room, "front").wall.viewport->position_px, glm::ivec2(800, 0));
  EXPECT_EQ(room.eyeSeparation_m, 0.063);
}

TEST(HevsFile, ViewportsCountFromTheLowerLeft) {
  const Room room = roomOf("room.json",
                           with(kRooms, R"("x": 0.5, "y": 0, "width": 0.5, "height": 1)",
                                R"("x": 0.5, "y": 0.25, "width": 0.5, "height": 0.5)"),
                           "Cave");
  EXPECT_EQ(wallOf(room, "front").wall.viewport->position_px, glm::ivec2(800, 200));
  const Room pixels = roomOf("room.json",
                             with(kRooms, R"("x": 0.5, "y": 0, "width": 0.5, "height": 1)",
                                  R"("x": 100, "y": 200, "width": 300, "height": 150)"),
                             "Cave");
  EXPECT_EQ(wallOf(pixels, "front").wall.viewport->position_px, glm::ivec2(100, 450));
}

TEST(HevsFile, TrackersAreTurnedByTheirAxes) {
  const Room room = roomOf("room.json", kRooms, "Cave");
  ASSERT_EQ(room.trackers.size(), 2u);
  EXPECT_EQ(room.trackers[0].source, "Head@tcp://tracks");
  // Its y is ahead and its z up; moved by (1, 2, 3) with z forward.
  EXPECT_LT(glm::distance(room.trackers[0].roomFromTracker * glm::dvec3(1, 2, 3), {2, 5, -5}), 1e-9);
  EXPECT_TRUE(room.people[0].isTracked);
  EXPECT_TRUE(room.people[0].setup.hand);
  EXPECT_EQ(findingWith(room, "tracker 'Phone'").at.line, 20) << allFindings(room);
}

TEST(HevsFile, PlatformsInheritPartByPart) {
  const Room room = roomOf("room.json", kRooms, "Mono");
  ASSERT_EQ(room.walls.size(), 2u) << allFindings(room);
  EXPECT_EQ(wallOf(room, "left").wall.stereo, StereoMode::mono);
  EXPECT_TRUE(wallOf(room, "left").wall.eyes.empty());
  EXPECT_EQ(room.eyeSeparation_m, 0.063);
}

TEST(HevsFile, NamesDisplaysWithoutAPlace) {
  const Room room = roomOf("room.json", kRooms, "Cave");
  EXPECT_EQ(findingWith(room, "display 'dome' of type 'vr'").at.line, 12) << allFindings(room);
  EXPECT_EQ(findingWith(room, "display 'spare' is left out").at.line, 13);
}

const std::string kCurved = R"({"platforms": {"Round": {
 "transforms": {"risen": {"translate": [0, 0.5, 1], "rotate": [0, 90, 0]}},
 "nodes": {"localhost": {"display": ["left", "right"], "resolution": [1600, 1200]}, "b": {"display": "dome"}},
 "displays": {
  "left": {"type": "curved", "monitor": 0, "slices": 4, "radius": 4.25, "height": 2.9, "angle_start": -60, "angle_end": 0,
    "warp_path": "warp.tif"},
  "right": {"type": "curved", "monitor": 1, "radius": 4.25, "height": 2.9, "angle_start": -10, "angle_end": 60,
    "ground_offset": 0.2, "transform": "risen", "stereo_mode": "leftonly", "swap_eyes": true},
  "dome": {"type": "dome", "fisheye_resolution": [1024, 1000], "radius": 3.0,
    "transform": {"translate": [0, 1, 2], "rotate": [-60, 30, 0]}}}}}})";

const auto& cylinderOf(const Room& room, const std::string& name) {
  return std::get<CylinderScreen>(wallOf(room, name).wall.screen->shape);
}

/// Expects that the window shows, at a place (0 to 1 from its lower left), a place in the room.
template <typename... Window>
void expectShown(const auto& screen, const glm::dvec2& inWindow, const glm::dvec3& inRoom_m,
                 Window... window_px) {
  const glm::dvec3 shown_m = placeOn_m(screen, inWindow, window_px...);
  EXPECT_LT(glm::distance(shown_m, inRoom_m), 1e-9) << shown_m.x << " " << shown_m.y << " " << shown_m.z;
}

TEST(HevsFile, CurvedDisplaysBecomeScreens) {
  const Room room = roomOf("room.json", kCurved);
  EXPECT_FALSE(room.hasErrors()) << allFindings(room);
  ASSERT_EQ(room.walls.size(), 3u) << allFindings(room);
  const double s = 4.25 * std::sin(std::numbers::pi / 3.0);
  expectShown(cylinderOf(room, "left"), {0, 0}, {-s, 0, -4.25 / 2});
  expectShown(cylinderOf(room, "left"), {1, 1}, {0, 2.9, -4.25});
  EXPECT_EQ(findingWith(room, "warp_path 'warp.tif' is left out").at.line, 6) << allFindings(room);
  EXPECT_NE(std::find_if(room.assumptions.begin(), room.assumptions.end(),
                         [](const std::string& text) {
                           return text.find("foot of the curved display 'left'") != text.npos;
                         }),
            room.assumptions.end());
  EXPECT_EQ(wallOf(room, "left").wall.pixels, glm::ivec2(1600, 1200));
}

TEST(HevsFile, TransformsMoveDisplays) {
  const Room room = roomOf("room.json", kCurved);
  // Turned by 90° to the right about the upright axis, z forward: the edge at 60° looks back and to the
  // right.
  const double s = 4.25 * std::sin(std::numbers::pi / 3.0);
  expectShown(cylinderOf(room, "right"), {1, 0}, {4.25 / 2, 0.7, -1 + s});
  EXPECT_EQ(wallOf(room, "right").wall.stereo, StereoMode::right) << "its eyes are swapped";
  EXPECT_EQ(wallOf(room, "right").wall.window.monitor, 1);
  const Room flat = roomOf(
      "room.json",
      with(kRooms, R"("left": {"type": "offaxis",)",
           R"("left": {"type": "offaxis", "transform": {"translate": [0, 0, 1], "rotate": [90, 0, 0]},)"),
      "Cave");
  // Pitched down by 90°, forward is down and up is forward.
  expectCorners(flat, "left", {-1, 0, -1}, {-1, -2, -1}, {-1, 0, -3});
}

TEST(HevsFile, DomesBecomeScreens) {
  const Room room = roomOf("room.json", kCurved);
  const RoomWall& wall = wallOf(room, "dome");
  const auto& dome = std::get<DomeScreen>(wall.wall.screen->shape);
  EXPECT_EQ(wall.wall.pixels, glm::ivec2(1024, 1000)) << "its window is the fisheye picture";
  // Ahead of the display is 60° above the horizon, 30° to the right.
  const double c = std::cos(std::numbers::pi / 3.0), s = std::sin(std::numbers::pi / 3.0);
  const glm::dvec3 heading(std::sin(std::numbers::pi / 6.0), 0, -std::cos(std::numbers::pi / 6.0));
  expectShown(dome, {0.5, 0.5}, glm::dvec3(0, 1, -2) + 3.0 * (c * heading + glm::dvec3(0, s, 0)),
              glm::ivec2(1000, 1000));
  expectShown(dome, {0.5, 0.0}, glm::dvec3(0, 1, -2) + 3.0 * (s * heading - glm::dvec3(0, c, 0)),
              glm::ivec2(1000, 1000));
  for (const char* calibrated : {"\"projector_count\": 8", "\"vioso_path\": \"a.vwf\""}) {
    const Room several = roomOf(
        "room.json", with(kCurved, "\"radius\": 3.0,", fmt::format("\"radius\": 3.0, {},", calibrated)));
    EXPECT_EQ(several.walls.size(), 2u);
    EXPECT_EQ(findingWith(several, "display 'dome' of type 'dome' is left out").at.line, 9)
        << allFindings(several);
  }
  const Room leaning = roomOf("room.json", with(kCurved, "[-60, 30, 0]", "[-60, 30, 5]"));
  EXPECT_EQ(findingWith(leaning, "leans it to the side").at.line, 10) << allFindings(leaning);
}

TEST(HevsFile, CurvedFaultsAreNamedAtTheirPlaces) {
  const auto refused = [](const std::string& old, const std::string& now) {
    return refusalOf("room.json", with(kCurved, old, now));
  };
  EXPECT_EQ(refused("-60, \"angle_end\": 0", "-60").find("5:3: angle_end is missing in display 'left'"), 0u);
  EXPECT_EQ(refused("\"angle_end\": 0", "\"angle_end\": -60").find("5:"), 0u);
  EXPECT_EQ(refused("\"radius\": 3.0", "\"radius\": -3.0").find("9:"), 0u);
  EXPECT_EQ(refused("\"transform\": \"risen\"", "\"transform\": \"sunk\"").find("8:"), 0u);
}

TEST(HevsFile, FaultsAreNamedAtTheirPlaces) {
  EXPECT_NE(refusalOf("room.json", with(kRooms, R"("inherit": "base")", R"("inherit": "front")"), "Cave")
                .find("inherits from itself"),
            std::string::npos);
  EXPECT_NE(refusalOf("room.json", with(kRooms, "\"ll\": [-1, 0, 0]", "\"ll\": [-1, 0]"), "Cave").find("11:"),
            std::string::npos);
  EXPECT_NE(refusalOf("room.json", with(kRooms, "\"spare\": {", "\"dome\": {"), "Cave")
                .find("13:5: the name 'dome' is taken in line 12"),
            std::string::npos);
  EXPECT_NE(refusalOf("room.json", "{\"platforms\": {}}").find("there is no platform here"),
            std::string::npos);
  EXPECT_NE(refusalOf("room.json", "{\"platforms\": {\"A\": {}}}").find("there is no wall here"),
            std::string::npos);
}

}  // namespace
}  // namespace carom
