#pragma once
// A gas of equal pucks on a square board, for tests and benchmarks of the billiard.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include "engine/billiard/billiard.h"

namespace carom::test {

/// `count` pucks of mass 1 kg on a grid, each with the same energy `energy` (in units of m c²) in a random
/// direction, on a board of which the uncontracted discs cover `coverage`. c = 1 m/s, radius 0.01 m.
inline BilliardSetup gasSetup(int count, double coverage, double energy, std::uint64_t seed) {
  const double radius_m = 0.01;
  const double side_m = std::sqrt(count * std::numbers::pi * radius_m * radius_m / coverage);
  BilliardSetup setup;
  setup.lightSpeed_m_s = 1.0;
  setup.board = Board{side_m, side_m};
  setup.rules.collisionEvent = CollisionEvent::contact;
  std::mt19937_64 random(seed);
  const double beta = std::sqrt(1.0 - 1.0 / (energy * energy));
  const int columns = static_cast<int>(std::ceil(std::sqrt(count)));
  for (int i = 0; i < count; ++i) {
    const double angle = 2.0 * std::numbers::pi * static_cast<double>(random() >> 11) * 0x1.0p-53;
    const Vec2 cell{(i % columns + 0.5) / columns - 0.5, (i / columns + 0.5) / columns - 0.5};
    setup.pucks.push_back({std::to_string(i),
                           radius_m,
                           0.02,
                           1.0,
                           cell * side_m,
                           {beta * std::cos(angle), beta * std::sin(angle)}});
  }
  return setup;
}

}  // namespace carom::test
