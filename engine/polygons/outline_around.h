#pragma once
// An outline with few corners around a polygon with many.

#include <cstddef>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

namespace carom {

/// Returns the corners of the convex hull of some points, anticlockwise, without those on its sides.
std::vector<glm::dvec2> hullOf(std::span<const glm::dvec2> points);

/// Returns an outline that contains `ring`, a simple polygon that runs anticlockwise, and is nowhere farther
/// than `most` from it. Corners on straight sides go. While there are more than `enough` corners, that dent
/// is filled, or that side lost between its prolonged neighbours, which carries the outline least outwards;
/// if none may go any more, there are more than `enough`.
std::vector<glm::dvec2> outlineAround(std::span<const glm::dvec2> ring, double most, std::size_t enough);

}  // namespace carom
