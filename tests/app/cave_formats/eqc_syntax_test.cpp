// The syntax of Equalizer's files: sections, lists, comments, and where files are no such text.
#include "app/cave_formats/eqc_syntax.h"

#include <gtest/gtest.h>

#include <string>

#include "app/temporary_folder.h"

namespace carom {
namespace {

Part read(const std::string& text) {
  const test::TemporaryFolder folder;
  return readEqcParts(folder.file("a.eqc", text));
}

/// "LINE:COLUMN MESSAGE" of the fault of a text; empty if it has none.
std::string faultOf(const std::string& text) {
  try {
    read(text);
  } catch (const InputErrors& errors) {
    return std::to_string(errors.line()) + ":" + std::to_string(errors.column()) + " " + errors.message();
  }
  return {};
}

TEST(EqcSyntax, SectionsListsAndCommentsHaveTheirPlaces) {
  const Part root = read(
      "#Equalizer 1.2 ascii\nserver\n{ # a { comment\n  name \"a \"\n"
      "  pipe { viewport [ 0 .5 1 ] device 1 }\n  pipe { }\n}\n");
  const Part* server = root.find("server");
  ASSERT_NE(server, nullptr);
  EXPECT_EQ(server->at.line, 2);
  EXPECT_EQ(server->textOf("name"), "a ");
  const auto pipes = server->all("pipe");
  ASSERT_EQ(pipes.size(), 2u);
  EXPECT_EQ(pipes[1]->at.line, 6);
  EXPECT_EQ(pipes[1]->at.column, 3);
  EXPECT_EQ(pipes[0]->textOf("device"), "1");
  const Part* viewport = pipes[0]->find("viewport");
  ASSERT_NE(viewport, nullptr);
  ASSERT_EQ(viewport->parts.size(), 3u);
  EXPECT_EQ(viewport->parts[1].text, ".5");
  EXPECT_EQ(viewport->parts[1].textAt.line, 5);
  EXPECT_EQ(viewport->parts[1].textAt.column, 23);
}

TEST(EqcSyntax, BracketsHaveTheirPartners) {
  const auto nested = [](std::size_t depth) {
    std::string text;
    for (std::size_t i = 0; i < depth; ++i) text += "a {\n";
    for (std::size_t i = 0; i < depth; ++i) text += "}\n";
    return text;
  };
  EXPECT_EQ(faultOf(nested(32)), "");
  EXPECT_NE(faultOf(nested(33)).find("nested too deep"), std::string::npos) << faultOf(nested(33));
  EXPECT_NE(faultOf("a {\n b { }\n"), "");
  EXPECT_NE(faultOf("a { }\n}\n"), "");
  EXPECT_NE(faultOf("a { v [ 1 2 }\n"), "");
}

}  // namespace
}  // namespace carom
