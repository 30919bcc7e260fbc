// The look at a TOML file before its parser: how deep values may be nested, how many there may be, and what
// stands in quotes and comments.
#include "app/toml/toml_scan.h"

#include <gtest/gtest.h>

#include <string>
#include <tuple>
#include <vector>

#include "app/repeated_text.h"

namespace carom {
namespace {

using test::repeated;

/// "LINE:COLUMN" of the fault; empty if there is none.
std::string placeOfFault(const std::string& text) {
  const auto fault = faultBeforeParsing(text);
  return fault ? std::to_string(fault->at.line) + ":" + std::to_string(fault->at.column) : "";
}

TEST(TomlScan, TakesTheDeepestAndRefusesOneDeeper) {
  for (const auto& [before, opening, column] :
       {std::tuple{"a = ", "[", 37}, {"a = ", "{", 37}, {"", "a.", 66}, {"b = 1\n", "'a'.", 132}}) {
    SCOPED_TRACE(opening);
    EXPECT_EQ(placeOfFault(before + repeated(opening, kDeepestToml)), "");
    const std::string line = std::string(before).ends_with('\n') ? "2:" : "1:";
    EXPECT_EQ(placeOfFault(before + repeated(opening, kDeepestToml + 1)), line + std::to_string(column));
  }
}

TEST(TomlScan, WhatIsClosedNestsNoMore) {
  EXPECT_EQ(placeOfFault("a = [" + repeated("[{}],", 1000) + "]\n"), "");
  EXPECT_EQ(placeOfFault(repeated("a.b = 1.5\n", 1000)), "");
  EXPECT_EQ(placeOfFault("]]]]" + repeated("[", kDeepestToml)), "") << "what was never opened closes nothing";
}

TEST(TomlScan, NothingInQuotesOrCommentsNests) {
  const std::string deep = repeated("[.", 2 * kDeepestToml);
  for (const std::string& text : std::vector<std::string>{
           "a = '" + deep + "'\n", "a = \"" + deep + "\\\"" + deep + "\"\n", "# " + deep + "\n",
           "a = '''\n" + deep + "'\n" + deep + "'''\n", "a = \"\"\"" + deep + "\n\"" + deep + "\"\"\"\n",
           "a = \"\"\"x\"\"\"\"\" # " + deep + "\n", "a = '\\' # " + deep + "\n"}) {
    EXPECT_EQ(placeOfFault(text), "") << text.substr(0, 12);
    EXPECT_NE(placeOfFault(text + deep), "") << "the quote of " << text.substr(0, 12) << " is over";
  }
}

TEST(TomlScan, RefusesLettersBeyondAsciiOutsideQuotes) {
  EXPECT_EQ(placeOfFault("a = 'é' # é\n\"é\" = \"\"\"é\"\"\"\n"), "");
  EXPECT_EQ(placeOfFault("\xEF\xBB\xBF"
                         "a = 1\n"),
            "")
      << "the mark of UTF-8 at the beginning";
  EXPECT_EQ(placeOfFault("a = 1\n\xC2\xA0"
                         "b = 2\n"),
            "2:1");
  EXPECT_EQ(placeOfFault("a = 'éé', é"), "1:11") << "columns count letters";
}

TEST(TomlScan, CountsValues) {
  const std::string most = "a = [" + std::string(kMostTomlValues - 2, ',');  // the sign and the bracket count
  EXPECT_EQ(placeOfFault(most), "");
  EXPECT_EQ(placeOfFault(most + ","), "1:" + std::to_string(most.size() + 1));
}

}  // namespace
}  // namespace carom
