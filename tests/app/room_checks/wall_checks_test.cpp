// Checks of single walls: pixels, windows, names, and where the eyes are.
#include "app/room_checks/wall_checks.h"

#include <gtest/gtest.h>

#include <string>

#include "app/fault_names.h"
#include "app/room_checks/judged_room.h"
#include "app/room_checks/room_check.h"

namespace carom {
namespace {

using test::allOf;
using test::headAt;
using test::kRoom;
using test::Mistake;
using test::Mistakes;
using test::roomWith;

TEST(RoomCheck, SquareTelevisionPicturesMayBeSqueezedOrNot) {
  for (const char* size : {"[600, 600]", "[1200, 600]"}) {
    const std::string window = std::string("window = { size = ") + size + " }\nstereo = 'side-by-side'";
    EXPECT_EQ(allOf(judgeRoom(roomWith({{16, window}}))), "") << size;
  }
  EXPECT_NE(allOf(judgeRoom(roomWith({{16, "window = { size = [600, 1200] }\nstereo = 'side-by-side'"}}))),
            "");
}

TEST(RoomCheck, NamesOfTilesAndEyesAreNoSides) {
  // Two tiles of the front wall, left and right of the middle: right names, then swapped.
  const std::string leftHalf[3] = {"[-1.5, 0, -1.5]", "[0, 0, -1.5]", "[-1.5, 3, -1.5]"};
  const std::string rightHalf[3] = {"[0, 0, -1.5]", "[1.5, 0, -1.5]", "[0, 3, -1.5]"};
  const auto tiles = [&](const std::string& first, const std::string& second) {
    return judgeRoom(roomWith({{10, "name = '" + first + "'"},
                               {11, "lower_left = " + leftHalf[0]},
                               {12, "lower_right = " + leftHalf[1]},
                               {13, "upper_left = " + leftHalf[2]},
                               {14, "pixels = [300, 600]"},
                               {16, "window = { size = [300, 600] }"},
                               {18, "name = '" + second + "'"},
                               {19, "lower_left = " + rightHalf[0]},
                               {20, "lower_right = " + rightHalf[1]},
                               {21, "upper_left = " + rightHalf[2]},
                               {22, "pixels = [300, 600]"},
                               {24, "window = { size = [300, 600] }"}}));
  };
  EXPECT_EQ(allOf(tiles("left", "right")), "");
  EXPECT_EQ(allOf(tiles("front-left", "front-right")), "");
  EXPECT_EQ(tiles("right", "left").size(), 2u) << allOf(tiles("right", "left"));
}

// One looks at the front wall ahead, at a wall on the left to the left, and down at the floor.
TEST(WallChecks, AWallIsOnTheSideInWhichOneLooksAtIt) {
  const Room room = roomWith({});
  EXPECT_EQ(lookedAt(room.walls[0].wall, room.axes).where, "ahead");
  EXPECT_EQ(lookedAt(room.walls[1].wall, room.axes).where, "on the left");
  EXPECT_EQ(lookedAt(room.walls[2].wall, room.axes).where, "below");
  const RoomAxes turned{.right = -room.axes.right, .up = room.axes.up, .forward = -room.axes.forward};
  EXPECT_EQ(lookedAt(room.walls[0].wall, turned).where, "behind");
  EXPECT_EQ(lookedAt(room.walls[1].wall, turned).where, "on the right");
}

INSTANTIATE_TEST_SUITE_P(
    Walls, Mistakes,
    ::testing::Values(
        Mistake{"too far",
                {{11, "lower_left = [-1500, 0, -1500]"},
                 {12, "lower_right = [1500, 0, -1500]"},
                 {13, "upper_left = [-1500, 3000, -1500]"}},
                9,
                1,
                {"1500000 mm before wall 'front'", "1500 mm would be 1500.0 mm"},
                2},
        Mistake{"pixels not square",
                {{14, "pixels = [600, 480]"}, {16, "window = { size = [600, 480] }"}},
                14,
                10,
                {"200.0 px/m across, 160.0 px/m up (25 % apart)"}},
        Mistake{"stretched by the window",
                {{16, "window = { size = [600, 500] }"}},
                16,
                10,
                {"600 × 500 pixels, stretches its picture of 600 × 600"}},
        Mistake{"named for the other side",
                {{18, "name = 'right'"}},
                18,
                8,
                {"on the left, against its name", "1500 mm to the left"}},
        Mistake{"named for another wall",
                {{10, "name = 'floor2'"}},
                10,
                8,
                {"ahead, against its name", "1500 mm ahead"}},
        Mistake{"mirrored corners",
                {{11, "lower_left = [1.5, 0, -1.5]"},
                 {12, "lower_right = [-1.5, 0, -1.5]"},
                 {13, "upper_left = [1.5, 3, -1.5]"}},
                9,
                1,
                {"1500 mm behind wall 'front'", "turn a wall away"}},
        Mistake{"head behind a wall", headAt("[0, 0, -2]"), 10, 1, {"start is 500 mm behind wall 'front'"}},
        Mistake{"head in a wall", headAt("[0, 0, -1.5]"), 10, 1, {"in the plane of wall 'front'"}},
        Mistake{"head too near",
                headAt("[0, 0, -1.4]"),
                10,
                1,
                {"100 mm before wall 'front', expected at least 200 mm"}}),
    test::nameOfFault);

}  // namespace
}  // namespace carom
