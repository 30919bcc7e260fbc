// JSON as a tree: kinds and places of values, comments, and files that are refused.
#include "app/room_import/json_tree.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "app/import_faults.h"
#include "app/temporary_folder.h"

namespace carom {
namespace {

using test::placed;
using test::TemporaryFolder;
using Kind = JsonNode::Kind;

JsonNode read(const std::string& text) {
  const TemporaryFolder folder;
  return readJson(folder.file("a.json", text));
}

JsonNode readWithComments(const std::string& text) {
  const TemporaryFolder folder;
  return readJsonWithComments(folder.file("a.json", text));
}

/// "LINE:COLUMN MESSAGE" of the fault that `read` finds; empty if it finds none.
template <class Read>
std::string faultOf(const std::string& text, const Read& read) {
  try {
    read(text);
  } catch (const InputErrors& errors) {
    return placed({errors.line(), errors.column()}) + " " + errors.message();
  }
  return {};
}

TEST(JsonTree, EachValueHasItsKindAndPlace) {
  const JsonNode root =
      read("{ \"a\" : [1, -2.5,\n  true,null , \"x\\n\" ],\n\t\"b\":{\"a\": {}}, \"a\": 7 }");
  EXPECT_EQ(root.kind, Kind::object);
  ASSERT_EQ(root.children.size(), 3u);
  const JsonNode& array = root.children[0];
  EXPECT_EQ(array.key, "a");
  EXPECT_EQ(placed(array.keyAt), "1:3");
  EXPECT_EQ(placed(array.at), "1:9");
  const std::vector<std::pair<Kind, std::string>> elements{{Kind::whole, "1:10"},
                                                           {Kind::number, "1:13"},
                                                           {Kind::flag, "2:3"},
                                                           {Kind::null, "2:8"},
                                                           {Kind::text, "2:15"}};
  ASSERT_EQ(array.children.size(), elements.size());
  for (std::size_t i = 0; i < elements.size(); ++i) {
    EXPECT_EQ(array.children[i].kind, elements[i].first) << i;
    EXPECT_EQ(placed(array.children[i].at), elements[i].second) << i;
  }
  EXPECT_EQ(array.children[1].number, -2.5);
  EXPECT_TRUE(array.children[2].flag);
  EXPECT_EQ(array.children[4].text, "x\n");
  EXPECT_EQ(placed(root.children[1].at), "3:6");
  ASSERT_NE(root.member("b"), nullptr);
  EXPECT_EQ(root.member("b")->member("a")->kind, Kind::object);
  EXPECT_EQ(root.member("a")->number, 7.0) << "the last of a key given twice counts";
  EXPECT_EQ(root.member("c"), nullptr);
}

TEST(JsonTree, CommentsAreBlanksOutsideTexts) {
  const std::string text =
      "{ // a \"comment\"\n  /* of [two\n lines */ \"a\": \"// no /* comment\\\" */\", \"b\": 2 // end";
  const JsonNode root = readWithComments(text + "\n}");
  ASSERT_EQ(root.children.size(), 2u);
  EXPECT_EQ(root.children[0].text, "// no /* comment\" */");
  EXPECT_EQ(placed(root.children[0].keyAt), "3:11");
  EXPECT_EQ(root.children[1].number, 2.0);
  EXPECT_NE(faultOf(text + "\n}", read), "") << "JSON itself has no comments";
  EXPECT_NE(faultOf("/* {}", readWithComments), "") << "a comment without an end";
  EXPECT_NE(faultOf("{} /", readWithComments), "");
}

TEST(JsonTree, RefusesWhatItCannotHold) {
  const auto nested = [](std::size_t depth) { return std::string(depth, '[') + std::string(depth, ']'); };
  EXPECT_EQ(faultOf(nested(32), read), "");
  EXPECT_EQ(faultOf(nested(33), read), "1:33 values are nested too deep, expected at most 32");
  const auto many = [](std::size_t values) {
    std::string text = "[";
    for (std::size_t i = 0; i < values; ++i) text += i == 0 ? "1" : ",1";
    return text + "]";
  };
  EXPECT_EQ(faultOf(many(99'999), read), "") << "the array is a value, too";
  EXPECT_EQ(faultOf(many(100'000), read), "1:200000 too many values, expected at most 100000");
  EXPECT_EQ(faultOf("{\"a\":\n [1e400]}", read),
            "2:3 the number 1e400 is too large, expected one that can be counted with");
  EXPECT_EQ(faultOf("{\"a\":\n [1, 2", read),
            "2:7 the file ends within an array 'a' of line 2, expected ']'");
}

TEST(JsonTree, ValuesHaveWords) {
  const JsonNode root = read("[null, true, 3, 0.5, \"it\", [], {}]");
  const std::vector<std::string> words{"null", "true", "3", "0.5", "the text 'it'", "an array", "an object"};
  ASSERT_EQ(root.children.size(), words.size());
  for (std::size_t i = 0; i < words.size(); ++i) EXPECT_EQ(root.children[i].words(), words[i]);
}

}  // namespace
}  // namespace carom
