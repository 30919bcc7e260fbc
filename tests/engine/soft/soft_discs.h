#pragma once
// A soft disc in flight.

#include <cmath>
#include <memory>

#include <glm/geometric.hpp>

#include "engine/soft/soft_body.h"

namespace carom::test {

inline constexpr double kRadius = 0.0305, kMass = 0.2;

inline Vec21 movingWith(const glm::dvec2& beta) {
  const double gamma = 1.0 / std::sqrt(1.0 - glm::dot(beta, beta));
  return {gamma, gamma * beta.x, gamma * beta.y};
}

inline SoftBody disc(int cells, const SoftMaterial& material, const glm::dvec2& centre,
                     const glm::dvec2& beta, InstructionSet instructions = bestInstructionSet()) {
  return SoftBody(std::make_shared<SoftMesh>(softDisc(kRadius, cells)), material, kMass, centre,
                  movingWith(beta), instructions);
}

}  // namespace carom::test
