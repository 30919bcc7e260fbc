// Equalizer rooms, as whole files.
#include "app/cave_formats/eqc_file.h"

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

const std::string kCave = R"(#Equalizer 1.2 ascii
server
{
  connection { hostname "127.0.0.1" }
  config
  {
    appNode
    {
      pipe { device 1 window { viewport [ 10 20 800 600 ] attributes { hint_stereo ON }
        channel { viewport [ 0 0 .5 1 ] name "low" }   # the left half
        channel { viewport [ .5 0.5 .5 .5 ] name "high" } } }
    }
    node
    {
      connection { hostname "pc2" }
      pipe { window { viewport [ 0 0 1000 500 ] channel { name "l" } } }
      pipe { window { viewport [ 0 0 1000 500 ] channel { name "unused" } } }
    }
    observer { eye_base .07 }
    layout { name "lay" view { wall { bottom_left [ 0 0 0 ] bottom_right [ 4 0 0 ] top_left [ 0 2 0 ] } } }
    canvas
    {
      wall { bottom_left [ -2 0 -1 ] bottom_right [ 2 0 -1 ] top_left [ -2 2 -1 ] }
      segment { channel "low" viewport [ 0 0 .5 1 ] }
      segment { channel "high" wall { bottom_left [ 2 0 -1 ] bottom_right [ 2 0 1 ] top_left [ 2 2 -1 ] } }
    }
    canvas { layout "lay" segment { channel "l" eye [ LEFT CYCLOP ] viewport [ .5 0 .5 1 ] } }
  }
}
)";

TEST(EqcFile, WallsOfSegmentsCanvasesAndViews) {
  const Room room = roomOf("room.eqc", kCave);
  EXPECT_FALSE(room.hasErrors()) << allFindings(room);
  ASSERT_EQ(room.walls.size(), 3u) << allFindings(room);
  expectCorners(room, "low", {-2, 0, -1}, {0, 0, -1}, {-2, 2, -1});
  expectCorners(room, "high", {2, 0, -1}, {2, 0, 1}, {2, 2, -1});
  expectCorners(room, "l", {2, 0, 0}, {4, 0, 0}, {2, 2, 0});
  EXPECT_EQ(wallOf(room, "low").wall.stereo, StereoMode::quadBuffer);
  EXPECT_EQ(wallOf(room, "l").wall.stereo, StereoMode::left);
  EXPECT_EQ(room.eyeSeparation_m, 0.07);
  EXPECT_EQ(findingWith(room, "channel 'unused'").at.line, 17);
}

TEST(EqcFile, ChannelsCountFromBelowInTheirWindows) {
  const Room room = roomOf("room.eqc", kCave);
  const Wall& high = wallOf(room, "high").wall;
  EXPECT_EQ(high.window.position_px, glm::ivec2(10, 20));
  EXPECT_EQ(high.pixels, glm::ivec2(400, 300));
  EXPECT_EQ(high.viewport->position_px, glm::ivec2(400, 0));
  EXPECT_EQ(wallOf(room, "l").wall.node, 1);
  ASSERT_EQ(room.nodes.size(), 2u);
  EXPECT_EQ(room.nodes[0].display, ":0.1");
  EXPECT_EQ(room.nodes[1].host, "pc2");
}

TEST(EqcFile, CompoundsHandTheirChannelAndEyesDown) {
  const Room room =
      roomOf("room.eqc",
             "#Equalizer 1.0 ascii\nserver { config { appNode { pipe { window { viewport [ 0 0 100 100 ] "
             "channel { name \"c\" } } } }\n compound { channel \"c\" eye [ RIGHT ] compound { projection { "
             "origin [ 0 1 0 ] distance 2 fov [ 90 53.13010235415598 ] hpr [ 90 0 0 ] } } } } }\n");
  ASSERT_EQ(room.walls.size(), 1u) << allFindings(room);
  EXPECT_EQ(room.walls[0].wall.stereo, StereoMode::right);
  // Turned by 90 degrees, w = x: the wall is 4 × 2 m, two metres along x.
  expectCorners(room, "c", {2, 0, 2}, {2, 0, -2}, {2, 2, 2});
}

