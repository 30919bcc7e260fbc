#pragma once
// The ledger's promise, as an expectation of tests: nothing of energy or momentum is lost.

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "engine/billiard/billiard.h"

namespace carom::test {

inline constexpr double kBalance = 1e-10;  // of the total energy

/// What moves, plus what left, less what strokes gave, is what moved at the start; `tolerance` is a share of
/// the energy at the start.
inline void expectBalanced(const Billiard& billiard, const Ledger& start, double tolerance) {
  const Ledger now = billiard.ledger();
  const double energy = now.motion.energy_j + now.radiated.energy_j + now.takenByCushions.energy_j +
                        now.lostToFriction.energy_j - now.givenByStrokes.energy_j;
  const Vec2 momentum = now.motion.momentum_kg_m_s + now.radiated.momentum_kg_m_s +
                        now.takenByCushions.momentum_kg_m_s + now.lostToFriction.momentum_kg_m_s -
                        now.givenByStrokes.momentum_kg_m_s;
  EXPECT_TRUE(std::abs(energy / start.motion.energy_j - 1.0) <= tolerance)
      << energy << " " << start.motion.energy_j;
  EXPECT_TRUE(glm::length(momentum - start.motion.momentum_kg_m_s) <= tolerance * start.motion.energy_j);
}

}  // namespace carom::test
