// Rooms of VR Juggler, as whole files.
#include "app/cave_formats/jconf_file.h"

#include <gtest/gtest.h>

#include <string>

#include "app/cave_formats/jconf_room.h"
#include "app/room_formats/read_room.h"

namespace carom {
namespace {

namespace jconf = test::jconf;
using test::allFindings;
using test::expectCorners;
using test::findingWith;
using test::refusalOf;
using test::roomOf;
using test::wallOf;
using test::with;
using test::jconf::corner;

TEST(JconfFile, SurfacesAreWallsInTheirWindows) {
  const Room room = roomOf("room.jconf", jconf::kCave);
  EXPECT_FALSE(room.hasErrors()) << allFindings(room);
  ASSERT_EQ(room.walls.size(), 1u) << allFindings(room);
  expectCorners(room, "left", {-2, 0, 2}, {-2, 0, -2}, {-2, 3, 2});
  const Wall& wall = wallOf(room, "left").wall;
  EXPECT_EQ(wall.stereo, StereoMode::quadBuffer);
  EXPECT_EQ(wall.pixels, glm::ivec2(1000, 400));
  EXPECT_EQ(wall.viewport->position_px, glm::ivec2(0, 0));  // shares count from below
  EXPECT_EQ(room.nodes.at(0).host, "mammoth");
  EXPECT_EQ(room.nodes.at(0).display, ":0.1");
  EXPECT_EQ(room.eyeSeparation_m, 0.068);
}

/// The cave as a node of a cluster.
std::string clustered(const std::string& more = "") {
  std::string text = jconf::kCave;
  const std::string system =
      "<display_system name='p'><pipes>mammoth:0.0</pipes><pipes>mammoth:0.1</pipes></display_system>\n";
  text = with(text, system, "");
  text =
      with(text, "<display_window name='L'>",
           more +
               "<cluster_node name='n1'><host_name>tusk</host_name><display_system><display_system name='q'>"
               "<pipes>:0.2</pipes><pipes>:0.3</pipes></display_system></display_system><display_windows>"
               "<display_window name='L'>");
  return with(text, "</elements>", "</display_windows></cluster_node></elements>");
}

TEST(JconfFile, NodesOfAClusterHaveTheirOwnPipesAndWindows) {
  const Room room = roomOf("room.jconf", clustered());
  ASSERT_EQ(room.walls.size(), 1u) << allFindings(room);
  EXPECT_EQ(room.nodes.at(0).host, "tusk");
  EXPECT_EQ(room.nodes.at(0).display, ":0.3");
  EXPECT_EQ(findingWith(room, "window 'Off' is left out").at.line, 14) << allFindings(room);
  const Room empty = roomOf("room.jconf", clustered("<cluster_node name='n0'/>"));
  EXPECT_EQ(findingWith(empty, "node 'n0' has no window").at.line, 9) << allFindings(empty);
}

TEST(JconfFile, SeveralDisplaySystemsAreChosenByName) {
  const std::string two =
      with(jconf::kCave, "<display_system name='p'>",
           "<display_system name='o'><pipes>:0.0</pipes><pipes>ox:0.5</pipes></display_system>"
           "<display_system name='p'>");
  EXPECT_NE(refusalOf("room.jconf", two).find("--room with one of 'o', 'p'"), std::string::npos);
  EXPECT_EQ(roomOf("room.jconf", two, "o").nodes.at(0).host, "ox");
  EXPECT_EQ(roomOf("room.jconf", two, "p").nodes.at(0).host, "mammoth");
}

TEST(JconfFile, TheFirstVersionOfViewportsIsReadToo) {
  std::string text = jconf::kCave;
  const auto old = [](const std::string& x, const std::string& y, const std::string& z) {
    return "<corners><vec3><x>" + x + "</x><y>" + y + "</y><z>" + z + "</z></vec3></corners>";
  };
  text = with(
      text,
      corner("lower_left_corner", "-2.0", "0.0", "2") + corner("lower_right_corner", "-2.0", "0.0", "-2") +
          corner("upper_right_corner", "-2.0", "3", "-2") + corner("upper_left_corner", "-2.0", "3", "2"),
      old("-2", "0", "2") + old("-2", "0", "-2") + old("-2", "3", "-2") + old("-2", "3", "2"));
  const Room room = roomOf("room.jconf", with(text, "<view>Stereo</view>", "<view>2</view>"));
  ASSERT_EQ(room.walls.size(), 1u) << allFindings(room);
  expectCorners(room, "left", {-2, 0, 2}, {-2, 0, -2}, {-2, 3, 2});
  EXPECT_EQ(room.walls[0].wall.stereo, StereoMode::right);
}

TEST(JconfFile, TrackedSurfacesAreLeftOut) {
  const Room room = roomOf(
      "room.jconf", with(jconf::kCave, "<view>Stereo</view>", "<view>Stereo</view><tracked>true</tracked>"));
  EXPECT_EQ(findingWith(room, "viewport 'left' is left out: its surface is tracked").at.line, 11)
      << allFindings(room);
}

TEST(JconfFile, NamesWhatItLeavesOut) {
  const Room room = roomOf("room.jconf", jconf::kCave);
  EXPECT_EQ(findingWith(room, "device 'Flock' of kind 'flock'").at.line, 9) << allFindings(room);
  EXPECT_EQ(findingWith(room, "the simulator in window 'Sim'").at.line, 14);
  EXPECT_EQ(findingWith(room, "window 'Off' is left out").at.line, 15);
}

TEST(JconfFile, WithoutAnActiveWindowAllAreTaken) {
  std::string off = jconf::kCave;
  for (std::size_t at = 0; (at = off.find("<active>true")) != std::string::npos;)
    off.replace(at, 12, "<active>false");
  const Room room = roomOf("room.jconf", off);
  EXPECT_EQ(room.walls.size(), 2u) << allFindings(room);
  EXPECT_EQ(wallOf(room, "off").wall.stereo, StereoMode::left);
  EXPECT_NE(findingWith(room, "no window with walls is active").at.line, 0);
}

TEST(JconfFile, FaultsAreNamedAtTheirPlaces) {
  const std::string fourth =
      refusalOf("room.jconf", with(jconf::kCave, "<upper_right_corner>-2.0</upper_right_corner>",
                                   "<upper_right_corner>-2.1</upper_right_corner>"));
  EXPECT_NE(fourth.find("12:"), std::string::npos) << fourth;
  EXPECT_NE(fourth.find("upper_right_corner of wall 'left' is 100.0 mm from"), std::string::npos) << fourth;
  EXPECT_NE(
      refusalOf("room.jconf", with(jconf::kCave, "name='Off'", "name='L'")).find("'L' is taken in line 10"),
      std::string::npos);
  const std::string missing =
      refusalOf("room.jconf", with(jconf::kCave, "<lower_left_corner>-2.0</lower_left_corner>", ""));
  EXPECT_NE(missing.find("lower_left_corner has 2 values, expected 3 numbers"), std::string::npos) << missing;
  EXPECT_NE(
      refusalOf("room.jconf", "<configuration><elements/></configuration>").find("there is no wall here"),
      std::string::npos);
}

}  // namespace
}  // namespace carom
