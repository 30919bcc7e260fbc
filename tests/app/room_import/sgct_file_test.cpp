// Rooms of SGCT: a whole file, and faults with their places.
#include "app/room_import/sgct_file.h"

#include <gtest/gtest.h>

#include <cctype>
#include <filesystem>
#include <string>
#include <tuple>
#include <vector>

#include "app/fault_names.h"
#include "app/import_faults.h"
#include "app/room_checks/room_check.h"
#include "app/room_import/sgct_text.h"
#include "places.h"

namespace carom {
namespace {

namespace sgct = test::sgct;
using test::sgct::changed;
using Fault = test::ImportFault;

TEST(SgctFile, ReadsAWall) {
  const Room room = sgct::read(sgct::kGood);
  EXPECT_TRUE(room.findings.empty()) << room.findings[0].text;
  EXPECT_TRUE(judgeRoom(room).empty()) << judgeRoom(room)[0].text;
  ASSERT_EQ(room.walls.size(), 1u);
  const Wall& wall = room.walls[0].wall;
  EXPECT_EQ(wall.name, "front") << "named for where it is: SGCT has no names";
  EXPECT_EQ(wall.lowerRight_m, glm::dvec3(1.6, -0.9, 0.0));
  EXPECT_EQ(wall.pixels, glm::ivec2(1280, 720));
  EXPECT_EQ(wall.window.position_px, glm::ivec2(50, 60));
  EXPECT_EQ(wall.stereo, StereoMode::mono);
  EXPECT_EQ(room.eyeSeparation_m, 0.06);
  EXPECT_EQ(room.viewers.front().eyes_m, glm::dvec3(0, 0, 4));
  EXPECT_FALSE(room.oneWindow);
}

class SgctFaults : public ::testing::TestWithParam<Fault> {};

TEST_P(SgctFaults, ArePlacedAndExplained) { test::expectFound(GetParam(), sgct::read(GetParam().text)); }

INSTANTIATE_TEST_SUITE_P(
    All, SgctFaults,
    ::testing::Values(
        Fault{"a number in quotes",
              changed("\"z\": 0.0 },\n        \"upperleft", "\"z\": \"0/05\" },\n        \"upperleft"),
              8,
              51,
              {"z is the text '0/05'", "expected a number"}},
        Fault{"a coordinate missing",
              changed(", \"z\": 0.0 },\n        \"upperleft", " },\n        \"upperleft"),
              8,
              22,
              {"z is missing in lowerleft"}},
        Fault{"a corner missing",
              changed("\"upperleft\": { \"x\": -1.6, \"y\": 0.9, \"z\": 0.0 },", ""),
              6,
              21,
              {"upperleft is missing"}},
        Fault{"askew",
              changed("1.6, \"y\": 0.9, \"z\": 0.0 }\n", "1.6, \"y\": 0.95, \"z\": 0.0 }\n"),
              10,
              23,
              {"upperright of wall", "right angle at upperleft by 50.0 mm"}},
        Fault{"half a pixel",
              changed("1280", "1280.5"),
              4,
              49,
              {"x is 1280.5, expected a whole number from 1"}},
        Fault{"no size", changed(", \"size\": { \"x\": 1280, \"y\": 720 }", ""), 3, 66, {"size is missing"}},
        Fault{"too far", changed("\"z\": 4.0", "\"z\": 4e10"), 14, 68, {"expected a number from"}},
        Fault{"eyes below zero", changed("0.06", "-0.06"), 14, 32, {"eyeseparation is -0.06"}},
        Fault{"no wall", R"({ "version": 1 })", 1, 1, {"no viewport here shows a wall"}},
        Fault{"no object", "[1]", 1, 1, {"an array"}},
        Fault{"unknown key", changed("\"version\"", "\"versoin\""), 2, 3, {"'versoin'", "'version'?"}, false},
        Fault{"key given twice",
              changed("\"version\": 1,", "\"version\": 1, \"version\": 2,"),
              2,
              3,
              {"given twice"},
              false},
        Fault{"stereo",
              changed("\"pos\": { \"x\": 50", "\"stereo\": \"LineInterlaced\", \"pos\": { \"x\": 50"),
              4,
              15,
              {"'LineInterlaced'", "'side_by_side'"},
              false},
        Fault{"no such user",
              changed("\"projection\": {", "\"user\": \"me\", \"projection\": {"),
              6,
              15,
              {"no user 'me'"},
              false},
        Fault{"two users",
              changed("\"users\": [", "\"users\": [{ \"pos\": { \"x\": 0, \"y\": 0, \"z\": 4 } }, "),
              14,
              84,
              {"2 users"},
              false},
        Fault{"blend",
              changed("\"projection\": {", "\"blendmask\": \"a.png\", \"projection\": {"),
              6,
              20,
              {"blendmask"},
              false}),
    test::nameOfFault);

TEST(SgctFile, RefusesWhatIsNoJson) {
  const std::vector<std::tuple<std::string, int, int>> files{{changed("0.0 },\n", "0/05 },\n"), 8, 52},
                                                             {changed("1280", "1e999"), 4, 49},
                                                             {"{\n  \"a\": [1, 2\n", 3, 1},
                                                             {"", 1, 1},
                                                             {"{} x", 1, 4}};
  for (const auto& [text, line, column] : files) {
    try {
      sgct::read(text);
      ADD_FAILURE() << "was taken: " << text;
    } catch (const InputErrors& error) {
      EXPECT_EQ(error.line(), line) << text << ": " << error.what();
      EXPECT_EQ(error.column(), column) << text << ": " << error.what();
    }
  }
  EXPECT_THROW(sgct::read(std::string(100000, '[')), InputErrors);
}

TEST(SgctFile, ShippedExamplesOfSgctAreRight) {
  const std::filesystem::path rooms = CAROM_TESTS_DIR "/data/rooms";
  for (const char* name : {"sgct-docs__projectionplane.json", "sgct__config__3DTV.json"}) {
    const Room room = readSgct(rooms / name);
    EXPECT_TRUE(room.findings.empty()) << name << ": " << room.findings[0].text;
    EXPECT_TRUE(judgeRoom(room).empty()) << name << ": " << judgeRoom(room)[0].text;
  }
}

}  // namespace
}  // namespace carom
