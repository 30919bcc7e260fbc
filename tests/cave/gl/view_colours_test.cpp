// Colours that mean something, for eyes that do not tell red from green.
#include "cave/gl/view_colours.h"

#include <gtest/gtest.h>

#include <vector>

#include "cave/red_green.h"

namespace carom {
namespace {

constexpr double kAtAGlance = 12.0;  // five times what can just be seen

void expectApart(const std::vector<glm::vec3>& codes) {
  for (std::size_t i = 0; i < codes.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_GT(test::leastDifference(linearOf(codes[i]), linearOf(codes[j])), kAtAGlance) << i << ", " << j;
}

TEST(ViewColours, ThoseThatMeanSomethingDifferForEyesWithoutRedOrGreenCones) {
  expectApart({kBoardNowColour, kMyNowColour});
  expectApart({kMotionColour, kContractedColour, kThrustColour, kLimitColour});
}

// The test itself: a red and a green that many cannot tell apart.
TEST(ViewColours, RedAndGreenOfOneBrightnessDoNot) {
  const glm::vec3 red(0.38F, 0.10F, 0.05F), green(0.10F, 0.22F, 0.05F);
  EXPECT_LT(test::leastDifference(red, green), kAtAGlance);
  EXPECT_GT(glm::distance(test::labOf(red), test::labOf(green)), 2.0 * kAtAGlance);
}

}  // namespace
}  // namespace carom
