#pragma once
// The test pattern of a curved screen, in two parts. What lies by the pixel's own point of the screen: its
// rim, lines every 10 cm along a cylinder and up it, meridians and parallels of a dome every 10 degrees,
// planes of the room every 0.5 m on any other screen, and circles about points of the screen. And what goes
// through the flat pieces, as the session does: a cross at each of these points, which must sit in its circle
// for the eye that it was drawn for.

#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "cave/pictures/image.h"
#include "cave/room/wall.h"
#include "cave/screen/curved_screen.h"

namespace carom {

/// The points of a screen that the pattern marks, with their places in the window: about a hundred.
std::vector<ScreenPoint> markedPoints(const CurvedScreen& screen);

/// Returns the picture of a piece with a white cross at each of the marked points.
Image crossesOn(const FlatPiece& piece, const std::vector<ScreenPoint>& marked,
                const glm::dvec3& eyeInRoom_m);

/// Draws the lines, circles and words of `wall`, which has a curved screen, over its window's picture with
/// the crosses.
Image screenPattern(const Wall& wall, Eye eye, Image crosses);

}  // namespace carom
