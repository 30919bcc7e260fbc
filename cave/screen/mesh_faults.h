#pragma once
// What a measured screen may not be, and its rim.

#include <array>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "cave/screen/screen_grid.h"
#include "cave/screen/screen_mesh.h"

namespace carom {

/// A place of the window's and the room's, as words: "0.31, 0.72 of the window, -1.52, 0.70, -3.10 m".
std::string wordsFor(const ScreenPoint& point);

/// Return why a screen cannot be drawn, with the place: a cell with an edge over a metre. Empty: there is
/// none.
std::string largeCellIn(const ScreenMesh& mesh);
std::string largeCellIn(const ScreenGrid& grid);

/// Returns why a screen cannot be drawn, with the place: two triangles show the same place of the window, or
/// neighbours turn by over 90° against each other in the room. Empty: neither.
std::string foldIn(const ScreenMesh& mesh);

/// Returns the edges at which the screen ends, as the window shows them.
std::vector<std::array<ScreenPoint, 2>> rimOf(const ScreenMesh& mesh);

}  // namespace carom
