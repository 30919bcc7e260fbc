// The windows of rooms of OpenCOVER, and the parts of them on which channels draw.
#include "app/cave_formats/cover_windows.h"

#include <gtest/gtest.h>

#include <string>

#include "app/cave_formats/cover_room.h"
#include "app/room_formats/read_room.h"

namespace carom {
namespace {

namespace cover = test::cover;
using test::allFindings;
using test::findingWith;
using test::roomOf;
using test::wallOf;

TEST(CoverFile, ViewportsCountFromTheLowerLeftOfTheirWindow) {
  const Room room = roomOf("room.xml", cover::kCave);
  const Wall& wall = wallOf(room, "LEFT-left").wall;
  EXPECT_EQ(wall.pixels, glm::ivec2(1500, 1500));
  EXPECT_EQ(wall.window.position_px, glm::ivec2(100, 20));
  EXPECT_EQ(wall.window.size_px, glm::ivec2(2000, 1600));
  ASSERT_TRUE(wall.viewport);
  EXPECT_EQ(wall.viewport->position_px, glm::ivec2(200, 0));
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

TEST(CoverWindows, ElementsGoByTheirNumbers) {
  const auto namesOf = [](const std::string& elements) {
    const Part config =
        partOf(parseXml("a.xml", "<COVER><G>" + elements + "</G></COVER>", Doctype::none).root);
    std::string names;
    for (const Part* part : coverElements(config, "G", "E")) names += part->textOf("name") + " ";
    return names;
  };
  EXPECT_EQ(namesOf("<E name='10'/><E name='2'/><F name='0'/><E name='0'/>"), "0 2 10 ");
  EXPECT_EQ(namesOf("<E name='b'/><E name='2'/><E name='a'/>"), "b 2 a ") << "as the file has them";
  EXPECT_EQ(namesOf(""), "");
}

}  // namespace
}  // namespace carom
