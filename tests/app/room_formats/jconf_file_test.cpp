#include "app/room_formats/jconf_file.h"

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

std::string corner(const std::string& name, const std::string& x, const std::string& y,
                   const std::string& z) {
  std::string text;
  for (const std::string& value : {x, y, z}) text += "<" + name + ">" + value + "</" + name + ">";
  return text;
}

std::string viewport(const std::string& name, const std::string& view, const std::string& x) {
  return "<surface_viewport name='" + name +
         "'><origin>0</origin><origin>0.5</origin><size>1</size><size>0.5</size>\n<view>" + view + "</view>" +
         corner("lower_left_corner", x, "0.0", "2") + corner("lower_right_corner", x, "0.0", "-2") +
         corner("upper_right_corner", x, "3", "-2") + corner("upper_left_corner", x, "3", "2") +
         "<user>Me</user><active>true</active></surface_viewport>\n";
}

const std::string kCave =
    "<configuration xmlns='http://www.vrjuggler.org/jccl/xsd/3.0/configuration'>\n<elements>\n"
    "<display_system name='p'><pipes>mammoth:0.0</pipes><pipes>mammoth:0.1</pipes></display_system>\n"
    "<user "
    "name='Me'><head_position>VJHead</head_position><interocular_distance>0.068</interocular_distance></"
    "user>\n"
    "<alias name='VJHead'><proxy>Head</proxy></alias><alias name='VJWand'><proxy>Wand</proxy></alias>\n"
    "<position_proxy name='Head'><device>Art</device><unit>2</unit></position_proxy>\n"
    "<position_proxy name='Wand'><device>Flock</device><unit>0</unit></position_proxy>\n"
    "<vrpn "
    "name='Art'><tracker_server>Art@host</tracker_server><position_filters><position_transform_filter>" +
    corner("pre_translate", "0", "1", "0") + corner("pre_rotation", "0", "90", "0") +
    corner("post_translate", "0.1", "0", "0") +
    "<device_units>1</device_units></position_transform_filter></position_filters></vrpn>\n"
    "<flock name='Flock'><port>/dev/tty</port></flock>\n"
    "<display_window "
    "name='L'><origin>10</origin><origin>20</origin><size>1000</size><size>800</size><pipe>1</pipe>"
    "<stereo>true</stereo><active>true</active><surface_viewports>\n" +
    viewport("left", "Stereo", "-2.0") +
    "</surface_viewports></display_window>\n"
    "<display_window "
    "name='Sim'><origin>0</origin><origin>0</origin><size>100</size><size>100</size><pipe>0</pipe>"
    "<stereo>false</stereo><active>true</active><simulator_viewports><simulator_viewport "
    "name='s'/></simulator_viewports>"
    "<surface_viewports/></display_window>\n"
    "<display_window "
    "name='Off'><origin>0</origin><origin>0</origin><size>100</size><size>100</size><active>false</active>"
    "<surface_viewports>\n" +
    viewport("off", "Left", "2") + "</surface_viewports></display_window>\n</elements>\n</configuration>\n";

