#include "devices/wire/shown_name.h"

#include <gtest/gtest.h>

namespace carom {
namespace {

TEST(ShownName, IsPrintableAndShort) {
  EXPECT_EQ(shownName("wand 1"), "wand 1");
  EXPECT_EQ(shownName("a\x1b[2Jb\n\x7f\xc3\xa4"), "a?[2Jb????");
  EXPECT_EQ(shownName(std::string(100, 'x')), std::string(40, 'x'));
  EXPECT_EQ(shownName(""), "");
}

}  // namespace
}  // namespace carom
