#pragma once
// Soft discs in flight.

#include <cmath>
#include <memory>

#include <glm/geometric.hpp>

#include "engine/soft/soft_body.h"

namespace carom::test {

inline constexpr double kRadius = 0.0305, kMass = 0.2;
inline constexpr double kSmallRadius = 0.03;  // of discs that are put together from few cells

inline Vec21 movingWith(const glm::dvec2& beta) {
  const double gamma = 1.0 / std::sqrt(1.0 - glm::dot(beta, beta));
  return {gamma, gamma * beta.x, gamma * beta.y};
}

/// A vector in a frame that moves with the four-velocity `u`.
inline Vec21 seenFrom(const Vec21& u, const Vec21& p) {
  const double along = p.x * u.x + p.y * u.y, share = along / (u.t + 1.0) - p.t;
  return {u.t * p.t - along, p.x + share * u.x, p.y + share * u.y};
}

inline SoftBody disc(int cells, const SoftMaterial& material, const glm::dvec2& centre,
                     const glm::dvec2& beta, InstructionSet instructions = bestInstructionSet()) {
  return SoftBody(std::make_shared<SoftMesh>(softDisc(kRadius, cells)), material, kMass, centre,
                  movingWith(beta), instructions);
}

}  // namespace carom::test
