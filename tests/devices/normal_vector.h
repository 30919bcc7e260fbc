#pragma once
// Random vectors, for errors of measured places and for directions.

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

}  // namespace carom::test
