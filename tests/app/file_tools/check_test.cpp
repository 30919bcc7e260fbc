#include "app/file_tools/check.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <tuple>

#include <algorithm>

#include "app/program.h"
#include "places.h"

namespace carom {
namespace {

using test::runCarom;
using test::TemporaryFolder;

TEST(Check, TellsWhatARigIs) {
  const TemporaryFolder folder;
  const auto result = runCarom(folder, {"check", CAROM_CONFIG_DIR "/rigs/four-walls-cluster.toml"});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(result.err, "");
  for (const char* words : {"front: 3.000 × 3.000 m (9.84 ft), 360 px/m, 1.50 m ahead",
                            "3000 × 3000 mm, 1080 × 1080 pixels an eye", "1.70 m below"}) {
    EXPECT_NE(result.out.find(words), std::string::npos) << result.out;
  }
  EXPECT_NE(result.out.find("eyes 64.0 mm apart"), std::string::npos) << result.out;
}

// A rig of several computers whose second one is forgotten is right for `carom cave`, but not for a room.
TEST(Check, WarnsOfANodeWithoutAHost) {
  const TemporaryFolder folder;
  std::string text = test::contentOf(CAROM_CONFIG_DIR "/rigs/four-walls-cluster.toml");
  for (const int rank : {0, 1, 3}) text += fmt::format("\n[[node]]\nrank = {0}\nhost = \"pc-{0}\"\n", rank);
  const auto result = runCarom(folder, {"check", folder.file("room.toml", text)});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_NE(result.err.find("warning: "), std::string::npos) << result.err;
  EXPECT_NE(result.err.find("node 2 of the rig has no host though others have, expected a [[node]]"),
            std::string::npos)
      << result.err;
}

TEST(Check, TellsWhatAScenarioIs) {
  const TemporaryFolder folder;
  const auto result = runCarom(folder, {"check", CAROM_CONFIG_DIR "/scenarios/three-pucks.toml"});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_NE(result.out.find("light at 1.42 m/s"), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("puck white: radius 30.5 mm"), std::string::npos) << result.out;
  EXPECT_NE(result.out.find("0.8 c (γ = 1.667)"), std::string::npos) << result.out;
}

TEST(Check, SaysWhatASkewedScreenCosts) {
  const TemporaryFolder folder;
  std::string text = test::contentOf(CAROM_CONFIG_DIR "/rigs/single-screen.toml");
  const std::size_t at = text.find("lower_left");
  const auto line = [&](const std::string& key) {
    const std::size_t begin = text.find(key);
    text.erase(begin, text.find('\n', begin) + 1 - begin);
  };
  for (const char* key : {"lower_left", "lower_right", "upper_left"}) line(key);
  text.insert(
      at,
      "lower_left = [-1.00, 1.0, -1.5]\nlower_right = [0.96, 1.02, -1.5]\nupper_left = [-0.97, 2.1, -1.5]\n"
      "upper_right = [1.00, 2.0825, -1.494]\nskewed = true\n");
  const auto result = runCarom(folder, {"check", folder.file("skewed.toml", text)});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_NE(result.out.find("skewed: its corners lie up to "), std::string::npos) << result.out;
  EXPECT_NE(result.out.find(" and 1.5 mm off one plane"), std::string::npos) << result.out;
  EXPECT_NE(result.out.find(" % of the pixels fall beside the screen"), std::string::npos) << result.out;
}

TEST(Check, WarnsOfGamesThatCannotBeShownWell) {
  const TemporaryFolder folder;
  const auto warned = [&](const std::string& text) {
    const auto result = runCarom(folder, {"check", folder.file("odd.toml", text)});
    EXPECT_EQ(result.status, 0) << result.err;
    return result.err;
  };
  const std::string puck =
      "[[puck]]\nname = 'white'\nradius_m = 0.03\nmass_kg = 0.2\nposition_m = [0, 0]\nbeta = [0, 0]\n";
  EXPECT_EQ(warned("light_speed_m_s = 1.42\n[board]\nlength_m = 2.84\nwidth_m = 1.42\n" + puck), "");
  const std::string large =
      warned("light_speed_m_s = 1.42\n[board]\nlength_m = 1000\nwidth_m = 1000\n" + puck);
  for (const char* words : {"1e+03 m long", "704 s along the board", "puck white has a radius of 0.03 m"})
    EXPECT_NE(large.find(words), std::string::npos) << large;
  EXPECT_NE(warned("light_speed_m_s = 3e8\n[board]\nlength_m = 2.84\nwidth_m = 1.42\n" + puck)
                .find("nothing looks relativistic"),
            std::string::npos);
}

TEST(Check, TellsOfALessonWhatVisitorsWouldFindOut) {
  const TemporaryFolder folder;
  const std::string shipped = test::contentOf(CAROM_CONFIG_DIR "/scenarios/cause.toml");
  const auto checked = [&](const std::string& key, const std::string& line) {
    std::string text = shipped;
    const std::size_t begin = text.find("\n" + key + " = ") + 1;
    text.replace(begin, text.find('\n', begin) - begin, line);
    return runCarom(folder, {"check", folder.file("lesson.toml", text)});
  };
  const auto lines = [](const std::string& text) { return std::count(text.begin(), text.end(), '\n'); };
  EXPECT_EQ(checked("moment_s", "moment_s = 3.0").err, "");
  const auto outside = checked("moment_s", "moment_s = 9.0");
  EXPECT_NE(outside.err.find(":26:12: moment_s is 9, which lies outside what the lesson shows"),
            std::string::npos)
      << outside.err;
  const auto missing = checked("until_s", "");
  EXPECT_NE(missing.err.find("until_s is missing here"), std::string::npos) << missing.err;
  EXPECT_EQ(lines(missing.err), 1) << "nothing else is known to be wrong: " << missing.err;
  std::string number = "number = \"";
  while (number.size() < 260) number += "long ";
  const auto tooLong = checked("number", number + "\"");
  EXPECT_NE(tooLong.err.find("number has "), std::string::npos) << tooLong.err;
}

// Each text is allowed, and yet all of them together are more than a band of the shipped walls holds.
TEST(Check, WarnsOfALessonThatIsLongerThanItsBand) {
  const TemporaryFolder folder;
  std::string text = test::contentOf(CAROM_CONFIG_DIR "/scenarios/cause.toml");
  const std::string answer(69, 'w');
  for (const char* old : {"Both: both come later than A", "B only", "C only: it comes sooner", "Neither"})
    text.replace(text.find(old), std::string(old).size(), answer);
  const auto result = runCarom(folder, {"check", folder.file("long.toml", text)});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_NE(result.err.find("the lesson's longest text is longer than the band on the wall"),
            std::string::npos)
      << result.err;
}

TEST(Check, FindsShippedFilesOfBothKindsByTheirNames) {
  const TemporaryFolder folder;
  for (const char* name : {"desk", "three-pucks"})
    EXPECT_EQ(runCarom(folder, {"check", name}).status, 0) << name;
  EXPECT_NE(runCarom(folder, {"check", "three-puck"}).err.find("expected 'three-pucks'?"), std::string::npos);
}

TEST(Check, CountsInWords) {
  const TemporaryFolder folder;
  const auto result = runCarom(folder, {"check", CAROM_CONFIG_DIR "/rigs/single-screen.toml"});
  EXPECT_NE(result.out.find("a rig of 1 wall at 60 Hz"), std::string::npos) << result.out;
}

TEST(Check, WarnsAndGoesOn) {
  const TemporaryFolder folder;
  std::string text = test::contentOf(CAROM_CONFIG_DIR "/rigs/single-screen.toml");
  const std::string right = "eye_separation = 0.064";
  text.replace(text.find(right), right.size(), "eye_separation = 0.21");
  const std::string file = folder.file("feet.toml", text);
  const auto result = runCarom(folder, {"check", file});
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.err.rfind("warning: " + file + ":11:18: the eyes are 210.0 mm apart", 0), 0u)
      << result.err;
}

TEST(Check, NamesTheKindsThatItKnows) {
  const TemporaryFolder folder;
  for (const auto& [name, text, begin] :
       {std::tuple{"config.xml", "<?xml version=\"1.0\"?>\n<html/>\n",
                   ":2:1: the first element is <html>, expected a room of "},
        {"room", "{ \"walls\": [] }",
         ":1:1: this object has neither 'nodes', 'nDisplay' nor 'platforms', expected a room of "},
        {"picture.png", "\x89PNG\r\n\x1a\n",
         ":1:1: this is no file of a kind that is known here, expected a .toml of Carom or a room of "}}) {
    const std::string file = folder.file(name, text);
    const auto result = runCarom(folder, {"check", file});
    EXPECT_EQ(result.status, 1) << name;
    EXPECT_EQ(result.err.rfind("error: " + file + begin, 0), 0u) << result.err;
    EXPECT_NE(result.err.find("OpenCOVER"), std::string::npos) << result.err;
  }
  const auto broken = runCarom(folder, {"check", folder.file("rig.toml", "unit = <\n")});
  EXPECT_NE(broken.err.find("rig.toml:1:"), std::string::npos) << broken.err;
  EXPECT_EQ(broken.err.find("known here"), std::string::npos)
      << "of a .toml its mistake is told: " << broken.err;
  const auto missing = runCarom(folder, {"check", folder / "nowhere.xml"});
  EXPECT_EQ(missing.err.find("known here"), std::string::npos) << missing.err;
}

TEST(Check, TellsErrorsOfForeignRoomsAndWhatIsRightInThem) {
  const TemporaryFolder folder;
  const std::string file = folder.file(
      "room.pvx",
      "<pvx>\n<Machine Name='Front' Geometry='300x300+0+0' LowerLeft='-1 -1 -1' LowerRight='1 -1 -1' "
      "UpperRight='1 1 -1'/>\n"
      "<Machine Name='Left' Geometry='300x300+0+0' LowerLeft='-1 -1 1' LowerRight='-1 -1 -1' "
      "UpperRight='-1 1 -1'\n IgnoredKey='garbage'/>\n<Machine LowerLeft='a b c'/></pvx>\n");
  const auto result = runCarom(folder, {"check", file});
  EXPECT_EQ(result.status, 1);
  EXPECT_NE(result.err.find("warning: " + file + ":4:2: unknown key 'IgnoredKey'"), std::string::npos)
      << result.err;
  EXPECT_NE(result.err.find("error: " + file + ":5:1: "), std::string::npos) << result.err;
  EXPECT_NE(result.out.find("Front: 2.000 × 2.000 m (6.56 ft), 150 px/m, 1.00 m ahead"), std::string::npos)
      << result.out;
}

TEST(Check, RefusesWhatItDoesNotKnow) {
  const TemporaryFolder folder;
  const std::vector<std::pair<std::string, std::string>> files{
      {"room.pvx", "<pvx/>"}, {"room.json", "{}"}, {"other.toml", "colour = 'red'\n"}};
  for (const auto& [name, text] : files) {
    const std::string file = folder.file(name, text);
    const auto result = runCarom(folder, {"check", file});
    EXPECT_EQ(result.status, 1) << name;
    EXPECT_EQ(result.err.rfind("error: " + file + ":1:1: ", 0), 0u) << result.err;
  }
}

}  // namespace
}  // namespace carom
