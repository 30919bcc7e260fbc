#pragma once
// Checks whether three measured corners make a wall.

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include <glm/vec3.hpp>

namespace carom {

/// Walls are measured with a tape: their corners may deviate from a rectangle by this much.
inline constexpr double kCornerMiss_m = 0.002;
/// An edge shorter than this makes no wall.
inline constexpr double kShortestEdge_m = 0.001;

/// Three corners in the order in which two edges join them, with their names in the file.
struct ThreeCorners {
  std::array<glm::dvec3, 3> at_m;
  std::array<std::string_view, 3> names;
  bool widthFirst = true;  ///< the first edge is the wall's width, the second its height
};

struct CornerFault {
  std::size_t corner = 0;  ///< which of the three corners
  std::string what;
};

/// Returns none if the corners span a rectangle within kCornerMiss_m.
std::optional<CornerFault> rectangleFault(std::string_view wall, const ThreeCorners& corners);

/// Returns how far the last corner lies, along the first edge, from where a right angle at the middle corner
/// would put it; positive if the angle is below 90 degrees.
double squareMiss_m(const std::array<glm::dvec3, 3>& corners_m);

}  // namespace carom
