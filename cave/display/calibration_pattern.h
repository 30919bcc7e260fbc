#pragma once
// The test pattern of a wall: a still picture from which an operator reads whether the right projector shows
// the right wall to the right eye, whole, upright, in its true size.

#include <glm/vec2.hpp>

#include "cave/gl/image.h"
#include "cave/room/wall.h"

namespace carom {

/// Lengths and places in the pattern, as fractions of the picture's width and height or in metres.
struct CalibrationPatternLayout {
  static constexpr double kLine_m = 0.1;  ///< between strong grid lines, from the lower left corner
  static constexpr double kFineLine_m =
      0.01;  ///< between weak grid lines, which need pixels that are small enough
  static constexpr double kFinest_px = 4.0;  ///< weak lines closer together than this are left out
  static constexpr double kCircle = 0.4;     ///< radius, as a fraction of the wall's shorter side
  static constexpr double kEyeBar = 0.06;    ///< distance of one eye's bar from its own side of the picture
  static constexpr double kEyeBarWidth = 0.04;          ///< width of that bar
  static constexpr glm::dvec2 kEyeBarRows{0.25, 0.75};  ///< lower and upper end of that bar
};

/// Draws the pattern of `wall` for one eye: the wall's name and node, the three corners that the rig gives
/// and the fourth (room frame, m), its size, "left", "right" or "mono", a grid in true centimetres, a circle
/// that is round on the wall, colour bars, a white frame along the picture's outermost pixels, and a bar that
/// only one eye has: red towards the left edge for the left eye, cyan towards the right edge for the right. A
/// pure function: the same arguments give the same pixels.
Image calibrationPattern(const Wall& wall, Eye eye);

}  // namespace carom
