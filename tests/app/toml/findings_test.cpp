#include "app/toml/findings.h"

#include <gtest/gtest.h>

#include <fmt/format.h>

namespace carom {
namespace {

Finding at(int line, std::string text, Finding::Kind kind = Finding::Kind::warning) {
  return {kind, {line, 3}, std::move(text)};
}

TEST(Findings, AFewAreToldOneByOneInTheOrderOfTheirLines) {
  FindingList list;
  for (int line = 7; line > 0; --line)
    list.add(at(line, fmt::format("wall 'w{}' is {} mm away", line, line)));
  const auto told = toldOf(list.all());
  ASSERT_EQ(told.size(), 7u);
  EXPECT_EQ(told[0].text, "wall 'w1' is 1 mm away");
  EXPECT_EQ(told[6].at.line, 7);
}

TEST(Findings, EightThatDifferInNamesAndNumbersAloneAreToldAsOne) {
  FindingList list;
  for (int line = 1; line <= 8; ++line)
    list.add(at(line, fmt::format("wall 'w{}' is {} mm away", line, line)));
  list.add(at(5, "wall 'w5' is black"));
  const auto told = toldOf(list.all());
  ASSERT_EQ(told.size(), 2u);
  EXPECT_EQ(told[0].text, "8 walls: wall 'w1' is 1 mm away (also in lines 2, 3, 4, …)");
  EXPECT_EQ(told[1].text, "wall 'w5' is black");
}

TEST(Findings, ErrorsAndWarningsAreNotAlike) {
  FindingList list;
  for (int line = 1; line <= 5; ++line) list.add(at(line, "it is odd"));
  for (int line = 1; line <= 5; ++line) list.add(at(line, "it is odd.", Finding::Kind::error));
  EXPECT_EQ(toldOf(list.all()).size(), 10u);
}

TEST(Findings, AMillionAlikeAreCountedAndNotKept) {
  FindingList list;
  constexpr int kMany = 1'000'000;
  for (int i = 0; i < kMany; ++i)
    list.add(at(i + 1, fmt::format("walls 'a{}' and 'b' cut through each other", i)));
  EXPECT_LE(list.size(), kMostFindings);
  EXPECT_TRUE(list.isLong());
  const auto told = toldOf(list.all());
  ASSERT_EQ(told.size(), 1u);
  EXPECT_EQ(told[0].text.find("1000000 pairs of walls: walls 'a0' and 'b' cut"), 0u) << told[0].text;
}

TEST(Findings, AtMostAHundredLinesAndOneThatCountsTheOthers) {
  FindingList list;
  constexpr int kMany = 1334;
  for (int i = 0; i < kMany; ++i) {
    std::string word;  // no two are alike
    for (int rest = i + 1; rest > 0; rest /= 26) word += static_cast<char>('a' + rest % 26);
    list.add(at(i + 1, word));
  }
  const auto told = toldOf(list.all());
  ASSERT_EQ(told.size(), kMostFindings + 1);
  std::size_t counted = 0;
  for (std::size_t i = 0; i < kMostFindings; ++i) counted += told[i].count;
  EXPECT_EQ(counted, kMostFindings);
  EXPECT_EQ(told.back().text, "and 1234 more");
}

TEST(Findings, TheSameIsToldOnceAndNothingAtLength) {
  FindingList list;
  list.add(at(1, "it is odd"));
  list.add(at(1, "it is odd"));
  list.add(at(2, std::string(100'000, 'x')));
  const auto told = toldOf(list.all());
  ASSERT_EQ(told.size(), 2u);
  EXPECT_LT(told[1].text.size(), 1100u);
}

}  // namespace
}  // namespace carom
