#pragma once
// The desktop input from GLFW: the mouse over the walls' windows, held keys, and a gamepad.
//
//   keys      W A S D steer, Space brakes, Home goes home; in a dry run the arrows walk, Page Up, Page Down,
//             Delete and End move the head (app/play/mouse_people.h)
//   mouse     aims at what it points to; its left button holds the cue, its right button turns the view
//   gamepad   left stick steers, A or the right trigger holds the cue, the right stick draws it back,
//             B brakes, Y goes home, Start goes on; while a lesson asks, A B X Y are its answers 1 to 4; the
//             cross goes through the buttons of the front wall, and A then presses the one it has come to
//
// A key or button that is pressed and let go between two frames counts as held in the next one.

#include <array>
#include <cstdint>
#include <functional>
#include <optional>

#include "app/input/desk_input.h"
#include "app/input/keyboard_layout.h"
#include "app/input/keys.h"
#include "cave/display/window.h"

struct GLFWgamepadstate;

namespace carom {

class DisplayWalls;

/// Dead zone of a stick: within this of its centre it counts as 0, and beyond it the value rises from 0 to 1.
inline constexpr double kDeadZone = 0.15;
Vec3 withoutDeadZone(const Vec3& stick);

/// The pressed buttons and their meaning: a button pressed while a lesson asks is an answer and has no other
/// meaning until it is pressed again.
class Buttons {
 public:
  /// Sets the pressed buttons (bit i: button i).
  void set(std::uint32_t down, bool asks);
  bool isHeld(int button) const { return (meant_ >> button & 1U) != 0; }
  bool wasPressed(int button) const { return isHeld(button) && (fresh_ >> button & 1U) != 0; }
  /// Returns the first button that was pressed while a lesson asks, or −1 if there is none.
  int answered() const { return answered_; }

 private:
  std::uint32_t down_ = 0, meant_ = 0, fresh_ = 0;
  int answered_ = -1;
};

class DeskControls {
 public:
  /// In a replay Space and Home have another meaning (app/input/keys.h).
  explicit DeskControls(KeysOf place) : place_(place) {}

  /// Collects the input once per frame, after the windows have been polled. While `asks`, a lesson waits for
  /// an answer.
  const DeskInput& gather(const DisplayWalls& walls, const WindowInput& input, bool asks);

  /// Does the same for input collected by the caller. `pad` is null if there is no gamepad.
  const DeskInput& gather(const std::optional<PointedWall>& mouse, bool mouseHeld, const WindowInput& input,
                          const GLFWgamepadstate* pad, bool asks, bool mouseTurns = false);

 private:
  void takeKeys(const WindowInput& input);
  void takePad(const GLFWgamepadstate& pad, bool asks);
  void takeCross(const GLFWgamepadstate& pad);

  KeysOf place_;
  DeskInput input_;
  std::array<bool, 13> held_{};  ///< keys, in the order of kHeldKeys of desk_controls.cpp
  Buttons buttons_;
  bool wasA_ = false;       ///< A alone was down in the frame before
  unsigned cross_ = 0;      ///< the directions of the cross that are pressed
  bool crossUsed_ = false;  ///< it has been since another button was pressed: A is for the front wall
};

/// The devices of a desk: returns their input in a frame. `asks`: a lesson waits for an answer.
using DeskDevices = std::function<DeskInput(const WindowInput& input, bool asks)>;

/// Returns the devices over the windows of these walls, which must outlive them; none if `walls` is null.
/// With a `keyboard`, its layout names the keys.
DeskDevices devicesOf(const DisplayWalls* walls, KeysOf place, std::optional<KeyboardLayout> keyboard = {});

}  // namespace carom
