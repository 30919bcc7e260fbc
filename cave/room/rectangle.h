#pragma once
// Whether three measured corners make a wall.

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include <glm/vec3.hpp>

namespace carom {

/// Walls are measured with a tape: corners may miss a rectangle by this much.
inline constexpr double kCornerMiss_m = 0.002;
/// Edges below this make no wall.
inline constexpr double kShortestEdge_m = 0.001;

/// Three corners in the order in which they are joined by two edges, and what their file calls them.
struct ThreeCorners {
  std::array<glm::dvec3, 3> at_m;
  std::array<std::string_view, 3> names;
  bool widthFirst = true;  ///< the first edge is the wall's width, the second its height
};

struct CornerFault {
  std::size_t corner = 0;  ///< which of the three
  std::string what;
};

/// None if they span a rectangle to kCornerMiss_m.
std::optional<CornerFault> rectangleFault(std::string_view wall, const ThreeCorners& corners);

/// How far the last corner is from where a right angle at the middle one would have it, along the first edge;
/// signed: above zero where the angle is below 90 degrees.
double squareMiss_m(const std::array<glm::dvec3, 3>& corners_m);

}  // namespace carom
