#include "cave/room/rectangle.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace carom {

double squareMiss_m(const std::array<glm::dvec3, 3>& corners_m) {
  const glm::dvec3 first = corners_m[0] - corners_m[1];
  return glm::dot(first, corners_m[2] - corners_m[1]) / glm::length(first);
}

std::optional<CornerFault> rectangleFault(std::string_view wall, const ThreeCorners& corners) {
  const auto& [a, b, c] = corners.at_m;
  const double first_m = glm::distance(a, b), second_m = glm::distance(b, c);
  const auto tooShort = [&](std::size_t corner, bool width, std::size_t other) {
    return CornerFault{corner,
                       fmt::format("wall '{}' has no {}, expected {} apart from {}", wall,
                                   width ? "width" : "height", corners.names[corner], corners.names[other])};
  };
  if (!(first_m >= kShortestEdge_m)) return tooShort(0, corners.widthFirst, 1);
  if (!(second_m >= kShortestEdge_m)) return tooShort(2, !corners.widthFirst, 1);
  const double apart_m = glm::length(glm::cross(a - b, c - b)) / std::max(first_m, second_m);
  if (!(apart_m >= kShortestEdge_m)) {
    return CornerFault{2,
                       fmt::format("the corners of wall '{}' lie on one line, expected a rectangle", wall)};
  }
  const double miss_m = std::abs(squareMiss_m(corners.at_m));
  if (miss_m <= kCornerMiss_m) return {};
  const double angle_deg =
      std::acos(glm::dot(a - b, c - b) / (first_m * second_m)) * 180.0 / std::numbers::pi;
  return CornerFault{
      2, fmt::format(
             "{} of wall '{}' misses the right angle at {} by {:.1f} mm ({:.2f} degrees there), expected "
             "at most {:.0f} mm",
             corners.names[2], wall, corners.names[1], miss_m * 1e3, angle_deg, kCornerMiss_m * 1e3)};
}

}  // namespace carom
