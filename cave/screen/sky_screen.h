#pragma once
// The screen of a picture by direction.

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "cave/screen/curved_screen.h"
#include "cave/screen/sky.h"

namespace carom {

/// Returns the direction that a picture shows at a place, a unit vector.
glm::dvec3 directionOf(const Sky& sky, const glm::dvec2& inPicture, const glm::ivec2& picture_px);

/// Returns the screen, `texelsPerPixel` as in PieceWishes.
CurvedScreen screenOf(const Sky& sky, const glm::ivec2& picture_px, double texelsPerPixel);

}  // namespace carom
