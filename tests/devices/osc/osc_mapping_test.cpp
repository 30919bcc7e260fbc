// The meanings of the arguments of a pose in Open Sound Control.
#include "devices/osc/osc_mapping.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

namespace carom {
namespace {

TEST(OscValues, AreReadOrExplained) {
  EXPECT_EQ(readOscValues(" x  y z ").size(), 3u);
  for (const char* wrong : {"", "x y", "x y z z", "x y z qx qy qz", "x y z w", "x,y,z"}) {
    EXPECT_THROW(readOscValues(wrong), std::invalid_argument) << wrong;
  }
}

// Each argument has the meaning of its word, in order.
TEST(OscValues, StandInTheOrderOfTheirWords) {
  using V = OscValue;
  EXPECT_EQ(readOscValues("- qw qx qy qz  z y x"),
            (std::vector{V::ignored, V::qw, V::qx, V::qy, V::qz, V::z, V::y, V::x}));
  EXPECT_EQ(readOscValues("x - y - z"), (std::vector{V::x, V::ignored, V::y, V::ignored, V::z}));
}

}  // namespace
}  // namespace carom
