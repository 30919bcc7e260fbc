// Whole rooms: right ones, of which nothing is to be said, and mistakes with their places.
#include "app/room_checks/room_check.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "app/fault_names.h"
#include "app/room_checks/judged_room.h"
#include "places.h"

namespace carom {
namespace {

using test::allOf;
using test::headAt;
using test::kRoom;
using test::Mistake;
using test::Mistakes;
using test::roomWith;

TEST(RoomCheck, HasNothingToSayOfARightRoom) { EXPECT_EQ(allOf(judgeRoom(roomWith({}))), ""); }

TEST(RoomCheck, HasNothingToSayOfShippedRigs) {
  for (const auto& entry : std::filesystem::directory_iterator(CAROM_CONFIG_DIR "/rigs")) {
    const PlacedRig rig = readPlacedRig(entry.path());
    if (isHeadset(rig.rig)) continue;  // its walls hang on the head: it has no room
    EXPECT_EQ(allOf(judgeRoom(roomOf(rig, entry.path()))), "") << entry.path();
  }
}

TEST(RoomCheck, SaysInWordsWhatIsRight) {
  const Room room = roomWith({{11, "lower_left = [-1.524, 0, -1.524]"},
                              {12, "lower_right = [1.524, 0, -1.524]"},
                              {13, "upper_left = [-1.524, 3.048, -1.524]"},
                              {14, "pixels = [2560, 2560]"}});
  EXPECT_EQ(
      wordsFor(room.walls[0], room).rfind("front: 3.048 × 3.048 m (10 ft), 840 px/m, 1.52 m ahead\n", 0), 0u)
      << wordsFor(room.walls[0], room);
  EXPECT_NE(wordsFor(room.walls[1], room).find("1.50 m on the left"), std::string::npos);
  EXPECT_NE(wordsFor(room.walls[2], room).find("1.70 m below\n  3000 × 3000 mm"), std::string::npos);
}

TEST_P(Mistakes, AreFoundAtTheirPlaceWithTheirNumber) {
  const std::vector<Finding> findings = judgeRoom(roomWith(GetParam().edits));
  EXPECT_EQ(findings.size(), GetParam().findings) << allOf(findings);
  const bool found = std::any_of(findings.begin(), findings.end(), [](const Finding& finding) {
    bool all = finding.at.line == GetParam().line && finding.at.column == GetParam().column;
    for (const char* words : GetParam().words) all = all && finding.text.find(words) != std::string::npos;
    return all && finding.kind == Finding::Kind::warning;
  });
  EXPECT_TRUE(found) << allOf(findings);
}

INSTANTIATE_TEST_SUITE_P(
    All, Mistakes,
    ::testing::Values(
        Mistake{"eyes in feet",
                {{5, "eye_separation = 0.21"}},
                5,
                18,
                {"210.0 mm apart", "0.21 ft would be 64.0 mm"}},
        Mistake{"eyes in one place",
                {{5, "eye_separation = 0"}, {16, kRoom[15] + "\nstereo = 'anaglyph'"}},
                5,
                18,
                {"0.0 mm apart, expected 50 to 80 mm"}},
        Mistake{"metres taken for feet",
                {{1, "unit = 'ft'"}},
                5,
                18,
                {"19.5 mm apart", "0.064 m would be 64.0 mm"}},
        Mistake{"millimetres taken for metres",
                {{11, "lower_left = [-1500, 0, -1500]"},
                 {12, "lower_right = [1500, 0, -1500]"},
                 {13, "upper_left = [-1500, 3000, -1500]"}},
                13,
                14,
                {"3000000 × 3000000 mm", "3000 mm would be 3000.0 mm"},
                2},
        Mistake{
            "head too high", headAt("[0, 1, 0]"), 3, 1, {"2700 mm above the floor, expected 900 to 2200 mm"}},
        Mistake{"a rank left out", {{31, "node = 3"}}, 31, 8, {"drawn by rank 3, but rank 2 has no wall"}},
        Mistake{"a node without a wall",
                {{33, "[[node]]\nrank = 7\ndisplay = ':0'"}},
                33,
                1,
                {"rank 7 has display :0 but no wall"}}),
    test::nameOfFault);

}  // namespace
}  // namespace carom
