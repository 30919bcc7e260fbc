#pragma once
// A screen that need not be flat, as triangles: each point of them has its place in the window, that is, in
// the picture that a projector or display shows, and its place in the room. Between the points of a triangle
// both are linear in each other.

#include <array>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace carom {

struct ScreenPoint {
  glm::dvec2 inWindow{0.0};  ///< 0 to 1 from the window's lower left
  glm::dvec3 inRoom_m{0.0};
};

using ScreenTriangle = std::array<ScreenPoint, 3>;
using ScreenMesh = std::vector<ScreenTriangle>;

/// Returns twice the area of the triangle in the window; positive where its points run anticlockwise.
double windowArea(const ScreenTriangle& triangle);

/// Returns the part of the mesh on one side of a line of the window: where inWindow[axis] is at most `at`, or
/// at least, if `above`.
ScreenMesh cutAt(const ScreenMesh& mesh, int axis, double at, bool above);

/// Returns the point of the screen that the window shows at a place, or none where it shows no screen.
std::optional<glm::dvec3> inRoom_m(const ScreenMesh& mesh, const glm::dvec2& inWindow);

/// Returns the first point of the screen on a ray, or none.
std::optional<ScreenPoint> hit(const ScreenMesh& mesh, const glm::dvec3& from_m, const glm::dvec3& along);

}  // namespace carom
