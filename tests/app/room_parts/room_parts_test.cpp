// The steps by which readers put walls, windows, computers and trackers into a room.
#include "app/room_parts/room_parts.h"

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <random>
#include <string>
#include <vector>

namespace carom {
namespace {

Room emptyRoom() { return roomOfFormat("there/room.x", "a room", "m", 1.0); }

RoomWall wallNamed(const std::string& name, int line) {
  RoomWall wall;
  wall.wall.name = name;
  wall.wall.pixels = wall.wall.window.size_px = {400, 300};
  const FilePlace at{line, 1};
  wall.at = {at, at, at, at, at, at, at};
  return wall;
}

const ReadCorners kCorners{{-2, 0, -1}, {2, 0, -1}, {-2, 3, -1}};

std::vector<std::string> saidWithKinds(const Room& room) {
  std::vector<std::string> said;
  for (const Finding& finding : room.findings)
    said.push_back(fmt::format("{} {}: {}", finding.kind == Finding::Kind::error ? 'E' : 'W', finding.at.line,
                               finding.text));
  return said;
}

using Said = std::vector<std::string>;

TEST(RoomParts, WallsHaveNamesOfTheirOwnAndPixels) {
  Room room = emptyRoom();
  EXPECT_EQ(room.title, "room");
  EXPECT_TRUE(addWall(wallNamed("front", 3), kCorners, room));
  EXPECT_TRUE(addWall(wallNamed("front", 5), kCorners, room));
  RoomWall bare = wallNamed("bare", 7);
  bare.wall.pixels = bare.wall.window.size_px = {0, 0};
  EXPECT_TRUE(addWall(bare, kCorners, room));
  EXPECT_FALSE(addWall(wallNamed("askew", 9), {{-2, 0, -1}, {2, 0, -1}, {-1, 3, -1}}, room));
  ASSERT_EQ(room.walls.size(), 3u);
  EXPECT_EQ(room.walls[1].wall.name, "front-2");
  EXPECT_EQ(room.walls[1].wall.upperLeft_m, glm::dvec3(-2, 3, -1));
  EXPECT_EQ(room.walls[2].wall.pixels, glm::ivec2(1440, 1080)) << "4 × 3 m";
  const Said said = saidWithKinds(room);
  ASSERT_EQ(said.size(), 3u);
  EXPECT_EQ(said[0],
            "W 5: the name 'front' is that of the wall of line 3, too: this one is called 'front-2'");
  EXPECT_EQ(said[1], "W 7: nothing gives the pixels of wall 'bare'; 1440 × 1080 are taken");
  EXPECT_TRUE(said[2].starts_with("E 9: ")) << said[2];
}

TEST(RoomParts, ARectangleLiesAroundItsMiddle) {
  const ReadCorners corners = rectangleAround({1, 2, 3}, {0, 0, -1}, {0, 1, 0}, 4.0, 2.0);
  EXPECT_EQ(corners.lowerLeft_m, glm::dvec3(1, 1, 5));
  EXPECT_EQ(corners.lowerRight_m, glm::dvec3(1, 1, 1));
  EXPECT_EQ(corners.upperLeft_m, glm::dvec3(1, 3, 5));
}

TEST(RoomParts, PartsOfAWindowAreCutAtItsEdgesAndLieApart) {
  Room room = emptyRoom();
  const WindowPlacement window{.position_px = {100, 50}, .size_px = {800, 300}};
  RoomWall left = wallNamed("left", 1), right = wallNamed("right", 2), whole = wallNamed("whole", 3);
  placeInWindow(window, {0, 0}, {400, 300}, left, room);
  placeInWindow(window, {300, -10}, {600, 310}, right, room);
  placeInWindow(window, {0, 0}, {800, 300}, whole, room);
  EXPECT_FALSE(whole.wall.viewport);
  ASSERT_TRUE(right.wall.viewport);
  EXPECT_EQ(right.wall.viewport->position_px, glm::ivec2(300, 0));
  EXPECT_EQ(right.wall.viewport->size_px, glm::ivec2(500, 300));
  EXPECT_EQ(right.wall.pixels, glm::ivec2(500, 300));
  ASSERT_EQ(room.findings.size(), 1u);
  EXPECT_NE(saidWithKinds(room)[0].find("W 2: this part of 600 × 310 pixels at (300, -10) reaches out"),
            std::string::npos);
  addWall(left, kCorners, room);
  addWall(right, kCorners, room);
  separateOverlaps(room);
  EXPECT_TRUE(room.walls[0].wall.viewport);
  EXPECT_FALSE(room.walls[1].wall.viewport);
  EXPECT_EQ(room.walls[1].wall.window.position_px, glm::ivec2(400, 50));
  EXPECT_EQ(room.walls[1].wall.window.size_px, glm::ivec2(500, 300));
}

TEST(RoomParts, RanksFollowTheOrderInWhichTheyAreAskedFor) {
  Room room = emptyRoom();
  Ranks ranks(room);
  EXPECT_EQ(ranks.of("a", "", {1, 1}), 0);
  EXPECT_EQ(ranks.of("b", ":0", {2, 1}), 1);
  EXPECT_EQ(ranks.of("a", "", {3, 1}), 0);
  EXPECT_EQ(ranks.next("c", {4, 1}), 2);
  EXPECT_EQ(ranks.next("c", {5, 1}), 3);
  EXPECT_EQ(ranks.of("no host", "", {6, 1}), 4);
  ranks.finish();
  ASSERT_EQ(room.nodes.size(), 3u);
  EXPECT_EQ(room.nodes[1].display, ":0");
  EXPECT_EQ(room.nodes[2].host, "c");
  EXPECT_EQ(room.nodes[2].rank, 2);
  EXPECT_EQ(room.nodes[2].slots, 2);
  ASSERT_EQ(room.findings.size(), 1u);
  EXPECT_NE(saidWithKinds(room)[0].find("W 6: 'no host' is no name of a computer"), std::string::npos);
}

TEST(RoomParts, TrackersAreThereOnce) {
  Room room = emptyRoom();
  EXPECT_EQ(addVrpn("head", "Head@host", {}, {1, 1}, room), 0u);
  EXPECT_EQ(room.trackers[0].source, "Head@tcp://host");
  EXPECT_EQ(addVrpn("wand", "Head@host", {{1, 0, 0}, {1, 0, 0, 0}}, {2, 1}, room), 0u);
  EXPECT_EQ(addVrpn("head", "Wand@host", {}, {3, 1}, room), 1u);
  EXPECT_EQ(room.trackers[1].name, "head-2");
  EXPECT_EQ(addTrackd("memory", {.sensors = 4126, .wand = 4127, .unit_m = 0.01}, {}, {4, 1}, room), 2u);
  EXPECT_EQ(room.trackers[2].source, "shm://4126?wand=4127");
  EXPECT_EQ(addDtrack("art", 5000, {}, {5, 1}, room), 3u);
  EXPECT_FALSE(addDtrack("art", 99999, {}, {6, 1}, room));
  const Said said = saidWithKinds(room);
  ASSERT_EQ(said.size(), 3u);
  EXPECT_EQ(said[0],
            "W 2: tracker 'wand' is the one that is called 'head' here, whose place in the room counts");
  EXPECT_TRUE(said[2].starts_with("W 6: tracker 'art' is left out: ")) << said[2];
}

// The matrix of a random rotation gives the rotation again; a mirrored one gives none.
TEST(RoomParts, MatricesAreRotationsOrNone) {
  std::mt19937_64 random(4);
  std::normal_distribution<double> one;
  for (int i = 0; i < 100; ++i) {
    SCOPED_TRACE(i);
    const double w = one(random), x = one(random), y = one(random), z = one(random);
    const glm::dquat q = glm::normalize(glm::dquat(w, x, y, z));
    glm::dmat3 matrix = glm::mat3_cast(q);
    const auto found = rotationOf(matrix);
    ASSERT_TRUE(found);
    EXPECT_NEAR(std::abs(glm::dot(*found, q)), 1.0, 1e-12);
    matrix[0] = -matrix[0];
    EXPECT_FALSE(rotationOf(matrix));
  }
  EXPECT_FALSE(rotationOf(1.01 * glm::dmat3(1.0)));
}

// An axis that points to the right takes the room's x to itself, and so on.
TEST(RoomParts, AxesByTheirNamesAreATurn) {
  Room room = emptyRoom();
  const auto turn = turnOfAxes("X", "Z", "Y", {1, 1}, room);
  ASSERT_TRUE(turn);
  EXPECT_LT(glm::distance(*turn * glm::dvec3(0, 0, 1), glm::dvec3(0, 1, 0)), 1e-12) << "z is up";
  EXPECT_LT(glm::distance(*turn * glm::dvec3(0, 1, 0), glm::dvec3(0, 0, -1)), 1e-12) << "y is ahead";
  EXPECT_TRUE(room.findings.empty());
  EXPECT_FALSE(turnOfAxes("X", "Y", "Z", {2, 1}, room)) << "left-handed";
  EXPECT_FALSE(turnOfAxes("X", "up", "Y", {3, 1}, room));
  EXPECT_EQ(room.findings.size(), 2u);
}

TEST(RoomParts, UnitsAreThoseOfRigs) {
  Room room = emptyRoom();
  EXPECT_EQ(rigUnit_m(0.3048, {1, 1}, room), 0.3048);
  EXPECT_EQ(rigUnit_m(0.30479, {1, 1}, room), 0.3048) << "files round the foot";
  EXPECT_EQ(rigUnit_m(0.01, {1, 1}, room), 0.01);
  EXPECT_TRUE(room.findings.empty());
  EXPECT_FALSE(rigUnit_m(0.5, {1, 1}, room));
  EXPECT_EQ(room.findings.size(), 1u);
}

TEST(RoomParts, OneOfSeveralRoomsIsChosenByItsName) {
  const std::vector<std::string> names{"big", "small"};
  const std::vector<FilePlace> places{{4, 2}, {9, 2}};
  EXPECT_EQ(chooseRoom(names, places, "small", "a.x"), 1u);
  EXPECT_EQ(chooseRoom({"only"}, {{1, 1}}, "", "a.x"), 0u);
  for (const auto& [wanted, words] :
       {std::pair{"", "a.x:4:2: there are 2 rooms in this file, expected --room with one of 'big', 'small'"},
        {"tiny",
         "a.x:4:2: there is no room 'tiny' in this file, expected --room with one of 'big', 'small'"}}) {
    try {
      chooseRoom(names, places, wanted, "a.x");
      ADD_FAILURE() << wanted;
    } catch (const InputErrors& error) {
      EXPECT_STREQ(error.what(), words);
    }
  }
  EXPECT_NO_THROW(refuseRoomName("", "a.x"));
  EXPECT_THROW(refuseRoomName("big", "a.x"), InputErrors);
}

}  // namespace
}  // namespace carom
