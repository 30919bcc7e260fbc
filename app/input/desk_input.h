#pragma once
// What hands at a desk do: mouse, keyboard, gamepad. Gathered once a frame from rank 0's windows.

#include <optional>

#include "cave/room/wall_pointer.h"
#include "engine/spacetime/event.h"

namespace carom {

struct DeskInput {
  std::optional<PointedWall> mouse;  ///< none: over no wall
  bool mouseHeld = false;            ///< left button
  /// Keys and gamepad that are held, or pads' sticks: right, forward, up; −1 to 1 each.
  Vec3 steer{0.0};
  bool brake = false;
  bool home = false;  ///< pressed since the frame before
  /// Of a gamepad: a cue that is aimed by looking and drawn back with the right stick.
  bool hasPad = false;
  bool padHeld = false;
  Vec3 padPull{0.0};     ///< right, back; −1 to 1 each, along the floor
  int answer = 0;        ///< the button that answers a lesson's question, from 1; 0: none was pressed
  bool onwards = false;  ///< the button for "go on" was pressed
};

}  // namespace carom
