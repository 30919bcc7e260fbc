#pragma once
// The hall around the table: a box at rest on the board, centred on its origin.

#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace carom {

struct Hall {
  double floor_m = -0.75;
  glm::dvec3 size_m{14.0, 12.0, 5.0};  ///< at least; larger around a large table
};

/// Returns the size of the hall's floor around a table of this size: at least 5 m from the table to each
/// wall.
inline glm::dvec2 hallFloor_m(const glm::dvec2& table_m, const Hall& hall = {}) {
  constexpr double kAroundTable_m = 5.0;
  return glm::max(glm::dvec2(hall.size_m), table_m + 2.0 * kAroundTable_m);
}

}  // namespace carom
