// The corners of a rig by their names.
#include "app/calibration/corner_names.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "app/calibration/touched_corners.h"

namespace carom {
namespace {

using test::theRig;

TEST(Calibration, NamesEachCornerOnceInTheOrderOfTheRig) {
  const auto corners = cornersOf(theRig());
  ASSERT_EQ(corners.size(), 8u);
  EXPECT_EQ(corners[1].name, "front.lower_right");
  EXPECT_EQ(corners[1].aliases, std::vector<std::string>{"right.lower_left"});
  EXPECT_EQ(wordsFor(corners[1]), "the lower right corner of wall 'front'");
  const auto chosen = chosenCorners(corners, "right.lower_left,left.upper_left");
  ASSERT_EQ(chosen.size(), 2u);
  EXPECT_EQ(chosen[0].at_m, corners[1].at_m);
  for (const char* wrong : {"", "front", "front.lower_left,", "front.middle", ","}) {
    EXPECT_THROW(chosenCorners(corners, wrong), std::invalid_argument) << wrong;
  }
}

}  // namespace
}  // namespace carom
