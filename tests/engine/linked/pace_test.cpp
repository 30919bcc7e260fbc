#include "engine/linked/pace.h"

#include <gtest/gtest.h>

#include <vector>

namespace carom {
namespace {

TEST(Pace, HurriesSoftlyAndNeverSlows) {
  EXPECT_EQ(hurry(-1.0), 1.0);
  EXPECT_EQ(hurry(0.0), 1.0);
  EXPECT_DOUBLE_EQ(hurry(0.125), 1.5);
  EXPECT_EQ(hurry(10.0), 2.0);
}

TEST(Pace, AQuarterOfTheSlackIsFree) {
  EXPECT_DOUBLE_EQ(slack_s(3.64, 0.8, 1.42), 2.0);
  EXPECT_EQ(slack_s(0.5, 0.8, 1.42), 0.0);
  EXPECT_DOUBLE_EQ(behind_s(10.0, 10.4, 0.1, 2.0), 0.0);
  EXPECT_DOUBLE_EQ(behind_s(10.0, 11.4, 0.1, 2.0), 1.0);
}

TEST(Pace, TriesOneWhereHurryIsTooMuch) {
  std::vector<double> tried;
  const auto upTo = [&](double most) {
    return [&tried, most](double pace) {
      tried.push_back(pace);
      return pace <= most;
    };
  };
  EXPECT_EQ(livablePace(1.5, upTo(2.0)), 1.5);
  EXPECT_EQ(livablePace(1.5, upTo(1.2)), 1.0);
  EXPECT_EQ(livablePace(1.5, upTo(0.5)), std::nullopt);
  EXPECT_EQ(livablePace(1.0, upTo(0.5)), std::nullopt);
  EXPECT_EQ(tried, (std::vector{1.5, 1.5, 1.0, 1.5, 1.0, 1.0}));
}

}  // namespace
}  // namespace carom
