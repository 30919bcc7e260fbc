// Texts of words and numbers, as messages have them.
#include "engine/text/joined_text.h"

#include <gtest/gtest.h>

#include <string>

namespace carom {
namespace {

TEST(JoinedText, NumbersHaveAsManyDigitsAsAsked) {
  EXPECT_EQ(joinedText(3, "at ", 0.123456, ", of ", 7, std::string(" pucks")), "at 0.123, of 7 pucks");
  EXPECT_EQ(joinedText(6, 1234567.0), "1.23457e+06");
  EXPECT_EQ(joinedText(2, 123456789, ", ", -2L), "123456789, -2") << "whole numbers are whole";
  EXPECT_EQ(digitsOf(0.1 + 0.2, 15), "0.3");
  EXPECT_EQ(digitsOf(0.1 + 0.2, 17), "0.30000000000000004");
}

}  // namespace
}  // namespace carom
