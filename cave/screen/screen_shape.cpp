#include "cave/screen/screen_shape.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace carom {
namespace {

/// Returns how long a cell may be in pixels of the window where a curve of this radius is drawn as chords: a
/// chord of length L stands off its arc by L²/(8R).
double cell_px(double radius_px) { return std::sqrt(8.0 * kMostOff_px * radius_px); }

/// Returns the two triangles of a cell, from its corners in the order lower left, lower right, upper right,
/// upper left as the window shows them.
void addCell(const std::array<ScreenPoint, 4>& corners, ScreenMesh& mesh) {
  for (const ScreenTriangle& half : {ScreenTriangle{corners[0], corners[1], corners[2]},
                                     ScreenTriangle{corners[0], corners[2], corners[3]}}) {
    if (windowArea(half) != 0.0) mesh.push_back(half);
  }
}

/// Returns the share of the window's sides that the dome's circle takes.
glm::dvec2 circleOf(const glm::ivec2& window_px) {
  return static_cast<double>(std::min(window_px.x, window_px.y)) / glm::dvec2(window_px);
}

}  // namespace

glm::dvec3 placeOn_m(const CylinderScreen& screen, const glm::dvec2& inWindow) {
  const double angle_rad = glm::mix(screen.from_rad, screen.to_rad, inWindow.x);
  const glm::dvec3 right = glm::cross(screen.ahead, screen.axis);
  return screen.foot_m + glm::mix(screen.bottom_m, screen.top_m, inWindow.y) * screen.axis +
         screen.radius_m * (std::cos(angle_rad) * screen.ahead + std::sin(angle_rad) * right);
}

glm::dvec3 placeOn_m(const DomeScreen& screen, const glm::dvec2& inWindow, const glm::ivec2& window_px) {
  const glm::dvec2 inCircle = (2.0 * inWindow - 1.0) / circleOf(window_px);
  const double share = glm::length(inCircle), off_rad = 0.5 * screen.fov_rad * share;
  if (!(share > 0.0)) return screen.centre_m + screen.radius_m * screen.axis;
  const glm::dvec3 right = glm::cross(screen.front, screen.axis);
  const glm::dvec3 aside = (inCircle.x * right - inCircle.y * screen.front) / share;
  return screen.centre_m + screen.radius_m * (std::cos(off_rad) * screen.axis + std::sin(off_rad) * aside);
}

ScreenMesh meshOf(const CylinderScreen& screen, const glm::ivec2& window_px) {
  const double arc_rad = screen.to_rad - screen.from_rad;
  const double radius_px = window_px.x / arc_rad;
  const int columns = std::max(1, static_cast<int>(std::ceil(window_px.x / cell_px(radius_px))));
  ScreenMesh mesh;
  const auto point = [&](int column, double height) {
    const glm::dvec2 inWindow(static_cast<double>(column) / columns, height);
    return ScreenPoint{inWindow, placeOn_m(screen, inWindow)};
  };
  for (int column = 0; column < columns; ++column)
    addCell({point(column, 0.0), point(column + 1, 0.0), point(column + 1, 1.0), point(column, 1.0)}, mesh);
  return mesh;
}

// The cells are those of a net of circles and radii about the middle of the window, so that its rim is a
// circle.
ScreenMesh meshOf(const DomeScreen& screen, const glm::ivec2& window_px) {
  const glm::dvec2 circle = circleOf(window_px);
  const double radius_px = 0.5 * std::min(window_px.x, window_px.y);
  const double cell = cell_px(radius_px / std::max(0.5 * screen.fov_rad, 1.0));
  const int rings = std::max(2, static_cast<int>(std::ceil(radius_px / cell)));
  const int parts =
      4 * std::max(2, static_cast<int>(std::ceil(2.0 * std::numbers::pi * radius_px / cell / 4)));
  ScreenMesh mesh;
  const auto point = [&](int ring, int part) {
    const double angle_rad = 2.0 * std::numbers::pi * (part % parts) / parts;
    const double share = static_cast<double>(ring) / rings;
    const glm::dvec2 inWindow =
        0.5 + 0.5 * circle * share * glm::dvec2(std::cos(angle_rad), std::sin(angle_rad));
    return ScreenPoint{inWindow, placeOn_m(screen, inWindow, window_px)};
  };
  for (int ring = 0; ring < rings; ++ring) {
    for (int part = 0; part < parts; ++part)
      addCell({point(ring, part), point(ring + 1, part), point(ring + 1, part + 1), point(ring, part + 1)},
              mesh);
  }
  return mesh;
}

}  // namespace carom
