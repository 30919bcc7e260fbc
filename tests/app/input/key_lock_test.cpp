// Locked keys: what ends or spoils a demonstration does nothing, until the PIN is typed.
#include "app/input/key_lock.h"

#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

#include <initializer_list>
#include <vector>

#include "app/input/end_question.h"

namespace carom {
namespace {

WindowInput typed(std::initializer_list<int> keys) {
  WindowInput input;
  for (const int key : keys) {
    input.keys.push_back({key, true});
    input.keys.push_back({key, false});
  }
  return input;
}

std::vector<int> pressedOf(const WindowInput& input) {
  std::vector<int> keys;
  for (const KeyInput& key : input.keys) {
    if (key.pressed) keys.push_back(key.key);
  }
  return keys;
}

class KeyLockTest : public testing::Test {
 protected:
  void SetUp() override { testing::internal::CaptureStderr(); }
  void TearDown() override { testing::internal::GetCapturedStderr(); }
  std::vector<int> passed(std::initializer_list<int> keys) { return pressedOf(lock_.pass(typed(keys))); }
  bool ends(std::initializer_list<int> keys, bool close = false) {
    WindowInput input = typed(keys);
    input.closeRequested = close;
    return wantsToEnd(lock_.pass(input));
  }
  /// Whether the question is answered by this input, after a first press.
  static bool wantsToEnd(const WindowInput& input) {
    EndQuestion question;
    return question.take(input) || question.take(input);
  }

  using Keys = std::vector<int>;
  KeyLock lock_{"2718"};
};

TEST_F(KeyLockTest, LetsPlayAndKeepsFromEnding) {
  EXPECT_EQ(passed({GLFW_KEY_W, GLFW_KEY_T, GLFW_KEY_F5, GLFW_KEY_X, GLFW_KEY_2, GLFW_KEY_ENTER}),
            (Keys{GLFW_KEY_W, GLFW_KEY_F5, GLFW_KEY_2, GLFW_KEY_ENTER}));
  EXPECT_FALSE(ends({GLFW_KEY_ESCAPE}));
  EXPECT_FALSE(ends({GLFW_KEY_Q}));
  EXPECT_FALSE(ends({}, true)) << "the window's close button";
}

TEST_F(KeyLockTest, ThePinOpensItAndF12ClosesIt) {
  EXPECT_EQ(passed({GLFW_KEY_F12, GLFW_KEY_2, GLFW_KEY_7, GLFW_KEY_KP_1, GLFW_KEY_8, GLFW_KEY_ENTER}), Keys{})
      << "what is typed for the lock is not the game's";
  EXPECT_EQ(passed({GLFW_KEY_T}), Keys{GLFW_KEY_T});
  EXPECT_TRUE(ends({GLFW_KEY_ESCAPE}));
  EXPECT_TRUE(ends({}, true));
  passed({GLFW_KEY_F12});
  EXPECT_FALSE(ends({GLFW_KEY_ESCAPE}));
}

TEST_F(KeyLockTest, AnotherNumberDoesNotAndAnotherKeyGivesUp) {
  passed({GLFW_KEY_F12, GLFW_KEY_2, GLFW_KEY_7, GLFW_KEY_ENTER});
  EXPECT_FALSE(ends({GLFW_KEY_ESCAPE}));
  EXPECT_EQ(passed({GLFW_KEY_F12, GLFW_KEY_2, GLFW_KEY_W, GLFW_KEY_1}), (Keys{GLFW_KEY_W, GLFW_KEY_1}));
  passed({GLFW_KEY_7, GLFW_KEY_1, GLFW_KEY_8, GLFW_KEY_ENTER});
  EXPECT_FALSE(ends({GLFW_KEY_ESCAPE})) << "without F12 digits are answers";
  for (int i = 0; i < 1000; ++i) passed({GLFW_KEY_F12, GLFW_KEY_9});
  EXPECT_FALSE(ends({GLFW_KEY_ESCAPE}));
}

TEST_F(KeyLockTest, WithoutAPinNothingIsLocked) {
  KeyLock open;
  EXPECT_EQ(pressedOf(open.pass(typed({GLFW_KEY_F12, GLFW_KEY_ESCAPE}))),
            (Keys{GLFW_KEY_F12, GLFW_KEY_ESCAPE}));
}

TEST_F(KeyLockTest, WhatRunsUnattendedIsNotEndedByAVisitor) {
  lock_ = KeyLock({}, true);
  EXPECT_EQ(passed({GLFW_KEY_ESCAPE, GLFW_KEY_T, GLFW_KEY_Q, GLFW_KEY_F12, GLFW_KEY_2}),
            (Keys{GLFW_KEY_T, GLFW_KEY_F12, GLFW_KEY_2}));
  EXPECT_FALSE(ends({GLFW_KEY_ESCAPE}));
  EXPECT_FALSE(ends({}, true)) << "the window's close button";
  lock_ = KeyLock("2718", true);
  passed({GLFW_KEY_F12, GLFW_KEY_2, GLFW_KEY_7, GLFW_KEY_1, GLFW_KEY_8, GLFW_KEY_ENTER});
  EXPECT_TRUE(ends({GLFW_KEY_ESCAPE})) << "the PIN opens it";
}

}  // namespace
}  // namespace carom
