// Where the displays of HEVS are: curved ones, domes, and displays that transforms move.
#include "app/cave_formats/hevs_screen.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <string>
#include <variant>

#include "app/cave_formats/hevs_rooms.h"
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
using test::hevs::kCurved;
using test::hevs::kRooms;

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

}  // namespace
}  // namespace carom
