// What keys, mouse and a gamepad at the desk come to.
#include "app/input/desk_controls.h"

#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

#include <vector>

namespace carom {
namespace {

WindowInput keys(std::vector<KeyInput> pressed) {
  WindowInput input;
  input.keys = std::move(pressed);
  return input;
}

/// A gamepad that nobody touches.
GLFWgamepadstate padAtRest() {
  GLFWgamepadstate pad{};
  pad.axes[GLFW_GAMEPAD_AXIS_LEFT_TRIGGER] = pad.axes[GLFW_GAMEPAD_AXIS_RIGHT_TRIGGER] = -1.0F;
  return pad;
}

class DeskTest : public testing::Test {
 protected:
  const DeskInput& type(std::vector<KeyInput> pressed) {
    return desk_.gather({}, false, keys(std::move(pressed)), nullptr, false);
  }
  const DeskInput& play(bool asks = false) { return desk_.gather({}, false, {}, &pad_, asks); }
  void press(int button) { pad_.buttons[button] = GLFW_PRESS; }
  void letGo() { pad_ = padAtRest(); }

  DeskControls desk_{KeysOf::session};
  GLFWgamepadstate pad_ = padAtRest();
};

TEST_F(DeskTest, HeldKeysSteerUntilTheyAreLetGo) {
  EXPECT_EQ(type({{GLFW_KEY_W, true}}).steer, Vec3(0, 1, 0));
  EXPECT_EQ(type({}).steer, Vec3(0, 1, 0));
  EXPECT_EQ(type({{GLFW_KEY_D, true}}).steer, Vec3(1, 1, 0));
  EXPECT_EQ(type({{GLFW_KEY_S, true}}).steer, Vec3(1, 0, 0)) << "W and S";
  EXPECT_EQ(type({{GLFW_KEY_W, false}, {GLFW_KEY_D, false}, {GLFW_KEY_A, true}}).steer, Vec3(-1, -1, 0));
  EXPECT_FALSE(type({}).brake);
  EXPECT_TRUE(type({{GLFW_KEY_SPACE, true}}).brake);
  EXPECT_TRUE(type({}).brake);
  EXPECT_FALSE(type({{GLFW_KEY_SPACE, false}}).brake);
}

TEST_F(DeskTest, ArrowsAndPagesMoveAHeadAndDeleteAndEndTurnIt) {
  EXPECT_EQ(type({{GLFW_KEY_UP, true}, {GLFW_KEY_LEFT, true}}).walk, Vec3(-1, 1, 0));
  EXPECT_EQ(type({{GLFW_KEY_UP, false}, {GLFW_KEY_RIGHT, true}, {GLFW_KEY_PAGE_UP, true}}).walk,
            Vec3(0, 0, 1));
  EXPECT_EQ(type({{GLFW_KEY_LEFT, false}, {GLFW_KEY_DOWN, true}, {GLFW_KEY_PAGE_UP, false}}).walk,
            Vec3(1, -1, 0));
  EXPECT_EQ(type({{GLFW_KEY_PAGE_DOWN, true}}).walk, Vec3(1, -1, -1));
  EXPECT_EQ(type({}).steer, Vec3(0.0)) << "they drive nothing";
  EXPECT_EQ(type({{GLFW_KEY_END, true}}).look, 1.0);
  EXPECT_EQ(type({{GLFW_KEY_DELETE, true}}).look, 0.0);
  EXPECT_EQ(type({{GLFW_KEY_END, false}}).look, -1.0);
}

TEST_F(DeskTest, HomeIsAskedForOnce) {
  EXPECT_TRUE(type({{GLFW_KEY_HOME, true}}).home);
  EXPECT_FALSE(type({}).home);
  EXPECT_FALSE(type({{GLFW_KEY_HOME, false}}).home);
}

TEST_F(DeskTest, InAReplaySpaceAndHomeMeanSomethingElse) {
  desk_ = DeskControls(KeysOf::replay);
  const DeskInput input = type({{GLFW_KEY_SPACE, true}, {GLFW_KEY_HOME, true}, {GLFW_KEY_W, true}});
  EXPECT_FALSE(input.brake || input.home);
  EXPECT_EQ(input.steer, Vec3(0, 1, 0));
}

TEST_F(DeskTest, AKeyThatWasTappedBetweenFramesCountsForOneAndIsNotStuck) {
  EXPECT_EQ(type({{GLFW_KEY_W, true}, {GLFW_KEY_W, false}}).steer, Vec3(0, 1, 0));
  EXPECT_EQ(type({}).steer, Vec3(0.0));
  EXPECT_TRUE(type({{GLFW_KEY_SPACE, true}, {GLFW_KEY_SPACE, false}}).brake);
  EXPECT_FALSE(type({}).brake);
}

// The cross goes through the buttons on the wall. Then A presses the one it has come to, and is no answer.
TEST_F(DeskTest, ThePadsCrossStepsAndAThenPressesAndDoesNotAnswer) {
  for (const auto& [button, step] : {std::pair{GLFW_GAMEPAD_BUTTON_DPAD_RIGHT, 1},
                                     {GLFW_GAMEPAD_BUTTON_DPAD_LEFT, -1},
                                     {GLFW_GAMEPAD_BUTTON_DPAD_DOWN, 1},
                                     {GLFW_GAMEPAD_BUTTON_DPAD_UP, -1}}) {
    press(button);
    EXPECT_EQ(play(true).padStep, step);
    EXPECT_EQ(play(true).padStep, 0) << "once";
    letGo();
    play(true);
  }
  press(GLFW_GAMEPAD_BUTTON_A);
  DeskInput input = play(true);
  EXPECT_EQ(input.answer, 0);
  EXPECT_TRUE(input.padHeld) << "a press on the wall";
  letGo();
  play(true);
  press(GLFW_GAMEPAD_BUTTON_A);
  EXPECT_EQ(play(true).answer, 1) << "without the cross it answers again";
  letGo();
  play(true);
  press(GLFW_GAMEPAD_BUTTON_DPAD_DOWN);
  play(true);
  letGo();
  play(true);
  press(GLFW_GAMEPAD_BUTTON_B);
  EXPECT_EQ(play(true).answer, 0);
  letGo();
  play(true);
  press(GLFW_GAMEPAD_BUTTON_B);
  EXPECT_EQ(play(true).answer, 2) << "another button ends the way through the wall's";
}

TEST_F(DeskTest, ThePadsSticksHaveADeadMiddleAndReachTheirEnds) {
  EXPECT_TRUE(play().hasPad);
  pad_.axes[GLFW_GAMEPAD_AXIS_LEFT_X] = 0.1F;
  pad_.axes[GLFW_GAMEPAD_AXIS_RIGHT_Y] = -0.1F;
  EXPECT_EQ(play().steer, Vec3(0.0));
  EXPECT_EQ(play().padPull, Vec3(0.0));
  pad_.axes[GLFW_GAMEPAD_AXIS_LEFT_X] = 0.0F;
  pad_.axes[GLFW_GAMEPAD_AXIS_LEFT_Y] = -1.0F;  // away from the person
  pad_.axes[GLFW_GAMEPAD_AXIS_RIGHT_Y] = 1.0F;  // towards them
  EXPECT_NEAR(play().steer.y, 1.0, 1e-12);
  EXPECT_NEAR(play().padPull.y, 1.0, 1e-12);
  pad_.axes[GLFW_GAMEPAD_AXIS_RIGHT_Y] = static_cast<float>(0.5 * (1.0 + kDeadZone));
  EXPECT_NEAR(play().padPull.y, 0.5, 1e-6) << "halfway from the dead middle's edge";
  const DeskInput none = type({});
  EXPECT_FALSE(none.hasPad);
  EXPECT_EQ(none.steer, Vec3(0.0));
}

TEST_F(DeskTest, ThePadsButtonsHoldBrakeAndGoHome) {
  press(GLFW_GAMEPAD_BUTTON_A);
  EXPECT_TRUE(play().padHeld);
  EXPECT_TRUE(play().padHeld);
  letGo();
  EXPECT_FALSE(play().padHeld);
  pad_.axes[GLFW_GAMEPAD_AXIS_RIGHT_TRIGGER] = 0.6F;
  EXPECT_TRUE(play().padHeld);
  letGo();
  press(GLFW_GAMEPAD_BUTTON_B);
  EXPECT_TRUE(play().brake);
  EXPECT_TRUE(play().brake);
  letGo();
  press(GLFW_GAMEPAD_BUTTON_Y);
  EXPECT_TRUE(play().home);
  EXPECT_FALSE(play().home) << "once";
  press(GLFW_GAMEPAD_BUTTON_START);
  EXPECT_TRUE(play().onwards);
  EXPECT_FALSE(play().onwards);
}

TEST_F(DeskTest, WhileALessonAsksThePadsButtonsAnswerAndDoNothingElse) {
  const std::vector<int> buttons{GLFW_GAMEPAD_BUTTON_A, GLFW_GAMEPAD_BUTTON_B, GLFW_GAMEPAD_BUTTON_X,
                                 GLFW_GAMEPAD_BUTTON_Y};
  for (std::size_t i = 0; i < buttons.size(); ++i) {
    press(buttons[i]);
    const DeskInput answered = play(true);
    EXPECT_EQ(answered.answer, static_cast<int>(i) + 1);
    EXPECT_FALSE(answered.padHeld || answered.brake || answered.home);
    EXPECT_EQ(play(true).answer, 0) << "once";
    const DeskInput after = play(false);  // still down when the question is over
    EXPECT_FALSE(after.padHeld || after.brake || after.home || after.answer);
    letGo();
    EXPECT_EQ(play().answer, 0);
  }
  press(GLFW_GAMEPAD_BUTTON_START);
  EXPECT_TRUE(play(true).onwards) << "a question may be passed over";
}

TEST_F(DeskTest, TheMouseIsHandedOn) {
  const DeskInput input = desk_.gather(PointedWall{{1, 2, 3}, Eye::right}, true, {}, nullptr, false);
  ASSERT_TRUE(input.mouse);
  EXPECT_EQ(input.mouse->onWall_m, Vec3(1, 2, 3));
  EXPECT_EQ(input.mouse->eye, Eye::right);
  EXPECT_TRUE(input.mouseHeld);
}

}  // namespace
}  // namespace carom
