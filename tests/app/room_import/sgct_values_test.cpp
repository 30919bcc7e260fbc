// Values of SGCT's room files: what is read, what is said of wrong ones, and of keys that are not known.
#include "app/room_import/sgct_values.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "app/temporary_folder.h"

namespace carom {
namespace {

JsonNode jsonOf(const std::string& text) {
  const test::TemporaryFolder folder;
  return readJson(folder.file("a.json", text));
}

/// "LINE:COLUMN" of each finding, with E for an error and W for a warning, and its text.
std::vector<std::string> saidOf(const Room& room) {
  std::vector<std::string> said;
  for (const Finding& finding : room.findings)
    said.push_back(fmt::format("{} {}:{} {}", finding.kind == Finding::Kind::error ? 'E' : 'W',
                               finding.at.line, finding.at.column, finding.text));
  return said;
}

using Said = std::vector<std::string>;

TEST(SgctValues, NumbersAreInTheirRangeOrSaid) {
  const JsonNode root = jsonOf("{\"a\": 3, \"b\": 2.5, \"c\": \"3\", \"d\": -1}");
  constexpr Range kRange{.least = 0.0, .most = 10.0};
  Room room;
  EXPECT_EQ(number(root, "a", kRange, true, room), 3.0);
  EXPECT_EQ(number(root, "b", kRange, false, room), 2.5);
  EXPECT_FALSE(number(root, "none", kRange, false, room)) << "what is left out is no error";
  EXPECT_EQ(saidOf(room), Said{});
  EXPECT_FALSE(number(root, "b", kRange, true, room));
  EXPECT_FALSE(number(root, "c", kRange, false, room));
  EXPECT_FALSE(number(root, "d", kRange, false, room));
  EXPECT_EQ(saidOf(room), (Said{"E 1:15 b is 2.5, expected a whole number from 0 to 10",
                                "E 1:25 c is the text '3', expected a number from 0 to 10",
                                "E 1:35 d is -1, expected a number from 0 to 10"}));
}

TEST(SgctValues, VectorsHaveAllTheirCoordinates) {
  const JsonNode root =
      jsonOf("{\"p\": {\"x\": 1, \"y\": 2, \"z\": 3},\n\"q\": {\"x\": 1, \"z\": 2},\n\"r\": 5}");
  Room room;
  const auto whole = numbers<3>(root, "p", {}, false, room);
  ASSERT_TRUE(whole);
  EXPECT_EQ(*whole, (std::array<double, 3>{1.0, 2.0, 3.0}));
  EXPECT_FALSE(numbers<2>(root, "none", {}, false, room));
  EXPECT_EQ(saidOf(room), Said{});
  EXPECT_FALSE(numbers<3>(root, "q", {}, false, room));
  EXPECT_FALSE(numbers<2>(root, "r", {}, false, room));
  EXPECT_EQ(saidOf(room), (Said{"E 2:6 y is missing in q", "E 3:6 r is 5, expected {x, y}"}));
}

TEST(SgctValues, UnknownAndRepeatedKeysAreWarnings) {
  const std::vector<std::string_view> known{"size", "pos"};
  Room room;
  noteUnknown(jsonOf("{\"size\": 1, \"spout\": 2, \"$schema\": \"s\", \"pos\": 3}"), known, room);
  EXPECT_TRUE(room.findings.empty());
  noteUnknown(jsonOf("{\"sise\": 1,\n\"pos\": 2, \"pos\": 3}"), known, room);
  ASSERT_EQ(room.findings.size(), 2u);
  EXPECT_NE(saidOf(room)[0].find("W 1:2 "), std::string::npos) << saidOf(room)[0];
  EXPECT_NE(saidOf(room)[0].find("'sise'"), std::string::npos) << saidOf(room)[0];
  EXPECT_EQ(saidOf(room)[1], "W 2:1 key 'pos' is given twice; the last counts");
}

TEST(SgctValues, FlagsArraysAndObjectsAreOfTheirKinds) {
  const JsonNode root = jsonOf("{\"on\": true, \"off\": false, \"list\": [], \"word\": \"x\"}");
  Room room;
  EXPECT_TRUE(flag(root, "on", room));
  EXPECT_FALSE(flag(root, "off", room));
  EXPECT_FALSE(flag(root, "none", room));
  EXPECT_NE(array(root, "list", room), nullptr);
  EXPECT_TRUE(isObject(root, "the room", room));
  EXPECT_EQ(saidOf(room), Said{});
  EXPECT_FALSE(flag(root, "list", room));
  EXPECT_EQ(array(root, "word", room), nullptr);
  EXPECT_FALSE(isObject(*root.member("word"), "the room", room));
  noteIgnored(root, "word", "it is a word", room);
  noteIgnored(root, "none", "it is not there", room);
  EXPECT_EQ(saidOf(room), (Said{"E 1:36 list is an array, expected true or false",
                                "E 1:48 word is the text 'x', expected an array",
                                "E 1:48 the room is the text 'x', expected an object",
                                "W 1:48 word cannot be taken over: it is a word"}));
}

}  // namespace
}  // namespace carom
