// Rooms of HEVS, as whole files.
#include "app/cave_formats/hevs_file.h"

#include <gtest/gtest.h>

#include <string>

#include "app/cave_formats/hevs_rooms.h"
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
using test::hevs::kRooms;

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

TEST(HevsFile, NamesDisplaysWithoutAPlace) {
  const Room room = roomOf("room.json", kRooms, "Cave");
  EXPECT_EQ(findingWith(room, "display 'dome' of type 'vr'").at.line, 12) << allFindings(room);
  EXPECT_EQ(findingWith(room, "display 'spare' is left out").at.line, 13);
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
