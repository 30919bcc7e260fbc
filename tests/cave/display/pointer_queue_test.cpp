// Presses of any length, seen frame by frame: none is lost, and each is where it was.
#include "cave/display/pointer_queue.h"

#include <gtest/gtest.h>

#include <vector>

#include "engine/random_world.h"

namespace carom {
namespace {

using Button = PointerQueue::Button;

TEST(PointerQueue, APressThatIsOverBeforeTheFrameIsAPress) {
  PointerQueue pointer;
  pointer.move({10, 20});
  pointer.change(Button::left, true, {10, 20});
  pointer.change(Button::left, false, {10, 20});
  pointer.move({300, 400});
  pointer.beginFrame();
  EXPECT_TRUE(pointer.isDown(Button::left));
  EXPECT_EQ(pointer.at(), glm::dvec2(10, 20)) << "where it was pressed";
  pointer.beginFrame();
  EXPECT_FALSE(pointer.isDown(Button::left));
  EXPECT_EQ(pointer.at(), glm::dvec2(10, 20));
  pointer.beginFrame();
  EXPECT_EQ(pointer.at(), glm::dvec2(300, 400));
}

// A stroke within one slow frame: pressed, drawn back, let go.
TEST(PointerQueue, WhatIsDrawnIsSeenAtItsEndBeforeItIsLetGo) {
  PointerQueue pointer;
  pointer.change(Button::left, true, {10, 20});
  pointer.move({10, 50});
  pointer.move({10, 90});
  pointer.change(Button::left, false, {10, 90});
  pointer.beginFrame();
  EXPECT_TRUE(pointer.isDown(Button::left) && pointer.at() == glm::dvec2(10, 20));
  pointer.beginFrame();
  EXPECT_TRUE(pointer.isDown(Button::left) && pointer.at() == glm::dvec2(10, 90));
  pointer.beginFrame();
  EXPECT_FALSE(pointer.isDown(Button::left));
}

TEST(PointerQueue, EveryPressOfAnyRunIsSeenWhereItWas) {
  test::Random random(5);
  for (int run = 0; run < 200; ++run) {
    SCOPED_TRACE(run);
    PointerQueue pointer;
    std::vector<glm::dvec2> pressed, seen;
    bool down = false, wasDown = false;
    const auto frame = [&] {
      pointer.beginFrame();
      const bool is = pointer.isDown(Button::left);
      if (is && !wasDown) seen.push_back(pointer.at());
      wasDown = is;
    };
    for (int i = 0; i < 100; ++i) {
      const glm::dvec2 at(random.in(0, 100), random.in(0, 100));
      const double what = random.in(0, 1);
      if (what < 0.4) {
        pointer.move(at);
      } else if (what < 0.6) {
        down = !down;
        pointer.change(Button::left, down, at);
        if (down) pressed.push_back(at);
      } else {
        frame();
      }
    }
    for (int i = 0; i < 300; ++i) frame();
    EXPECT_EQ(seen, pressed);
  }
}

TEST(PointerQueue, WhatIsDiscardedLeavesTheButtonsAsTheyAre) {
  PointerQueue pointer;
  pointer.change(Button::left, true, {1, 2});
  pointer.change(Button::left, false, {1, 2});
  pointer.change(Button::right, true, {3, 4});
  pointer.discard();
  pointer.beginFrame();
  EXPECT_FALSE(pointer.isDown(Button::left));
  EXPECT_TRUE(pointer.isDown(Button::right));
  for (int i = 0; i < 1000; ++i) {
    pointer.change(Button::left, true, {});
    pointer.change(Button::left, false, {});
  }
  pointer.beginFrame();  // nobody had asked; it has not grown without end
  for (int i = 0; i < 70; ++i) pointer.beginFrame();
  EXPECT_FALSE(pointer.isDown(Button::left));
}

}  // namespace
}  // namespace carom
