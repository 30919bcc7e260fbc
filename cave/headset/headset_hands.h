#pragma once
// The hands of a headset's wearer: a controller's aim, trigger, buttons and stick.

#include <glm/vec2.hpp>

#include "engine/base/pose.h"

namespace carom {

/// A hand at the moment of a frame's display. Room frame; its aim is along -z.
struct HeadsetHand {
  bool isTracked = false;
  Pose roomFromAim;
  /// Whether the trigger is held: from 0.7 of its way until it is back at 0.4, so that it neither flickers nor sticks.
  bool trigger = false;
  bool first = false, second = false, menu = false;  ///< its buttons: A or X, B or Y, menu
  glm::dvec2 stick{0.0};                             ///< to the right and forwards, -1 to 1
};

/// Returns whether a trigger is held that is pulled this far (0 to 1).
inline bool isHeld(bool wasHeld, double pulled) { return pulled >= (wasHeld ? 0.4 : 0.7); }

}  // namespace carom
