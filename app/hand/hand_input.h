#pragma once
// What the one hand that holds the cue does in a frame, whatever device tells of it. Room frame.

#include <cstddef>
#include <string_view>

#include "engine/spacetime/event.h"
#include "engine/spacetime/observer.h"

namespace carom {

struct HandInput {
  /// "wand", "mouse", "gamepad"; empty: no hand aims. Of static duration. A device that is lost while it
  /// holds the cue has another, or none, in its place in the next frame: the stroke is then off.
  std::string_view device;
  Vec3 from_m{0.0};       ///< where the hand is: its ray and its stroke start here
  Vec3 along{0.0};        ///< unit vector: the way it points
  Eye eye = Eye::middle;  ///< by whose sight it aims
  bool held = false;      ///< its button is down
  /// While it is held: how far, and whereto, it has been drawn since it was pressed; the way of the stroke is
  /// the other way round.
  Vec3 pull_m{0.0};
  /// What was refused in this frame by those who hold the devices apart: a line for the person, of static
  /// duration. Empty: nothing.
  std::string_view refused = {};
};

}  // namespace carom
