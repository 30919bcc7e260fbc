#pragma once
// The axes of a moving body's rest frame: the board's, boosted without turning. c = 1.

#include <glm/vec2.hpp>

#include "engine/base/portable_math.h"
#include "engine/spacetime/minkowski.h"

namespace carom {

/// The unit vectors along x and y of the frame that moves with u.
struct RestAxes {
  Vec21 x, y;

  explicit RestAxes(const Vec21& u)
      : x{u.x, 1.0 + u.x * u.x / (u.t + 1.0), u.x * u.y / (u.t + 1.0)},
        y{u.y, u.x * u.y / (u.t + 1.0), 1.0 + u.y * u.y / (u.t + 1.0)} {}
  /// Returns the four-vector that is this offset in that frame.
  Vec21 operator()(const glm::dvec2& offset) const { return x * offset.x + y * offset.y; }
  /// Returns the place in that frame of an event relative to its origin.
  glm::dvec2 place(const Vec21& event) const { return {-dot(event, x), -dot(event, y)}; }
};

/// Returns an offset turned anticlockwise.
inline glm::dvec2 turned(const glm::dvec2& offset, const SinCos& by) {
  return {by.cos * offset.x - by.sin * offset.y, by.sin * offset.x + by.cos * offset.y};
}
/// Returns an offset turned back by as much.
inline glm::dvec2 turnedBack(const glm::dvec2& offset, const SinCos& by) {
  return {by.cos * offset.x + by.sin * offset.y, by.cos * offset.y - by.sin * offset.x};
}

}  // namespace carom