TEST(EqcFile, UsualValuesOfAllWindowsCount) {
  const std::string mark = "#Equalizer 1.2 ascii\n";
  const std::string usual =
      with(kCave, mark,
           mark +
               "global { EQ_WINDOW_IATTR_HINT_STEREO ON EQ_WINDOW_IATTR_HINT_FULLSCREEN ON "
               "EQ_CONFIG_FATTR_EYE_BASE 0.06 }\n");
  const Room room =
      roomOf("room.eqc", with(with(usual, "eye_base .07", ""), "attributes { hint_stereo ON }", ""));
  EXPECT_EQ(wallOf(room, "high").wall.stereo, StereoMode::quadBuffer);
  EXPECT_TRUE(wallOf(room, "high").wall.window.fullscreen);
  EXPECT_EQ(room.eyeSeparation_m, 0.06);
  EXPECT_EQ(wallOf(room, "l").wall.stereo, StereoMode::left) << "one eye stays one";
  const Room own = roomOf("room.eqc", with(usual, "hint_stereo ON", "hint_stereo OFF"));
  EXPECT_EQ(wallOf(own, "high").wall.stereo, StereoMode::mono) << "its own word counts";
  EXPECT_EQ(own.eyeSeparation_m, 0.07);
}

TEST(EqcFile, OneOfSeveralConfigurationsIsChosen) {
  const auto config = [](const std::string& name, const std::string& width) {
    return "config { " + name +
           " appNode { pipe { window { viewport [ 0 0 200 100 ] channel { name \"c\" } } } }\n" +
           "canvas { segment { channel \"c\" wall { bottom_left [ 0 0 0 ] bottom_right [ " + width +
           " 0 0 ] top_left [ 0 1 0 ] } } } }\n";
  };
  const std::string two = "server {\n" + config("name \"big\"", "2") + config("", "1") + "}";
  EXPECT_EQ(refusalOf("room.eqc", two)
                .find("2:1: there are 2 rooms in this file, expected --room with one of 'big', '1'"),
            0u)
      << refusalOf("room.eqc", two);
  EXPECT_EQ(roomOf("room.eqc", two, "big").walls.at(0).wall.lowerRight_m.x, 2.0);
  const Room second = roomOf("room.eqc", two, "1");
  EXPECT_EQ(second.walls.at(0).wall.lowerRight_m.x, 1.0);
  EXPECT_TRUE(second.findings.empty()) << allFindings(second);
}

TEST(EqcFile, FaultsAreNamedAtTheirPlaces) {
  const std::string cut = kCave.substr(0, kCave.rfind('}'));
  EXPECT_NE(refusalOf("room.eqc", cut).find("the file ends within the section of line 3, expected '}'"),
            std::string::npos)
      << refusalOf("room.eqc", cut);
  EXPECT_NE(
      refusalOf("room.eqc", with(kCave, "bottom_right [ 2 0 -1 ]", "bottom_right [ 2 0/0 -1 ]")).find("23:"),
      std::string::npos);
  EXPECT_NE(
      refusalOf("room.eqc", with(kCave, "name \"high\"", "name \"low\"")).find("'low' is taken in line 10"),
      std::string::npos);
  EXPECT_NE(refusalOf("room.eqc", with(kCave, "channel \"l\" eye", "channel \"x\" eye"))
                .find("there is no channel 'x'"),
            std::string::npos);
  EXPECT_NE(refusalOf("room.eqc", with(kCave, "[ .5 0.5 .5 .5 ]", "[ .5 0.5 .5")).find("stands in a list"),
            std::string::npos);
  EXPECT_NE(refusalOf("room.eqc", "#Equalizer 1\nserver { config { } }").find("there is no wall here"),
            std::string::npos);
  std::string deep = "#Equalizer 1\n";
  for (int i = 0; i < 40; ++i) deep += "config {\n";
  EXPECT_NE(refusalOf("room.eqc", deep).find("nested too deep"), std::string::npos);
}

}  // namespace
}  // namespace carom
