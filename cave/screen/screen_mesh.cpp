#include "cave/screen/screen_mesh.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace carom {
namespace {

ScreenPoint between(const ScreenPoint& a, const ScreenPoint& b, double share) {
  return {glm::mix(a.inWindow, b.inWindow, share), glm::mix(a.inRoom_m, b.inRoom_m, share)};
}

ScreenPoint weighted(const ScreenTriangle& triangle, const glm::dvec3& weights) {
  ScreenPoint sum;
  for (int corner = 0; corner < 3; ++corner) {
    sum.inWindow += weights[corner] * triangle[static_cast<std::size_t>(corner)].inWindow;
    sum.inRoom_m += weights[corner] * triangle[static_cast<std::size_t>(corner)].inRoom_m;
  }
  return sum;
}

double cross(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

}  // namespace

double windowArea(const ScreenTriangle& triangle) {
  return cross(triangle[1].inWindow - triangle[0].inWindow, triangle[2].inWindow - triangle[0].inWindow);
}

// Sutherland and Hodgman (1974): the corners on the side that stays, and the points where an edge crosses the
// line.
ScreenMesh cutAt(const ScreenMesh& mesh, int axis, double at, bool above) {
  ScreenMesh part;
  std::vector<ScreenPoint> corners;
  const auto depth = [&](const ScreenPoint& point) {
    return above ? point.inWindow[axis] - at : at - point.inWindow[axis];
  };
  for (const ScreenTriangle& triangle : mesh) {
    corners.clear();
    for (std::size_t i = 0; i < 3; ++i) {
      const ScreenPoint &from = triangle[i], &to = triangle[(i + 1) % 3];
      const double fromDepth = depth(from), toDepth = depth(to);
      if (fromDepth >= 0.0) corners.push_back(from);
      if ((fromDepth > 0.0 && toDepth < 0.0) || (fromDepth < 0.0 && toDepth > 0.0)) {
        corners.push_back(between(from, to, fromDepth / (fromDepth - toDepth)));
        corners.back().inWindow[axis] = at;
      }
    }
    for (std::size_t i = 2; i < corners.size(); ++i) {
      const ScreenTriangle kept{corners[0], corners[i - 1], corners[i]};
      if (windowArea(kept) != 0.0) part.push_back(kept);
    }
  }
  return part;
}

std::optional<glm::dvec3> inRoom_m(const ScreenMesh& mesh, const glm::dvec2& inWindow) {
  constexpr double kOnEdge = -1e-9;  // rounding along a shared edge
  for (const ScreenTriangle& triangle : mesh) {
    const double area = windowArea(triangle);
    const glm::dvec2 from = inWindow - triangle[0].inWindow;
    const double b = cross(from, triangle[2].inWindow - triangle[0].inWindow) / area;
    const double c = cross(triangle[1].inWindow - triangle[0].inWindow, from) / area;
    if (b >= kOnEdge && c >= kOnEdge && b + c <= 1.0 - kOnEdge)
      return weighted(triangle, {1.0 - b - c, b, c}).inRoom_m;
  }
  return std::nullopt;
}

// T. Möller and B. Trumbore, "Fast, minimum storage ray-triangle intersection", 1997.
std::optional<ScreenPoint> hit(const ScreenMesh& mesh, const glm::dvec3& from_m, const glm::dvec3& along) {
  constexpr double kOnEdge = 1e-9;
  std::optional<ScreenPoint> first;
  double nearest_m = 0.0;
  for (const ScreenTriangle& triangle : mesh) {
    const glm::dvec3 b_m = triangle[1].inRoom_m - triangle[0].inRoom_m;
    const glm::dvec3 c_m = triangle[2].inRoom_m - triangle[0].inRoom_m;
    const glm::dvec3 across = glm::cross(along, c_m);
    const double volume = glm::dot(b_m, across);
    if (volume == 0.0) continue;
    const glm::dvec3 corner_m = from_m - triangle[0].inRoom_m;
    const glm::dvec3 turned = glm::cross(corner_m, b_m);
    const double b = glm::dot(corner_m, across) / volume, c = glm::dot(along, turned) / volume;
    const double at_m = glm::dot(c_m, turned) / volume;
    if (!(b >= -kOnEdge && c >= -kOnEdge && b + c <= 1.0 + kOnEdge && at_m > 0.0)) continue;
    if (first && at_m >= nearest_m) continue;
    nearest_m = at_m;
    first = weighted(triangle, {1.0 - b - c, b, c});
  }
  return first;
}

}  // namespace carom
