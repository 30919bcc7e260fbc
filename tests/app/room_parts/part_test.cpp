// Parts of room files: how they are looked up, which numbers they hold, and what is told of the others.
#include "app/room_parts/part.h"

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "app/temporary_folder.h"

namespace carom {
namespace {

Part xml(const std::string& text) { return partOf(parseXml("a.xml", text, Doctype::none).root); }

Part json(const std::string& text) {
  const test::TemporaryFolder folder;
  return partOf(readJson(folder.file("a.json", text)));
}

/// "LINE:COLUMN TEXT" of each finding.
std::vector<std::string> saidOf(const Room& room) {
  std::vector<std::string> said;
  for (const Finding& finding : room.findings)
    said.push_back(fmt::format("{}:{} {}", finding.at.line, finding.at.column, finding.text));
  return said;
}

using Said = std::vector<std::string>;

TEST(Part, TheLastOfANameCountsWhateverItsCapitals) {
  const Part part = xml("<a Size='1' b='2'>\n<size>3</size><c/></a>");
  ASSERT_NE(part.find("SIZE"), nullptr);
  EXPECT_EQ(part.textOf("sIze"), "3");
  EXPECT_EQ(part.placeOf("size").line, 2);
  EXPECT_EQ(part.placeOf("size").column, 7);
  EXPECT_EQ(part.placeOf("none").column, 1) << "its own place";
  EXPECT_EQ(part.all("size").size(), 2u);
  EXPECT_EQ(part.find("d"), nullptr);
  EXPECT_TRUE(partsOf(part.find("d")).empty());
  EXPECT_EQ(partsOf(&part).size(), 4u);
  EXPECT_FALSE(alike("size", "sizes"));
}

TEST(Part, JsonAndXmlAreAlike) {
  const Part part = json("{\"w\": {\"on\": true, \"n\": 2.5, \"p\": [1, 2, 3]}}");
  const Part* inner = part.find("w");
  ASSERT_NE(inner, nullptr);
  Room room;
  EXPECT_TRUE(flagOr(*inner, "on", false, room));
  EXPECT_EQ(numberOr(*inner, "n", 0.0, room), 2.5);
  EXPECT_EQ(arrayOf(*inner->find("p"), 3, room), (std::vector<double>{1, 2, 3}));
  const Part other = xml("<a on='Yes' n='2.5' p='1, 2;3'/>");
  EXPECT_TRUE(flagOr(other, "on", false, room));
  EXPECT_EQ(numberOr(other, "n", 0.0, room), 2.5);
  EXPECT_EQ(numbersIn(*other.find("p"), 3, room), (std::vector<double>{1, 2, 3}));
  EXPECT_EQ(saidOf(room), Said{});
}

TEST(Part, WrongValuesAreToldAndTheirSubstitutesTaken) {
  const Part part = xml("<a n='2x'\n m='2.5'\n on='maybe'\n p='1 2'\n q='1 y 3'/>");
  Room room;
  EXPECT_EQ(numberOr(part, "n", 7.0, room), 7.0);
  EXPECT_EQ(numberOr(part, "none", 7.0, room), 7.0);
  EXPECT_FALSE(number(part, "m", {.least = 0.0, .most = 9.0}, true, room));
  EXPECT_TRUE(flagOr(part, "on", true, room));
  EXPECT_FALSE(numbersIn(*part.find("p"), 3, room));
  EXPECT_FALSE(numbersIn(*part.find("q"), 3, room));
  EXPECT_EQ(saidOf(room),
            (Said{"1:7 n is '2x', expected a number from -1e+09 to 1e+09 and nothing else",
                  "2:5 m is '2.5', expected a whole number from 0 to 9 and nothing else",
                  "3:6 on is 'maybe', expected true or false", "4:5 p has 2 values, expected 3 numbers",
                  "5:5 'y' in q is no number that can be counted with, expected 3 numbers"}));
}

TEST(Part, AVectorHasThreeNumbers) {
  const Part part = xml("<a><v>1</v><v>2</v><v>-3</v><w>1</w></a>");
  Room room;
  EXPECT_EQ(vectorOf(part.all("v"), part.at, "v", room), glm::dvec3(1, 2, -3));
  EXPECT_FALSE(vectorOf(part.all("w"), part.at, "w", room));
  EXPECT_EQ(saidOf(room), Said{"1:1 w has 1 value, expected 3 numbers"});
}

TEST(Part, TwinsAreRefused) {
  const Part part = xml("<a>\n<w name='x'/><w name='y'/><w/>\n<w name='x'/><w/></a>");
  Room room;
  refuseTwins(part.all("w"), "name", room);
  EXPECT_EQ(saidOf(room), Said{"3:10 the name 'x' is taken in line 2, expected another"});
  Room members;
  refuseTwinMembers(json("{\"a\": {\"b\": 1,\n\"b\": 2},\n\"b\": [{\"c\": 1}, {\"c\": 2}]}"), members);
  EXPECT_EQ(saidOf(members), Said{"2:1 the name 'b' is taken in line 1, expected another"});
}

// A reader accounts for all that it has not looked up.
TEST(Part, WhatNoReaderLooksUpIsTold) {
  const Part part =
      xml("<a>\n<read><inner>5</inner></read>\n<twice/>\n<twice/>\n<Comment/>\n<whole><x/></whole></a>");
  part.find("read");
  part.find("twice");
  part.find("whole")->markRead();
  constexpr std::array<std::string_view, 1> kQuiet{"comment"};
  Room room;
  nameUnread(part, kQuiet, room);
  EXPECT_EQ(saidOf(room), (Said{"2:7 inner '5' is left out: nothing here does the like",
                                "3:1 twice is left out: the one of line 4 counts"}));
  for (const Finding& finding : room.findings) EXPECT_EQ(finding.kind, Finding::Kind::warning);
}

}  // namespace
}  // namespace carom
