#pragma once
// A puck that shines, drawn alone, and where its pixels are.

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>

#include "cave/pictures/image.h"
#include "cave/room/wall.h"
#include "cave/scene/puck_model.h"
#include "cave/scene/scene.h"

namespace carom::test {

/// A scene of one shining puck, body 1, and nothing that rests.
inline Scene glowingPuck(double radius_m, const glm::vec3& colour = glm::vec3(1.0F)) {
  Scene scene;
  scene.bodyCount = 2;
  for (ScenePart& part : puckParts(radius_m, 0.8 * radius_m, 1, colour)) {
    if (part.paint != Paint::puck) continue;
    part.paint = Paint::lamp;
    part.roughness = 0.0F;
    scene.parts.push_back(part);
  }
  return scene;
}

/// A wall of 4 × 4 m, 1 m in front of the eye, its middle towards `direction`.
inline Wall wallTowards(const glm::dvec3& eye_m, const glm::dvec3& direction, const glm::ivec2& pixels) {
  const glm::dvec3 forward = glm::normalize(direction);
  const glm::dvec3 aside = std::abs(forward.z) < 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0);
  const glm::dvec3 right = glm::normalize(glm::cross(forward, aside));
  const glm::dvec3 up = glm::cross(right, forward);
  Wall wall;
  wall.lowerLeft_m = eye_m + forward - 2.0 * right - 2.0 * up;
  wall.lowerRight_m = wall.lowerLeft_m + 4.0 * right;
  wall.upperLeft_m = wall.lowerLeft_m + 4.0 * up;
  wall.pixels = pixels;
  return wall;
}

/// left, right, bottom, top in pixels; left > right if there is nothing.
using Box = std::array<double, 4>;

/// A pixel is lit if its middle is covered: half a pixel on either side, and rounding.
inline constexpr double kLitBox_px = 1.01;

inline void include(Box& box, double x, double y) {
  box = {std::min(box[0], x), std::max(box[1], x), std::min(box[2], y), std::max(box[3], y)};
}

inline Box litBox(const Image& image) {
  Box box{1e9, -1e9, 1e9, -1e9};
  for (int y = 0; y < image.size_px.y; ++y) {
    for (int x = 0; x < image.size_px.x; ++x) {
      const std::size_t at =
          3 * (static_cast<std::size_t>(y) * image.size_px.x + static_cast<std::size_t>(x));
      if (image.rgb[at] > 0) include(box, x + 0.5, y + 0.5);
    }
  }
  return box;
}

}  // namespace carom::test
