#pragma once
// Screens that are given by a formula: cylinders and domes.

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "cave/screen/screen_mesh.h"

namespace carom {

/// So far at most a place of the window is drawn off its place on a curved screen.
inline constexpr double kMostOff_px = 0.05;

/// Part of a cylinder, seen from its inside. Angles are about the axis, from the direction `ahead`, positive
/// to the right of somebody who looks that way with the axis upwards. Room frame, metres and radians.
struct CylinderScreen {
  glm::dvec3 foot_m{0.0};            ///< on the axis: heights are from here
  glm::dvec3 axis{0.0, 1.0, 0.0};    ///< unit vector
  glm::dvec3 ahead{0.0, 0.0, -1.0};  ///< unit vector, at a right angle to the axis
  double radius_m = 3.0;
  double from_rad = -1.0, to_rad = 1.0;
  double bottom_m = 0.0, top_m = 2.5;
};

/// Part of a sphere, seen from its inside; its window is the circle of a fisheye: a point at the angle θ from
/// the dome's axis is at the share θ/(fov/2) of the circle's radius. The front is at the bottom of the
/// window, and its left at the left, as of a picture that somebody sees who faces the front and looks up.
/// Where the window is no square the circle fits its shorter side.
struct DomeScreen {
  glm::dvec3 centre_m{0.0, 1.2, 0.0};
  double radius_m = 5.0;
  double fov_rad = 3.141592653589793;
  glm::dvec3 axis{0.0, 1.0, 0.0};  ///< unit vector, to the middle of the window
  glm::dvec3 front{0.0, 0.0,
                   -1.0};  ///< unit vector at a right angle to the axis, to the bottom of the window
};

/// Returns the point of the screen that the window shows at a place.
glm::dvec3 placeOn_m(const CylinderScreen& screen, const glm::dvec2& inWindow);
/// `window_px`: the window's size. A place outside the circle is on the sphere's continuation.
glm::dvec3 placeOn_m(const DomeScreen& screen, const glm::dvec2& inWindow, const glm::ivec2& window_px);

/// Returns the screen as triangles so small that no place of the window is off by more than kMostOff_px.
ScreenMesh meshOf(const CylinderScreen& screen, const glm::ivec2& window_px);
ScreenMesh meshOf(const DomeScreen& screen, const glm::ivec2& window_px);

}  // namespace carom
