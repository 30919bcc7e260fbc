#pragma once
// The desktop input of one frame from mouse, keyboard and gamepad, collected from rank 0's windows.

#include <optional>

#include "cave/screen/wall_pointer.h"
#include "engine/spacetime/event.h"

namespace carom {

/// A mouse that points farther over the cloth, near the horizon, points nowhere.
inline constexpr double kFarthestOnCloth_m = 10.0;

struct DeskInput {
  std::optional<PointedWall> mouse;  ///< empty if the mouse is over no wall
  bool mouseHeld = false;            ///< left button
  bool mouseTurns = false;           ///< right button
  bool mouseAims = true;             ///< false: the wand does, which the mouse moves
  /// Sum of held keys and gamepad sticks: right, forward, up; −1 to 1 each.
  Vec3 steer{0.0};
  /// Held keys that move a head of a dry run (app/play/mouse_people.h): right, forward, up; −1 to 1 each.
  Vec3 walk{0.0};
  double look = 0.0;  ///< those that turn it: to the left −1, to the right 1
  bool brake = false;
  bool home = false;  ///< pressed since the previous frame
  /// A gamepad's cue, aimed with the head and drawn back with the right stick.
  bool hasPad = false;
  bool padHeld = false;
  int padStep = 0;       ///< its cross was pressed: 1 right or down, −1 left or up
  Vec3 padPull{0.0};     ///< right, back; −1 to 1 each, along the floor
  int answer = 0;        ///< number of the lesson's answer that was pressed, from 1; 0 if none
  bool onwards = false;  ///< the button for "go on" was pressed
};

}  // namespace carom
