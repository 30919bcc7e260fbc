#pragma once
// The two sides of each soft puck in a spacetime diagram: they need not move together. Board frame.

#include <array>
#include <cstddef>
#include <vector>

#include "engine/billiard/billiard.h"

namespace carom {

struct SoftSides {
  std::size_t puck = 0;
  /// Of the matter farthest along the diagram's axis, from the time on at which the puck is soft.
  std::array<std::vector<Event>, 2> lines;
};

/// Plays a game with its strokes again up to a board time and returns the sides along the axis x or y of all
/// pucks that have been soft by then.
std::vector<SoftSides> softSides(const BilliardSetup& setup, char along, double until_s);

}  // namespace carom
