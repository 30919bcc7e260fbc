#pragma once
// What a headset says of one frame, and what a frame's record keeps of it.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "cave/room/headset_walls.h"
#include "engine/base/pose.h"

namespace carom {

/// A hand at the moment of a frame's display: a controller's aim, trigger, buttons and stick. Room
/// frame; its aim is along -z.
struct HeadsetHand {
  bool isTracked = false;
  Pose roomFromAim;
  /// Whether the trigger is held: from 0.7 of its way until it is back at 0.4, so that it neither flickers
  /// nor sticks.
  bool trigger = false;
  bool first = false, second = false, menu = false;  ///< its buttons: A or X, B or Y, menu
  glm::dvec2 stick{0.0};                             ///< to the right and forwards, -1 to 1
};

/// Returns whether a trigger is held that is pulled this far (0 to 1).
inline bool isHeld(bool wasHeld, double pulled) { return pulled >= (wasHeld ? 0.4 : 0.7); }

/// What the runtime says of one frame, all for the moment of its display.
struct HeadsetFrame {
  std::int64_t display_ns = 0;    ///< of the runtime's clock
  std::int64_t untilNext_ns = 0;  ///< the runtime's period
  bool isSeen = false;            ///< the pictures will be shown; else submit nothing
  bool hasPosition = true;        ///< the eyes' places are known; else they are those of the frame before
  bool isTracked = false;         ///< so are their directions; else they are those of the frame before
  bool isRecentred = false;       ///< the room's origin has moved since the frame before
  std::array<HeadsetEye, 2> eyes;
  /// dx/dt of the head by the runtime's own account, if it gives one. Not reliable: some runtimes give zero,
  /// others the velocity of 35 ms ago.
  std::optional<glm::dvec3> runtimeVelocity_m_s;
  std::array<HeadsetHand, 2> hands;  ///< left, right; none is tracked while the session has no focus
  std::size_t aiming = 1;            ///< the hand that holds or aims the cue
};

/// Returns which hand holds or aims the cue, if `aiming` did: the other one takes over with its trigger, or
/// when that one is lost.
inline std::size_t aimingHand(std::size_t aiming, const std::array<HeadsetHand, 2>& hands) {
  const HeadsetHand &one = hands[aiming], &other = hands[1 - aiming];
  const bool takesOver = other.isTracked && (!one.isTracked || (other.trigger && !one.trigger));
  return takesOver ? 1 - aiming : aiming;
}

/// What a frame's record keeps of the headset for which it was decided.
struct HeadsetState {
  std::array<HeadsetEye, 2> eyes;
  glm::dvec3 runtimeVelocity_m_s{0.0};
  std::uint8_t isWorn = 0;         ///< 1: there is a headset; the rest has a meaning only then
  std::uint8_t velocityKnown = 0;  ///< 1: the runtime gives a velocity
};

}  // namespace carom
