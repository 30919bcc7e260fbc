#pragma once
// Random vectors, for errors of measured places and for directions, and turns by vectors.

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>
#include <random>

namespace carom::test {

using Random = std::mt19937_64;

/// Returns a vector whose coordinates are normally distributed.
inline glm::dvec3 normal3(Random& random, double sigma) {
  std::normal_distribution<double> one(0.0, sigma);
  const double x = one(random), y = one(random), z = one(random);
  return {x, y, z};
}

/// Returns the turn about this axis by its length.
inline glm::dquat turned(const glm::dvec3& turn_rad) {
  const double angle = glm::length(turn_rad);
  return angle == 0.0 ? glm::dquat(1, 0, 0, 0) : glm::angleAxis(angle, turn_rad / angle);
}

}  // namespace carom::test
