// Rooms of MPCDI: which files are some, and what their profiles become.
#include "app/room_formats/mpcdi_file.h"

#include <gtest/gtest.h>

#include <string>

#include "app/room_formats/read_room.h"

namespace carom {
namespace {

using test::allFindings;
using test::findingWith;
using test::kArc;
using test::TemporaryFolder;

/// A description with two regions side by side, in lines 3 and 4.
std::string description(const std::string& profile, const std::string& second = "0.5") {
  return "<MPCDI profile='" + profile +
         "'>\n<display><buffer id='b' xResolution='800' yResolution='400'>\n"
         "<region id='one' xResolution='400' yResolution='400' x='0' y='0' xsize='0.5' ysize='1'/>\n"
         "<region id='two' xResolution='400' yResolution='300' x='0.5' y='0' xsize='" +
         second + "' ysize='1'/>\n</buffer></display></MPCDI>";
}

Room read(const std::string& text) {
  const TemporaryFolder folder;
  return readMpcdi(folder.file("room.mpcdi.xml", text));
}

TEST(MpcdiFile, IsToldByItsEndingOrItsContent) {
  const TemporaryFolder folder;
  EXPECT_TRUE(isMpcdi(kArc));
  EXPECT_TRUE(isMpcdi(folder.file("a.mpcdi", "")));
  EXPECT_TRUE(isMpcdi(folder.file("a.xml", "<?xml version='1.0'?>\n<MPCDI/>")));
  EXPECT_TRUE(isMpcdi(folder.file("a.zip", test::contentOf(kArc))));
  EXPECT_FALSE(isMpcdi(folder.file("b.xml", "<pvx/>")));
  EXPECT_FALSE(isMpcdi(folder / "none.xml"));
}

TEST(MpcdiFile, AnArchiveOfPlacesIsACurvedWallWithItsFiles) {
  const Room room = readMpcdi(kArc);
  EXPECT_FALSE(room.hasErrors()) << allFindings(room);
  ASSERT_EQ(room.walls.size(), 1u);
  const Wall& wall = room.walls[0].wall;
  EXPECT_EQ(wall.name, "proj1");
  EXPECT_EQ(wall.pixels, glm::ivec2(1940, 660));
  EXPECT_TRUE(wall.screen);
  EXPECT_EQ(room.floor_m, 0.0);
  ASSERT_EQ(room.files.size(), 2u) << "the screen and the blend";
  EXPECT_EQ(room.files[0].content->size(), 112u) << "the blend, as it is in the archive";
  EXPECT_FALSE(room.files[1].content->empty());
  EXPECT_NE(findingWith(room, "a map of black levels").at.line, 0) << allFindings(room);
}

// The whole picture is 4 × 2 m: each half is 2 m wide, its windows beside each other.
TEST(MpcdiFile, PartsOfAPictureAreFlatWallsSideBySide) {
  const Room room = read(description("2d"));
  EXPECT_FALSE(room.hasErrors()) << allFindings(room);
  ASSERT_EQ(room.walls.size(), 2u);
  test::expectCorners(room, "one", {-2, kStandingEyes_m - 1, -3}, {0, kStandingEyes_m - 1, -3},
                      {-2, kStandingEyes_m + 1, -3});
  test::expectCorners(room, "two", {0, kStandingEyes_m - 1, -3}, {2, kStandingEyes_m - 1, -3},
                      {0, kStandingEyes_m + 1, -3});
  EXPECT_EQ(room.walls[1].wall.window.position_px, glm::ivec2(400, 0));
  EXPECT_EQ(room.walls[1].wall.pixels, glm::ivec2(400, 300));
  EXPECT_EQ(findingWith(room, "the picture of region 'two' is right from one place only").at.line, 4);
}

TEST(MpcdiFile, ProfilesWithoutAScreenAreRefused) {
  const Room sl = read(description("sl"));
  EXPECT_TRUE(sl.hasErrors());
  EXPECT_EQ(findingWith(sl, "the profile sl gives poses of projectors").at.line, 1);
  EXPECT_EQ(findingWith(read(description("4d")), "the profile is '4d', expected a3, 3d or 2d").at.line, 1);
  EXPECT_EQ(findingWith(read("\n<pvx/>"), "the first element is <pvx>, expected <MPCDI>").at.line, 2);
  const Room bare = read(description("a3"));
  EXPECT_EQ(findingWith(bare, "region 'one' has no geometryWarpFile").at.line, 3) << allFindings(bare);
}

}  // namespace
}  // namespace carom
