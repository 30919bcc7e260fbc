// What each computer of a room of OpenCOVER sees of the sections of a file.
#include "app/cave_formats/cover_config.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "app/cave_formats/cover_room.h"
#include "app/room_formats/read_room.h"

namespace carom {
namespace {

namespace cover = test::cover;
using test::allFindings;
using test::expectCorners;
using test::refusalOf;
using test::roomOf;
using test::with;

TEST(CoverFile, ComputersSeeWhatConcernsThemAndLaterSectionsWin) {
  const Room room = roomOf("room.xml", cover::kCave);
  EXPECT_FALSE(room.hasErrors()) << allFindings(room);
  ASSERT_EQ(room.walls.size(), 4u) << allFindings(room);
  EXPECT_EQ(room.unit, "mm");
  EXPECT_EQ(room.axes.up, glm::dvec3(0, 0, 1));
  expectCorners(room, "FRONT-left", {-2, 2, -1.5}, {2, 2, -1.5}, {-2, 2, 1.5});
  expectCorners(room, "FRONT-right", {-2, 2, -1.5}, {2, 2, -1.5}, {-2, 2, 1.5});
  // Turned to the left: its right edge is ahead.
  expectCorners(room, "LEFT-left", {-2, -1.5, -1.5}, {-2, 1.5, -1.5}, {-2, -1.5, 1.5});
  EXPECT_EQ(room.eyeSeparation_m, 0.062);
}

TEST(CoverFile, OneOfSeveralClustersIsChosenByName) {
  const std::string two =
      "<COCONFIG>\n<CLUSTER MASTER='a'><COVER><ScreenConfig><Screen name='0' "
      "comment='A'/></ScreenConfig></COVER>"
      "</CLUSTER>\n<CLUSTER MASTER='b'><COVER><ScreenConfig><Screen name='0' "
      "comment='B'/></ScreenConfig></COVER>"
      "</CLUSTER>\n</COCONFIG>";
  EXPECT_NE(refusalOf("room.xml", two)
                .find("2:1: there are 2 rooms in this file, expected --room with one of 'a', 'b'"),
            std::string::npos)
      << refusalOf("room.xml", two);
  EXPECT_EQ(roomOf("room.xml", two, "b").walls.front().wall.name, "B");
}

// Whatever their order in the file: sections for all, then of the cluster, then of the computer win.
TEST(CoverConfig, NarrowerSectionsWin) {
  Room room;
  const Part root = partOf(
      parseXml(
          "a.xml",
          "<COCONFIG><LOCAL HOST='b,a'><COVER><FloorHeight value='local'/></COVER></LOCAL>"
          "<CLUSTER MASTER='m'><COVER><FloorHeight value='cluster'/><StereoMode value='c'/></COVER></CLUSTER>"
          "<GLOBAL><COVER><FloorHeight value='all'/><StereoMode value='g'/><NumWindows "
          "value='r'/></COVER></GLOBAL>"
          "</COCONFIG>",
          Doctype::none)
          .root);
  CoverSections sections(root, room);
  EXPECT_EQ(sections.masters(), std::vector<std::string>{"m"});
  EXPECT_EQ(sections.hosts(), (std::vector<std::string>{"b", "a"}));
  const auto value = [&](const std::string& host, const std::string& master, const char* element) {
    const Part config = sections.configOf(host, master);
    const Part* part = config.find(element);
    return part ? part->textOf("value") : "none";
  };
  EXPECT_EQ(value("a", "m", "FloorHeight"), "local");
  EXPECT_EQ(value("a", "m", "StereoMode"), "c");
  EXPECT_EQ(value("a", "m", "NumWindows"), "r");
  EXPECT_EQ(value("c", "m", "FloorHeight"), "cluster");
  EXPECT_EQ(value("c", "other", "FloorHeight"), "all");
  EXPECT_EQ(allFindings(room), "");
}

}  // namespace
}  // namespace carom
