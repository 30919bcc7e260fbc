#pragma once
// The input of the hand that holds the cue in one frame, independent of the device. Room frame.

#include <array>
#include <cstddef>
#include <string_view>

#include "cave/texts/texts.h"
#include "engine/spacetime/event.h"
#include "engine/spacetime/observer.h"

namespace carom {

/// The devices that hold the cue.
inline constexpr std::array<std::string_view, 3> kHandDevices{"wand", "mouse", "gamepad"};
inline constexpr std::string_view kHandWand = kHandDevices[0], kHandGamepad = kHandDevices[2];

struct HandInput {
  /// One of kHandDevices; empty if no hand aims. If a device is lost while it
  /// holds the cue, the next frame has another one or none here, and the stroke is cancelled.
  std::string_view device;
  Vec3 from_m{0.0};       ///< position of the hand, where its ray and its stroke start
  Vec3 along{0.0};        ///< unit vector of its direction
  Eye eye = Eye::middle;  ///< the eye from whose view it aims
  bool held = false;      ///< its button is down
  /// While `held`: the displacement since the button was pressed. The stroke goes in the opposite direction.
  Vec3 pull_m{0.0};
  /// With a force device: the draw of one unit of rapidity. 0: without one.
  double d0_m = 0.0;
  texts::Text refused{};  ///< message to the player when another device was refused the cue in this frame
  bool pressed = false;   ///< the button went down in this frame, even if it may not take the cue
};

}  // namespace carom
