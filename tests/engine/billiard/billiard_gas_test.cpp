// The billiard as a whole: a gas of pucks keeps its energy and momentum, stays on its table, and thermalises
// to the two-dimensional Jüttner law.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/balance.h"
#include "engine/billiard/billiard.h"
#include "engine/gas.h"
#include "exact_cases.h"
#include "sanitized.h"

namespace carom {
namespace {

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

TEST(BilliardGas, thermalisesToJuettner) {
  // 200 pucks, R/L = 0.002, ⟨E⟩ = 2.5 m: T = m. 240 samples of all pucks, in between which a puck collides
  // several times; their distance from the law is then that of 48 000 independent ones, 0.006 at 5 %.
  const double kLargestDistance =
      0.016;  // uncontracted discs, which collide 15 % too often, do not come near
  BilliardSetup setup = test::gasSetup(200, 200 * std::numbers::pi * 4e-6, 2.5, 7);
  Billiard billiard(setup);
  const Ledger start = billiard.ledger();
  std::vector<double> energies;
  double t_s = 0.0;
  while (billiard.events().size() < 6000) billiard.advanceTo(t_s += 1.0);
  for (int sample = 0; sample < 240; ++sample) {
    billiard.advanceTo(t_s += 10.0);
    for (const WorldLine& line : billiard.worldLines()) energies.push_back(gammaFromU(line.at(t_s).u));
  }
  test::expectBalanced(billiard, start, test::kBalance);
  expectInsideTable(billiard, *setup.board);
  EXPECT_LT(kolmogorovSmirnov(energies, juettnerTemperature(2.5)), kLargestDistance);
  // Equipartition: p·v = p²/E is on average 2T in the plane; 3 % is four standard deviations.
  double virial = 0.0;
  for (const double energy : energies) virial += (energy * energy - 1.0) / energy;
  virial /= static_cast<double>(energies.size());
  EXPECT_NEAR(virial / (2.0 * juettnerTemperature(2.5)), 1.0, 0.03);
  EXPECT_TRUE(billiard.jams().empty());
}

// The law itself against tabulated values.
TEST(BilliardGas, juettnerLawOfTheTest) {
  for (const nlohmann::json& one : test::exactCases("gas.json")) {
    const double T = one["input"]["T_over_m"];
    EXPECT_NEAR(juettnerTemperature(one["expected"]["mean_E"]), T, 1e-12);
    for (const auto& point : one["expected"]["cdf_at_E"]) {
      EXPECT_NEAR(juettnerBelow(point[0], T), point[1].get<double>(), 1e-12);
    }
  }
}

TEST(BilliardGas, conservesOverAMillionCollisions) {
  BilliardSetup setup = test::gasSetup(200, 0.1, 2.5, 3);
  Billiard billiard(setup);
  const Ledger start = billiard.ledger();
  std::size_t collisions = 0;
  for (double t_s = 1.0; collisions < test::casesOf(1000000U); t_s += 1.0) {
    const std::size_t before = billiard.events().size();
    billiard.advanceTo(t_s);
    collisions += billiard.events().size() - before;
    billiard.forgetBefore(t_s - 1.0);
  }
  test::expectBalanced(billiard, start, test::kBalance);
  expectInsideTable(billiard, *setup.board);
}

// The paper's convention, elastic and not, among many and among few: balanced, on the table, without jams.
TEST(BilliardGas, signalAtTheCentre) {
  for (const double restitution : {1.0, 0.9}) {
    for (const int count : {30, 200}) {
      SCOPED_TRACE(testing::Message() << count << " pucks, restitution " << restitution);
      BilliardSetup setup = test::gasSetup(count, 0.15, 1.6, 5);
      setup.rules.collisionEvent = CollisionEvent::centre;
      setup.rules.puckRestitution = setup.rules.cushionRestitution = restitution;
      Billiard billiard(setup);
      const Ledger start = billiard.ledger();
      for (double t_s = 0.1; billiard.events().size() < 2000 && t_s < 300.0; t_s += 0.1)
        billiard.advanceTo(t_s);
      EXPECT_GT(billiard.events().size(), 1000u);
      EXPECT_EQ(billiard.ledger().heat_j > 0.0, restitution < 1.0);
      test::expectBalanced(billiard, start, test::kBalance);
      expectInsideTable(billiard, *setup.board);
    }
  }
}

}  // namespace
}  // namespace carom
