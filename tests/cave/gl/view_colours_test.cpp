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

TEST(ViewColours, LightFromABodyOfAnyColourStandsOutFromTheCloth) {
  const glm::vec3 cloth(0.05F, 0.25F, 0.12F);  // linear, as lit
  const glm::vec3 red(0.62F, 0.04F, 0.03F);
  for (const glm::vec3& body : {red, glm::vec3(0.03F, 0.08F, 0.6F), glm::vec3(0.02F, 0.3F, 0.06F),
                                glm::vec3(0.9F, 0.6F, 0.05F), glm::vec3(0.75F), glm::vec3(0.0F)})
    EXPECT_GT(test::leastDifference(linearOf(lightOf(body)), cloth), kAtAGlance)
        << body.r << ", " << body.g << ", " << body.b;
  EXPECT_GT(linearOf(lightOf(red)).r, 1.3F * linearOf(lightOf(red)).g) << "it keeps its hue";
  EXPECT_LT(glm::distance(linearOf(lightOf(glm::vec3(0.75F))), glm::vec3(0.75F)), 1e-3F) << "bright as it is";
}

// The test itself: a red and a green that many cannot tell apart.
TEST(ViewColours, RedAndGreenOfOneBrightnessDoNot) {
  const glm::vec3 red(0.38F, 0.10F, 0.05F), green(0.10F, 0.22F, 0.05F);
  EXPECT_LT(test::leastDifference(red, green), kAtAGlance);
  EXPECT_GT(glm::distance(test::labOf(red), test::labOf(green)), 2.0 * kAtAGlance);
}

}  // namespace
}  // namespace carom
