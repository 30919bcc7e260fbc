#pragma once
// A screen that has been measured at the points of a grid over its window.

#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "cave/screen/screen_mesh.h"

namespace carom {

/// Point (column, row) is at (column + 0.5) / columns, (row + 0.5) / rows in the window, from its lower left.
struct ScreenGrid {
  int columns = 0, rows = 0;
  std::vector<glm::vec3> places;  ///< row by row from the window's bottom; NaN: there is no screen

  const glm::vec3& at(int column, int row) const {
    return places[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                  static_cast<std::size_t>(column)];
  }
};

/// Returns whether four neighbours are on the screen.
bool hasCell(const ScreenGrid& grid);

struct GridMesh {
  ScreenMesh mesh;
  int finer = 1;  ///< by how much its cells are finer than the grid's, each way
};

/// Returns the screen as triangles: cells with a corner that is not on the screen are left out. Where flat
/// cells would show a picture over 0.1 pixels off its place, as slideOf_px predicts for `eyes_m`, the cells
/// are finer, by a Catmull–Rom surface through the points (E. Catmull and R. Rom, "A class of local
/// interpolating splines", 1974). Where the screen reaches the last points of the grid, it goes on to the
/// window's rim as the parabola through the last three points. A grid of very many points is thinned where
/// they lie in a plane within a fiftieth of a pixel, or within one at most if it is ragged; without
/// triangles, it is too ragged for that. The places must be in metres, in the room.
GridMesh meshOf(const ScreenGrid& grid, const glm::ivec2& window_px, std::span<const glm::dvec3> eyes_m);

}  // namespace carom
