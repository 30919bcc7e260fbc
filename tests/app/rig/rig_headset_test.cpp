// A rig whose walls hang on the head.
#include "app/rig/rig_headset.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <string>

#include "app/rig/rig_text.h"
#include "cave/room/wall.h"

namespace carom {
namespace {

using test::expectNear;
using test::Fault;
using test::kGood;
using test::read;
using test::RigFaults;

/// The rig of a headset, with one piece of it changed.
std::string headset(const std::string& from = "", const std::string& to = "") {
  std::string text =
      "unit = 'cm'\n"
      "axes = 'x-right y-up z-back'\n"
      "[headset]\n"
      "board = { lower_left = [-120, 120, -240], lower_right = [120, 120, -240], upper_left = [-120, 270, "
      "-240] }\n";
  if (from.empty()) return text;
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST(Rig, OfAHeadsetHasTwoWallsOnTheHeadAndABoardInTheRoom) {
  const Rig rig = read(headset());
  ASSERT_TRUE(isHeadset(rig));
  ASSERT_EQ(rig.walls.size(), 2U);
  for (const Wall& wall : rig.walls) EXPECT_TRUE(wall.onHead) << wall.name;
  EXPECT_EQ(rig.walls[0].stereo, StereoMode::left);
  EXPECT_EQ(rig.walls[1].stereo, StereoMode::right);
  EXPECT_TRUE(standingWalls(rig).empty());
  expectNear(rig.board->upperLeft_m, {-1.2, 2.7, -2.4});
  EXPECT_EQ(rig.board->pixels, glm::ivec2(1280, 800));
  ASSERT_EQ(rig.trackers.size(), 1U);
  EXPECT_EQ(rig.trackers[0].kind, TrackerKind::headset);
  EXPECT_EQ(rig.viewers.front().hand->sensor, 1);
  EXPECT_EQ(read(headset("270, -240]", "270, -240], pixels = [640, 400]")).board->pixels,
            glm::ivec2(640, 400));
}

// Each eye's half of the mirror gets the shape of the eye's picture; the mirror's height stays.
TEST(Rig, FitsTheMirrorToThePicturesOfTheEyes) {
  Rig rig = read(headset() + "[one_window]\nsize = [1000, 600]\n");
  EXPECT_EQ(rig.walls[1].window.position_px, glm::ivec2(500, 0));
  EXPECT_EQ(rig.walls[1].window.size_px, glm::ivec2(500, 600));
  fitEyes(rig, {1500, 2000});
  EXPECT_EQ(rig.oneWindow->size_px, glm::ivec2(900, 600));
  for (std::size_t eye = 0; eye < 2; ++eye) {
    SCOPED_TRACE(eye);
    EXPECT_EQ(rig.walls[eye].pixels, glm::ivec2(1500, 2000));
    EXPECT_EQ(rig.walls[eye].window.position_px, glm::ivec2(450 * static_cast<int>(eye), 0));
    EXPECT_EQ(rig.walls[eye].window.size_px, glm::ivec2(450, 600));
  }
}

INSTANTIATE_TEST_SUITE_P(
    Headset, RigFaults,
    ::testing::Values(
        Fault{"other axes", headset("'x-right y-up z-back'", "'x-right y-forward z-up'"), 2, 8,
              "a headset measures along 'x-right y-up z-back'"},
        Fault{"a wall", headset() + kGood.substr(kGood.find("[[wall]]")), 5, 1,
              "has no meaning in the rig of a headset"},
        Fault{"a tracker", headset() + "[[tracker]]\nname = 'cap'\nkind = 'simulated'\n", 5, 1,
              "has no meaning in the rig of a headset"},
        Fault{"no board", headset("board", "bored"), 4, 1, "unknown key 'bored'"},
        Fault{"a board seen from behind",
              headset("lower_left = [-120, 120, -240], lower_right = [120, 120, -240], upper_left = [-120",
                      "lower_left = [120, 120, -240], lower_right = [-120, 120, -240], upper_left = [120"),
              4, 9, "the board does not face somebody who looks forward"},
        Fault{"a board to the left",
              headset("lower_right = [120, 120, -240]", "lower_right = [-120, 120, -480]"), 4, 9,
              "the board does not face somebody who looks forward"},
        Fault{"a board that is no rectangle", headset("120, 120, -240], upper", "120, 150, -240], upper"), 4,
              88, "misses the right angle"},
        Fault{"a board of too many pixels", headset("270, -240]", "270, -240], pixels = [640, 5000]"), 4, 122,
              "expected a whole number from 1 to 4096"}),
    test::nameOfFault);

}  // namespace
}  // namespace carom
