// Escape and Q ask before they end a session.
#include "app/input/end_question.h"

#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

#include <chrono>
#include <vector>

#include "log_lines.h"

namespace carom {
namespace {

class EndQuestionTest : public testing::Test {
 protected:
  bool typed(std::vector<int> keys, std::chrono::seconds later = std::chrono::seconds(1)) {
    WindowInput input;
    for (const int key : keys) {
      input.keys.push_back({key, true});
      input.keys.push_back({key, false});
    }
    return question_.take(input, now_ += later);
  }

  const test::LogLines log_;
  EndQuestion question_;
  EndQuestion::Clock::time_point now_{};
};

TEST_F(EndQuestionTest, EscapeAsksAndEndsWhenPressedAgain) {
  for (const int key : {GLFW_KEY_ESCAPE, GLFW_KEY_Q}) {
    question_ = {};
    EXPECT_FALSE(typed({}));
    EXPECT_FALSE(typed({key}));
    EXPECT_TRUE(question_.isAsked());
    EXPECT_FALSE(typed({})) << "held or let go, it is one press";
    EXPECT_TRUE(typed({key}));
  }
  EXPECT_EQ(log_.said(), (std::vector<std::string>(2, "Press Escape again to end.")));
}

TEST_F(EndQuestionTest, TwoPressesWithinASlowFrameAreTwo) {
  EXPECT_TRUE(typed({GLFW_KEY_ESCAPE, GLFW_KEY_Q}));
}

TEST_F(EndQuestionTest, AnotherKeyOrTimeTakesTheQuestionBack) {
  typed({GLFW_KEY_ESCAPE});
  EXPECT_FALSE(typed({GLFW_KEY_P}));
  EXPECT_FALSE(question_.isAsked());
  EXPECT_FALSE(typed({GLFW_KEY_ESCAPE}));
  EXPECT_FALSE(typed({}, EndQuestion::kStands));
  EXPECT_FALSE(question_.isAsked());
  EXPECT_FALSE(typed({GLFW_KEY_ESCAPE}));
  EXPECT_TRUE(typed({GLFW_KEY_ESCAPE}, 2 * EndQuestion::kStands)) << "the very next frame, which took long";
}

TEST_F(EndQuestionTest, AWindowsCloseButtonIsNotAsked) {
  WindowInput input;
  input.closeRequested = true;
  EXPECT_TRUE(question_.take(input));
}

}  // namespace
}  // namespace carom