TEST(JconfFile, SurfacesAreWallsInTheirWindows) {
  const Room room = roomOf("room.jconf", kCave);
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

TEST(JconfFile, HeadsFollowAliasProxyAndDevice) {
  const Room room = roomOf("room.jconf", kCave);
  ASSERT_EQ(room.trackers.size(), 1u);
  EXPECT_EQ(room.trackers[0].source, "Art@tcp://host");
  // A quarter turn about y takes x to −z; then a metre up.
  EXPECT_LT(glm::distance(room.trackers[0].roomFromTracker * glm::dvec3(1, 0, 0), {0, 1, -1}), 1e-9);
  EXPECT_EQ(room.people[0].setup.head.sensor.sensor, 2);
  EXPECT_LT(glm::length(room.people[0].setup.head.eyesFromSensor * glm::dvec3(0.1, 0, 0)), 1e-9);
  EXPECT_FALSE(room.people[0].setup.hand);
}

/// The cave as a node of a cluster.
std::string clustered(const std::string& more = "") {
  std::string text = kCave;
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
      with(kCave, "<display_system name='p'>",
           "<display_system name='o'><pipes>:0.0</pipes><pipes>ox:0.5</pipes></display_system>"
           "<display_system name='p'>");
  EXPECT_NE(refusalOf("room.jconf", two).find("--room with one of 'o', 'p'"), std::string::npos);
  EXPECT_EQ(roomOf("room.jconf", two, "o").nodes.at(0).host, "ox");
  EXPECT_EQ(roomOf("room.jconf", two, "p").nodes.at(0).host, "mammoth");
}

TEST(JconfFile, TheFirstVersionOfViewportsIsReadToo) {
  std::string text = kCave;
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
  const Room room =
      roomOf("room.jconf", with(kCave, "<view>Stereo</view>", "<view>Stereo</view><tracked>true</tracked>"));
  EXPECT_EQ(findingWith(room, "viewport 'left' is left out: its surface is tracked").at.line, 11)
      << allFindings(room);
}

TEST(JconfFile, TrackdIsReadFromItsMemory) {
  std::string text =
      with(kCave, "<vrpn name='Art'><tracker_server>Art@host</tracker_server>", "<trackd_sensor name='Art'>");
  text = with(text, "</vrpn>",
              "</trackd_sensor><trackd_controller "
              "name='W'><shared_memory_key>99</shared_memory_key></trackd_controller>");
  const Room room = roomOf(
      "room.jconf", with(text, "<device_units>1</device_units>", "<device_units>0.3048</device_units>"));
  ASSERT_EQ(room.trackers.size(), 1u) << allFindings(room);
  EXPECT_EQ(room.trackers[0].source, "shm://4126?wand=99");
  EXPECT_EQ(room.trackers[0].unit_m, 0.3048);
  EXPECT_TRUE(room.people[0].isTracked);
}

TEST(JconfFile, NamesWhatItLeavesOut) {
  const Room room = roomOf("room.jconf", kCave);
  EXPECT_EQ(findingWith(room, "device 'Flock' of kind 'flock'").at.line, 9) << allFindings(room);
  EXPECT_EQ(findingWith(room, "the simulator in window 'Sim'").at.line, 14);
  EXPECT_EQ(findingWith(room, "window 'Off' is left out").at.line, 15);
}

TEST(JconfFile, WithoutAnActiveWindowAllAreTaken) {
  std::string off = kCave;
  for (std::size_t at = 0; (at = off.find("<active>true")) != std::string::npos;)
    off.replace(at, 12, "<active>false");
  const Room room = roomOf("room.jconf", off);
  EXPECT_EQ(room.walls.size(), 2u) << allFindings(room);
  EXPECT_EQ(wallOf(room, "off").wall.stereo, StereoMode::left);
  EXPECT_NE(findingWith(room, "no window with walls is active").at.line, 0);
}

TEST(JconfFile, FaultsAreNamedAtTheirPlaces) {
  const std::string fourth =
      refusalOf("room.jconf", with(kCave, "<upper_right_corner>-2.0</upper_right_corner>",
                                   "<upper_right_corner>-2.1</upper_right_corner>"));
  EXPECT_NE(fourth.find("12:"), std::string::npos) << fourth;
  EXPECT_NE(fourth.find("upper_right_corner of wall 'left' is 100.0 mm from"), std::string::npos) << fourth;
  EXPECT_NE(refusalOf("room.jconf", with(kCave, "name='Off'", "name='L'")).find("'L' is taken in line 10"),
            std::string::npos);
  const std::string missing =
      refusalOf("room.jconf", with(kCave, "<lower_left_corner>-2.0</lower_left_corner>", ""));
  EXPECT_NE(missing.find("lower_left_corner has 2 values, expected 3 numbers"), std::string::npos) << missing;
  EXPECT_NE(
      refusalOf("room.jconf", "<configuration><elements/></configuration>").find("there is no wall here"),
      std::string::npos);
}

}  // namespace
}  // namespace carom
