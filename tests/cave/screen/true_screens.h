#pragma once
// Curved screens with their formulas: cylinders and domes, and the place in the window at which a ray meets
// them.

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "cave/screen/curved_screen.h"
#include "cave/screen/screen_grid.h"
#include "cave/screen/screen_shape.h"

namespace carom::test {

inline constexpr double kDegree = std::numbers::pi / 180.0;

/// A screen with its formula: the window's place of the first point of the true surface on a ray.
struct TrueScreen {
  std::string name;
  glm::ivec2 window_px;
  ScreenMesh mesh;
  glm::dvec3 middle_m;
  double sagitta_m;
  std::function<glm::dvec2(const glm::dvec3& from_m, const glm::dvec3& along)> inWindow;
  std::function<bool(const glm::dvec2&)> isScreen;
  std::function<glm::dvec3(const glm::dvec2&)> placeOn_m;  ///< in the room, of a place of the window
};

/// Returns the farther crossing of a ray with the circle or sphere of this radius about the origin, where the
/// ray begins inside.
template <typename Place>
double leaves_m(const Place& from, const Place& along, double radius_m) {
  const double a = glm::dot(along, along), b = glm::dot(from, along);
  return (-b + std::sqrt(b * b - a * (glm::dot(from, from) - radius_m * radius_m))) / a;
}

inline TrueScreen cylinder(double radius_m, double from_deg, double to_deg, const glm::ivec2& window_px,
                           double bottom_m = 0.1, double top_m = 2.6) {
  const CylinderScreen screen{.radius_m = radius_m,
                              .from_rad = from_deg * kDegree,
                              .to_rad = to_deg * kDegree,
                              .bottom_m = bottom_m,
                              .top_m = top_m};
  const auto inWindow = [screen](const glm::dvec3& from_m, const glm::dvec3& along) {
    const double at = leaves_m(glm::dvec2(from_m.x, from_m.z), glm::dvec2(along.x, along.z), screen.radius_m);
    const glm::dvec3 place_m = from_m + at * along;
    const double angle_rad = std::atan2(place_m.x, -place_m.z);
    return glm::dvec2((angle_rad - screen.from_rad) / (screen.to_rad - screen.from_rad),
                      (place_m.y - screen.bottom_m) / (screen.top_m - screen.bottom_m));
  };
  return {fmt::format("cylinder of {} m, {} to {}", radius_m, from_deg, to_deg),
          window_px,
          meshOf(screen, window_px),
          {0.0, 1.7, 0.0},
          0.1,
          inWindow,
          [](const glm::dvec2&) { return true; },
          [screen](const glm::dvec2& place) { return carom::placeOn_m(screen, place); }};
}

inline TrueScreen dome(double radius_m, double tilt_deg, double fov_deg) {
  const double tilt = tilt_deg * kDegree;
  const DomeScreen screen{.radius_m = radius_m,
                          .fov_rad = fov_deg * kDegree,
                          .axis = {0.0, std::cos(tilt), -std::sin(tilt)},
                          .front = {0.0, -std::sin(tilt), -std::cos(tilt)}};
  const auto inWindow = [screen](const glm::dvec3& from_m, const glm::dvec3& along) {
    const double at = leaves_m(from_m - screen.centre_m, along, screen.radius_m);
    const glm::dvec3 way = glm::normalize(from_m + at * along - screen.centre_m);
    const double share = std::acos(glm::dot(way, screen.axis)) / (0.5 * screen.fov_rad);
    const glm::dvec2 side(way.x, -glm::dot(way, screen.front));
    return 0.5 + 0.5 * share * side / glm::length(side);
  };
  return {fmt::format("dome of {} m, tilt {}, {} wide", radius_m, tilt_deg, fov_deg),
          {1024, 1024},
          meshOf(screen, {1024, 1024}),
          {0.0, 1.7, 0.0},
          0.3,
          inWindow,
          [](const glm::dvec2& place) { return glm::length(2.0 * place - 1.0) < 0.999; },
          [screen](const glm::dvec2& place) {
            return carom::placeOn_m(screen, place, {1024, 1024});
          }};
}

/// Returns the screen as a measurement has it: at the points of a grid over its window.
inline ScreenGrid gridOf(const TrueScreen& screen, int columns, int rows) {
  ScreenGrid grid{columns, rows, {}};
  constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const glm::dvec2 at((column + 0.5) / columns, (row + 0.5) / rows);
      grid.places.push_back(screen.isScreen(at) ? glm::vec3(screen.placeOn_m(at)) : glm::vec3(kNone));
    }
  }
  return grid;
}

/// Returns the screen as drawn from so many points.
inline TrueScreen measured(TrueScreen screen, int columns, int rows) {
  const std::vector<glm::dvec3> eyes_m = eyesAround(screen.middle_m, {0, 1, 0}, 1.5);
  screen.name += fmt::format(", measured at {} × {} points", columns, rows);
  screen.mesh = meshOf(gridOf(screen, columns, rows), screen.window_px, eyes_m).mesh;
  return screen;
}

/// Returns the screen as flat cells, so many across and up: two triangles each.
inline TrueScreen ofCells(TrueScreen screen, int columns, int rows) {
  screen.name += fmt::format(", of {} × {} flat cells", columns, rows);
  screen.mesh.clear();
  const auto point = [&](int column, int row) {
    const glm::dvec2 at(static_cast<double>(column) / columns, static_cast<double>(row) / rows);
    return ScreenPoint{at, screen.placeOn_m(at)};
  };
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const ScreenPoint a = point(column, row), b = point(column + 1, row), c = point(column + 1, row + 1),
                        d = point(column, row + 1);
      screen.mesh.push_back({a, b, c});
      screen.mesh.push_back({a, c, d});
    }
  }
  return screen;
}

inline std::vector<TrueScreen> screens() {
  return {cylinder(3.0, -150.0, 0.0, {4096, 1080}), cylinder(2.5, -40.0, 75.0, {1600, 900}),
          cylinder(3.2, 85.0, 170.0, {1024, 512}), dome(5.0, 20.0, 180.0), dome(3.0, 0.0, 220.0)};
}

inline CurvedScreen curved(const TrueScreen& screen) {
  const std::vector<glm::dvec3> eyes_m = eyesAround(screen.middle_m, {0, 1, 0}, 1.5);
  return curvedScreen(screen.mesh, {screen.window_px, 1.25, screen.sagitta_m, eyes_m});
}

inline glm::dvec3 eyeNear(const glm::dvec3& middle_m, std::mt19937_64& random) {
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  glm::dvec3 off(2.0);
  while (glm::length(off) > 1.0) off = {any(random), any(random), any(random)};
  return middle_m + off * glm::dvec3(1.5, 0.4, 1.5);
}

}  // namespace carom::test
