#pragma once
// The test pattern of a wall: a still picture from which an operator reads whether the right projector shows
// the right wall to the right eye, whole, upright, in its true size.

#include "cave/patterns/pattern_canvas.h"
#include "cave/pictures/image.h"
#include "cave/room/wall.h"

namespace carom {

/// Draws the pattern of `wall` for one eye: the wall's name and node, the three corners that the rig gives
/// and the fourth (room frame, m), its size, "left", "right" or "mono", a grid in true centimetres, a circle
/// that is round on the wall, colour bars, a white frame along the picture's outermost pixels, and a bar that
/// only one eye has: red towards the left edge for the left eye, cyan towards the right edge for the right. A
/// pure function: the same arguments give the same pixels.
Image calibrationPattern(const Wall& wall, Eye eye);

}  // namespace carom
