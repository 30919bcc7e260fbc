#include "app/room_import/room_check.h"

#include <gtest/gtest.h>

#include <random>

#include "app/room_import/rig_room.h"
#include "app/temporary_folder.h"
#include "places.h"

namespace carom {
namespace {

using test::TemporaryFolder;

/// A room of three walls, a rank each, nothing odd about it. Line i is kRoom[i - 1].
const std::vector<std::string> kRoom{
    "unit = 'm'",
    "axes = 'x-right y-up z-back'",
    "[head]",
    "tracker = 'cap'",
    "eye_separation = 0.064",
    "[[tracker]]",
    "name = 'cap'",
    "kind = 'simulated'",
    "[[wall]]",
    "name = 'front'",
    "lower_left = [-1.5, 0, -1.5]",
    "lower_right = [1.5, 0, -1.5]",
    "upper_left = [-1.5, 3, -1.5]",
    "pixels = [600, 600]",
    "node = 0",
    "window = { size = [600, 600] }",
    "[[wall]]",
    "name = 'left'",
    "lower_left = [-1.5, 0, 1.5]",
    "lower_right = [-1.5, 0, -1.5]",
    "upper_left = [-1.5, 3, 1.5]",
    "pixels = [600, 600]",
    "node = 1",
    "window = { size = [600, 600] }",
    "[[wall]]",
    "name = 'floor'",
    "lower_left = [-1.5, 0, 1.5]",
    "lower_right = [1.5, 0, 1.5]",
    "upper_left = [-1.5, 0, -1.5]",
    "pixels = [600, 600]",
    "node = 2",
    "window = { size = [600, 600] }",
};

using Edits = std::vector<std::pair<std::size_t, std::string>>;

Room roomWith(const Edits& edits) {
  std::vector<std::string> lines = kRoom;
  for (const auto& [line, text] : edits) {
    if (line > lines.size()) lines.resize(line);
    lines[line - 1] = text;
  }
  std::string text;
  for (const std::string& line : lines) text += line + '\n';
  const TemporaryFolder folder;
  const auto file = folder.file("room.toml", text);
  return roomOf(readPlacedRig(file), file);
}

std::string allOf(const std::vector<Finding>& findings) {
  std::string text;
  for (const Finding& finding : findings) {
    text += std::to_string(finding.at.line) + ':' + std::to_string(finding.at.column) + ": " + finding.text +
            '\n';
  }
  return text;
}

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

struct Mistake {
  const char* what;
  Edits edits;
  int line, column;
  std::vector<const char*> words;  // of one finding
  std::size_t findings = 1;        // in all: one mistake may offend several walls
};

std::ostream& operator<<(std::ostream& out, const Mistake& mistake) { return out << mistake.what; }

class Mistakes : public ::testing::TestWithParam<Mistake> {};

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

Edits secondWall(const std::string& name, const std::string& lowerLeft, const std::string& lowerRight,
                 const std::string& upperLeft, const std::string& window = "window = { size = [600, 600] }") {
  return {{18, "name = '" + name + "'"},
          {19, "lower_left = " + lowerLeft},
          {20, "lower_right = " + lowerRight},
          {21, "upper_left = " + upperLeft},
          {24, window}};
}

Edits with(Edits edits, const Edits& more) {
  edits.insert(edits.end(), more.begin(), more.end());
  return edits;
}

Edits headAt(const std::string& place) {
  return {{8, "kind = 'simulated'\nroom_from_tracker = { translation = " + place + " }"}};
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
        Mistake{"an edge apart",
                {{11, "lower_left = [-1.5, 0, -1.524]"},
                 {12, "lower_right = [1.5, 0, -1.524]"},
                 {13, "upper_left = [-1.5, 3, -1.524]"}},
                21,
                14,
                {"'front' and 'left' miss each other by 24.0 mm"},
                2},
        Mistake{"ends apart",
                secondWall("left", "[-1.5, 0.02, 1.5]", "[-1.5, 0.02, -1.5]", "[-1.5, 3.02, 1.5]"),
                21,
                14,
                {"'front' and 'left' miss each other by 20.0 mm"},
                2},
        Mistake{"a floor too high",
                {{27, "lower_left = [-1.5, 0.01, 1.5]"},
                 {28, "lower_right = [1.5, 0.01, 1.5]"},
                 {29, "upper_left = [-1.5, 0.01, -1.5]"}},
                29,
                14,
                {"'left' and 'floor' miss each other by 10.0 mm"},
                2},
        Mistake{"a tile off the plane",
                secondWall("front-b", "[1.5, 0, -1.51]", "[4.5, 0, -1.51]", "[1.5, 3, -1.51]"),
                21,
                14,
                {"tiles 'front' and 'front-b' are 10.0 mm off one plane"}},
        Mistake{"eyes' walls apart",
                with(secondWall("front-r", "[-1.495, 0, -1.5]", "[1.505, 0, -1.5]", "[-1.495, 3, -1.5]",
                                kRoom[23] + " \nstereo = 'right'"),
                     {{16, kRoom[15] + " # left\nstereo = 'left'"}}),
                22,
                14,
                {"the two eyes' walls 'front' and 'front-r' differ by 5.0 mm at a corner"},
                2},
        Mistake{"one wall twice",
                secondWall("screen", "[-1.5, 0, -1.5]", "[1.5, 0, -1.5]", "[-1.5, 3, -1.5]"),
                17,
                1,
                {"'front' and 'screen' are on the same place and show the same eyes"}},
        Mistake{"walls that cut",
                with(secondWall("screen", "[-1, 0.5, -2]", "[1, 0.5, -1]", "[-1, 2.5, -2]",
                                "window = { size = [671, 600] }"),
                     {{22, "pixels = [671, 600]"}}),
                17,
                1,
                {"cut through each other, 500 mm inside the edge"}},
        Mistake{"head behind a wall", headAt("[0, 0, -2]"), 10, 1, {"start is 500 mm behind wall 'front'"}},
        Mistake{"head in a wall", headAt("[0, 0, -1.5]"), 10, 1, {"in the plane of wall 'front'"}},
        Mistake{"head too near",
                headAt("[0, 0, -1.4]"),
                10,
                1,
                {"100 mm before wall 'front', expected at least 200 mm"}},
        Mistake{
            "head too high", headAt("[0, 1, 0]"), 3, 1, {"2700 mm above the floor, expected 900 to 2200 mm"}},
        Mistake{"a rank left out", {{31, "node = 3"}}, 31, 8, {"drawn by rank 3, but rank 2 has no wall"}},
        Mistake{"a node without a wall",
                {{33, "[[node]]\nrank = 7\ndisplay = ':0'"}},
                33,
                1,
                {"rank 7 has display :0 but no wall"}},
        Mistake{"windows on each other",
                {{23, "node = 0"},
                 {24, "window = { size = [600, 600], position = [500, 100] }"},
                 {31, "node = 1"}},
                24,
                10,
                {"overlap by 100 × 500 pixels on monitor 0 of rank 0"}}),
    [](const auto& tested) {
      std::string name = tested.param.what;
      std::erase_if(name, [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); });
      return name;
    });

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

TEST(RoomCheck, SaysHowFarAMovedWallIsFromItsNeighbours) {
  const unsigned seed = 11;
  std::mt19937 random(seed);
  for (int i = 0; i < 50; ++i) {
    // The front wall moved off by more than may be and less than is on purpose.
    const double moved_m = std::uniform_real_distribution(0.0022, 0.098)(random);
    Room room = roomWith({});
    for (glm::dvec3* corner : {&room.walls[0].wall.lowerLeft_m, &room.walls[0].wall.lowerRight_m,
                               &room.walls[0].wall.upperLeft_m}) {
      corner->z -= moved_m;
    }
    char expected[32];
    std::snprintf(expected, sizeof expected, "by %.1f mm", moved_m * 1e3);
    const std::vector<Finding> findings = judgeRoom(room);
    ASSERT_EQ(findings.size(), 2u) << "seed " << seed << ", moved by " << moved_m << '\n' << allOf(findings);
    for (const Finding& finding : findings) {
      EXPECT_NE(finding.text.find(expected), std::string::npos) << "seed " << seed << ": " << finding.text;
    }
  }
}

}  // namespace
}  // namespace carom
