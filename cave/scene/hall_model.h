#pragma once
// The hall around the table, at rest on the board: straight lines and columns that make aberration visible,
// and walls of four tints for orientation.

#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "cave/scene/scene_part.h"

namespace carom {

/// Returns the floor, walls, ceiling, columns and wall clocks.
std::vector<ScenePart> hallParts(const Hall& hall);

/// Returns three hanging lamps along x at these places.
std::vector<ScenePart> lampParts(std::span<const glm::dvec3> lamps_m, double ceiling_m);

}  // namespace carom
