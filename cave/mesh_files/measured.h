#pragma once
// Makes a wall's screen of a file with measured places.

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "cave/screen/curved_screen.h"
#include "cave/screen/measured_screen.h"

namespace carom {

/// How a measured screen is drawn.
struct MeasuredWishes {
  glm::ivec2 window_px{0};
  double texelsPerPixel = 1.25;  ///< as in PieceWishes
  double sagitta_m = 0.1;        ///< the same
  glm::dvec3 up{0.0, 1.0, 0.0};  ///< of the room
  double eyes_m = 1.7;           ///< above the floor, where the height of eyes is not known
  double reach_m = 1.5;          ///< of somebody who walks
};

/// Returns the screen; without pieces, it cannot be drawn on so few flat walls. It is made for somebody who
/// walks about the room's origin, or, where the origin is behind the screen, before its middle. Throws
/// std::runtime_error, with the file's name and a place, if the file cannot be read, or if the mesh folds
/// over itself or has a cell larger than a metre.
CurvedScreen screenOf(const MeasuredScreen& measured, const MeasuredWishes& wishes);

}  // namespace carom
