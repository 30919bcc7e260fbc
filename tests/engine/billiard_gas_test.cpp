// The billiard as a whole: a gas of pucks keeps its energy and momentum, stays on its table, and thermalises
// to the two-dimensional Jüttner law.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/billiard.h"
#include "engine/gas.h"

namespace carom {
namespace {

double gammaOf(const WorldLine& line, double t_s) { return gammaFromU(line.at(t_s).u); }

// P(p) ∝ exp(−E/T) d²p gives P(E) dE ∝ E exp(−E/T) dE for E >= 1 (m = c = 1), so
// P(> E) = (E + T)/(1 + T) exp(−(E−1)/T).
double juettnerBelow(double energy, double T) {
  return 1.0 - (energy + T) / (1.0 + T) * std::exp(-(energy - 1.0) / T);
}

// ⟨E⟩ = (1 + 2T + 2T²)/(1 + T), solved for T.
double juettnerTemperature(double meanEnergy) {
  const double b = 2.0 - meanEnergy, c = 1.0 - meanEnergy;
  return (-b + std::sqrt(b * b - 8.0 * c)) / 4.0;
}

double kolmogorovSmirnov(std::vector<double> energies, double T) {
  std::sort(energies.begin(), energies.end());
  double largest = 0.0;
  const double n = static_cast<double>(energies.size());
  for (std::size_t i = 0; i < energies.size(); ++i) {
    const double below = juettnerBelow(energies[i], T);
    largest = std::max({largest, std::abs(below - static_cast<double>(i) / n),
                        std::abs(static_cast<double>(i + 1) / n - below)});
  }
  return largest;
}

// Every turn of every leg lies on the table, so every centre does at every time.
void expectInsideTable(const Billiard& billiard, const Board& board) {
  double least_m = std::numeric_limits<double>::infinity();
  for (const WorldLine& line : billiard.worldLines()) {
    for (const Knot& knot : line.knots()) {
      least_m = std::min({least_m, 0.5 * board.length_m - std::abs(knot.turn.r_m.x),
                          0.5 * board.width_m - std::abs(knot.turn.r_m.y)});
    }
  }
  EXPECT_GT(least_m, 0.0);
}

void expectBalanced(const Billiard& billiard, const Ledger& start, double tolerance) {
  const Ledger now = billiard.ledger();
  const double energy = now.motion.energy_j + now.radiated.energy_j + now.takenByCushions.energy_j +
                        now.lostToFriction.energy_j - now.givenByStrokes.energy_j;
  const Vec2 momentum = now.motion.momentum_kg_m_s + now.radiated.momentum_kg_m_s +
                        now.takenByCushions.momentum_kg_m_s + now.lostToFriction.momentum_kg_m_s -
                        now.givenByStrokes.momentum_kg_m_s;
  EXPECT_TRUE(std::abs(energy / start.motion.energy_j - 1.0) <= tolerance) << energy;
  EXPECT_TRUE(glm::length(momentum - start.motion.momentum_kg_m_s) <= tolerance * start.motion.energy_j);
}

TEST(BilliardGas, thermalisesToJuettner) {
  // 200 pucks, R/L = 0.002: coverage 200 π 0.002².
  BilliardSetup setup = test::gasSetup(200, 200 * std::numbers::pi * 4e-6, 2.5, 7);
  Billiard billiard(setup);
  const Ledger start = billiard.ledger();
  std::vector<double> energies;
  double t_s = 0.0;
  while (billiard.collisions().size() < 6000) billiard.advanceTo(t_s += 1.0);
  // Samples 10 s apart, in which a puck collides about twice.
  for (int sample = 0; sample < 400; ++sample) {
    billiard.advanceTo(t_s += 10.0);
    for (const WorldLine& line : billiard.worldLines()) energies.push_back(gammaOf(line, t_s));
    if (sample % 50 == 0)
      printf("%zu %g\n", billiard.collisions().size(), kolmogorovSmirnov(energies, juettnerTemperature(2.5)));
  }
  expectBalanced(billiard, start, 1e-10);
  expectInsideTable(billiard, *setup.board);
  EXPECT_LT(kolmogorovSmirnov(energies, juettnerTemperature(2.5)), 0.016);
  EXPECT_TRUE(billiard.jams().empty());
}

TEST(BilliardGas, conservesOverAMillionCollisions) {
  BilliardSetup setup = test::gasSetup(300, 0.1, 2.5, 3);
  Billiard billiard(setup);
  const Ledger start = billiard.ledger();
  double t_s = 0.0;
  while (billiard.collisions().size() < 200000) billiard.advanceTo(t_s += 0.1);
  expectBalanced(billiard, start, 1e-10);
  expectInsideTable(billiard, *setup.board);
}

TEST(BilliardGas, denseGasInTheCentreConvention) {
  for (const double e : {1.0, 0.9}) {
    for (const int count : {30, 300}) {
      BilliardSetup setup = test::gasSetup(count, 0.2, 1.6, 5);
      setup.rules.collisionEvent = CollisionEvent::centre;
      setup.rules.puckRestitution = setup.rules.cushionRestitution = e;
      Billiard billiard(setup);
      const Ledger start = billiard.ledger();
      double t_s = 0.0;
      while (billiard.collisions().size() < 20000 && t_s < 300.0) billiard.advanceTo(t_s += 0.1);
      printf("%d e=%g: t %g, collisions %zu jams %zu heat %g\n", count, e, t_s, billiard.collisions().size(),
             billiard.jams().size(), billiard.ledger().heat_j);
      expectBalanced(billiard, start, 1e-10);
      expectInsideTable(billiard, *setup.board);
    }
  }
}

}  // namespace
}  // namespace carom
