#include "app/input/desk_controls.h"

#include <GLFW/glfw3.h>

#include <algorithm>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "cave/display/display_walls.h"
#include "cave/record/lesson_words.h"

namespace carom {
namespace {

/// Keys in the order of DeskControls::held_.
constexpr std::array kHeldKeys{GLFW_KEY_W,     GLFW_KEY_A,       GLFW_KEY_S,         GLFW_KEY_D,
                               GLFW_KEY_SPACE, GLFW_KEY_UP,      GLFW_KEY_LEFT,      GLFW_KEY_DOWN,
                               GLFW_KEY_RIGHT, GLFW_KEY_PAGE_UP, GLFW_KEY_PAGE_DOWN, GLFW_KEY_DELETE,
                               GLFW_KEY_END};

/// Gamepad buttons in the order of the answers.
constexpr std::array kPadButtons{GLFW_GAMEPAD_BUTTON_A, GLFW_GAMEPAD_BUTTON_B, GLFW_GAMEPAD_BUTTON_X,
                                 GLFW_GAMEPAD_BUTTON_Y, GLFW_GAMEPAD_BUTTON_START};
enum PadButton { kPadA, kPadB, kPadX, kPadY, kPadStart, kPadTrigger };

/// Reads the first gamepad connected. Returns false if there is none.
bool readPad(GLFWgamepadstate& pad) {
  for (int id = GLFW_JOYSTICK_1; id <= GLFW_JOYSTICK_LAST; ++id) {
    if (glfwJoystickIsGamepad(id) && glfwGetGamepadState(id, &pad)) return true;
  }
  return false;
}

/// Returns a stick's deflection to the right and down, as in GLFW.
Vec3 stickOf(const GLFWgamepadstate& pad, int rightAxis, int downAxis) {
  return withoutDeadZone({pad.axes[rightAxis], pad.axes[downAxis], 0.0});
}

}  // namespace

Vec3 withoutDeadZone(const Vec3& stick) {
  const double length = glm::length(stick);
  if (!(length > kDeadZone)) return Vec3(0.0);
  return stick / length * std::min((length - kDeadZone) / (1.0 - kDeadZone), 1.0);
}

void Buttons::set(std::uint32_t down, bool asks) {
  const std::uint32_t pressed = down & ~down_;
  down_ = down;
  answered_ = -1;
  for (int button = static_cast<int>(kMostAnswers) - 1; asks && button >= 0; --button) {
    if (pressed >> button & 1U) answered_ = button;
  }
  constexpr std::uint32_t kAnswers = (1U << kMostAnswers) - 1U;
  fresh_ = asks ? pressed & ~kAnswers : pressed;
  meant_ = (meant_ & down) | fresh_;
  if (asks) meant_ &= ~kAnswers;
}

void DeskControls::takeKeys(const WindowInput& input) {
  std::array<bool, kHeldKeys.size()> isDown{};  // now, or for a part of this frame
  for (const KeyInput& key : input.keys) {
    for (std::size_t i = 0; i < kHeldKeys.size(); ++i) {
      if (key.key != kHeldKeys[i]) continue;
      held_[i] = key.pressed;
      isDown[i] = isDown[i] || key.pressed;
    }
    if (key.key == GLFW_KEY_HOME && key.pressed) input_.home = isLive(place_);
  }
  for (std::size_t i = 0; i < isDown.size(); ++i) isDown[i] = isDown[i] || held_[i];
  const auto [w, a, s, d, space, up, left, down, right, higher, lower, lookLeft, lookRight] = isDown;
  input_.steer = {double(d) - double(a), double(w) - double(s), 0.0};
  input_.brake = space && isLive(place_);
  input_.walk = {double(right) - double(left), double(up) - double(down), double(higher) - double(lower)};
  input_.look = double(lookRight) - double(lookLeft);
}

/// Goes through the buttons of the front wall with the cross; any other use of the pad ends that.
void DeskControls::takeCross(const GLFWgamepadstate& pad) {
  constexpr std::array kCross{GLFW_GAMEPAD_BUTTON_DPAD_LEFT, GLFW_GAMEPAD_BUTTON_DPAD_UP,
                              GLFW_GAMEPAD_BUTTON_DPAD_RIGHT, GLFW_GAMEPAD_BUTTON_DPAD_DOWN};
  unsigned down = 0;
  for (std::size_t i = 0; i < kCross.size(); ++i) {
    if (pad.buttons[kCross[i]] == GLFW_PRESS) down |= 1U << i;
  }
  const unsigned pressed = down & ~std::exchange(cross_, down);
  if ((pressed & 0b0011U) != 0) input_.padStep = -1;
  if ((pressed & 0b1100U) != 0) input_.padStep = 1;
  if (pressed != 0) crossUsed_ = true;
}

void DeskControls::takePad(const GLFWgamepadstate& pad, bool asks) {
  input_.hasPad = true;
  takeCross(pad);
  std::uint32_t down = 0;
  for (std::size_t i = 0; i < kPadButtons.size(); ++i) {
    if (pad.buttons[kPadButtons[i]] == GLFW_PRESS) down |= 1U << i;
  }
  if (pad.axes[GLFW_GAMEPAD_AXIS_RIGHT_TRIGGER] > 0.0F) down |= 1U << kPadTrigger;  // at rest it is at −1
  buttons_.set(down, asks && !crossUsed_);
  const bool isA = down == 1U << kPadA;
  if (down != 0 && !isA) crossUsed_ = false;
  if (wasA_ && !isA) crossUsed_ = false;  // it has pressed the button of the wall
  wasA_ = isA;
  input_.padHeld = buttons_.isHeld(kPadA) || buttons_.isHeld(kPadTrigger);
  input_.brake = input_.brake || buttons_.isHeld(kPadB);
  input_.home = input_.home || buttons_.wasPressed(kPadY);
  input_.onwards = buttons_.wasPressed(kPadStart);
  input_.answer = buttons_.answered() + 1;
  const Vec3 left = stickOf(pad, GLFW_GAMEPAD_AXIS_LEFT_X, GLFW_GAMEPAD_AXIS_LEFT_Y);
  const Vec3 right = stickOf(pad, GLFW_GAMEPAD_AXIS_RIGHT_X, GLFW_GAMEPAD_AXIS_RIGHT_Y);
  input_.steer += Vec3(left.x, -left.y, 0.0);
  input_.padPull = right;
}

const DeskInput& DeskControls::gather(const std::optional<PointedWall>& mouse, bool mouseHeld,
                                      const WindowInput& input, const GLFWgamepadstate* pad, bool asks,
                                      bool mouseTurns) {
  input_ = {};
  input_.mouse = mouse;
  input_.mouseHeld = mouseHeld;
  input_.mouseTurns = mouseTurns;
  takeKeys(input);
  if (pad) {
    takePad(*pad, asks);
  } else {
    buttons_.set(0, asks);
  }
  input_.steer = glm::clamp(input_.steer, -1.0, 1.0);
  return input_;
}

const DeskInput& DeskControls::gather(const DisplayWalls& walls, const WindowInput& input, bool asks) {
  GLFWgamepadstate pad;
  const bool hasPad = readPad(pad);
  return gather(walls.pointedAt(), walls.isHeld(), input, hasPad ? &pad : nullptr, asks, walls.isTurning());
}

DeskDevices devicesOf(const DisplayWalls* walls, KeysOf place, std::optional<KeyboardLayout> keyboard) {
  if (!walls) return {};
  return [walls, controls = DeskControls(place), keyboard](const WindowInput& input, bool asks) mutable {
    if (keyboard) keyboard->follow(input);
    return controls.gather(*walls, input, asks);
  };
}

}  // namespace carom
