#include "app/toml/input_file.h"

#include <gtest/gtest.h>

namespace carom {
namespace {

TEST(InputFile, NumbersAreReadWholeOrNotAtAll) {
  const std::vector<std::pair<const char*, double>> numbers{
      {"0.05", 0.05}, {"-1.13", -1.13}, {"+2", 2.0}, {"1e-3", 1e-3}, {".5", 0.5}, {"5.", 5.0}, {"-0", 0.0}};
  for (const auto& [text, value] : numbers) EXPECT_EQ(wholeNumber(text), value) << text;
  for (const char* text :
       {"0/05", "", " 1", "1 ", "1,5", "1m", "0x10", "+-1", "++1", "1e", "1e999", "--1", "one"}) {
    EXPECT_FALSE(wholeNumber(text)) << text;
  }
}

TEST(InputFile, PlacesCountFromOneInBytes) {
  const std::string text = "ab\n\nc\r\nd";
  const LineIndex lines(text);
  int line = 1, column = 1;
  for (std::size_t i = 0; i <= text.size(); ++i) {
    EXPECT_EQ(lines.at(i).line, line) << i;
    EXPECT_EQ(lines.at(i).column, column) << i;
    ++column;
    if (i < text.size() && text[i] == '\n') {
      ++line;
      column = 1;
    }
  }
}

}  // namespace
}  // namespace carom
