// Pucks that spin: the books of rough games, their symmetries, what the cloth takes, strokes beside the
// centre.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "engine/balance.h"
#include "engine/billiard/billiard.h"
#include "engine/collision/spinning_body.h"
#include "engine/game_checks.h"
#include "engine/gas.h"
#include "engine/light/mesh_emission.h"
#include "engine/random_game.h"
#include "engine/random_world.h"
#include "sanitized.h"

namespace carom {
namespace {

/// Gives pucks all kinds of spins, inertias, and rough rims.
void roughen(test::Random& random, BilliardSetup& setup) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const auto friction = [&] { return random.in(0.0, 1.0) < 0.3 ? kInfinity : random.in(0.0, 1.0); };
  setup.rules.puckFriction = friction();
  setup.rules.cushionFriction = friction();
  setup.rules.tangentialRestitution = random.in(0.0, 1.0) < 0.3 ? 1.0 : random.in(0.0, 1.0);
  for (Puck& puck : setup.pucks) {
    puck.inertia = random.in(0.1, 1.0);
    puck.spin_kg_m2_s = spinAt_kg_m2_s(puck, random.in(-0.95, 0.95) * setup.lightSpeed_m_s / puck.radius_m,
                                       setup.lightSpeed_m_s);
  }
  for (Stroke& stroke : setup.strokes)
    stroke.offset_m = random.in(-0.5, 0.5) * setup.pucks[stroke.puck].radius_m;
}

/// Whether the rims of all legs and their centres are slower than light.
void expectSlowerThanLight(const Billiard& billiard, const BilliardSetup& setup) {
  double fastest = 0.0;
  for (std::size_t i = 0; i < setup.pucks.size(); ++i) {
    for (const Knot& knot : billiard.worldLines()[i].knots()) {
      const double rim = std::abs(knot.spin.omega_rad_s) * setup.pucks[i].radius_m / setup.lightSpeed_m_s;
      ASSERT_TRUE(std::isfinite(gammaFromU(knot.u)) && std::isfinite(knot.spin.angle_rad));
      fastest = std::max({fastest, rim, glm::length(betaFromU(knot.u))});
    }
  }
  EXPECT_LT(fastest, 1.0);
}

// Pucks of several sizes and masses, in both conventions.
TEST(BilliardSpin, RoughGamesBalanceOverManyCollisions) {
  constexpr int kGames = 10;
  test::Random random(1801);
  for (int game = 0; game < kGames; ++game) {
    CASE(random, game);
    BilliardSetup setup = test::gasSetup(30, 0.1, random.in(1.2, 2.5), 100 + game);
    for (Puck& puck : setup.pucks) puck.radius_m *= random.in(0.5, 1.0), puck.mass_kg = random.in(0.2, 5.0);
    if (game % 2 == 0) setup.rules.collisionEvent = CollisionEvent::centre;
    roughen(random, setup);
    Billiard billiard(setup);
    const Ledger start = billiard.ledger();
    std::size_t collisions = 0;
    double t_s = 0.0;
    for (const std::size_t wanted = test::casesOf(10000U); collisions < wanted && t_s < 3000.0;) {
      const std::size_t before = billiard.events().size();
      billiard.advanceTo(t_s += 0.1);
      collisions += billiard.events().size() - before;
      expectSlowerThanLight(billiard, setup);
      ASSERT_TRUE(std::ranges::all_of(billiard.events(), [](const GameEvent& e) { return e.heat_j >= 0.0; }));
      billiard.forgetBefore(t_s - 0.5);
      if (testing::Test::HasFailure()) return;
    }
    EXPECT_GT(collisions, test::casesOf(1000U));
    test::expectBalanced(billiard, start, test::kBalance);
  }
}

// With next to no mass in their rims a kick turns pucks at all but the speed of light: rims stay below it in
// all digits, and nothing that is seen of them is no number.
TEST(BilliardSpin, RimsOfNextToNoMassStaySlowerThanLight) {
  test::Random random(1804);
  double fastest_u = 0.0;
  for (int game = 0; game < 20; ++game) {
    CASE(random, game);
    BilliardSetup setup = test::gasSetup(12, 0.1, 1.5, 200 + game);
    roughen(random, setup);
    setup.rules.spinDeceleration_m_s2 = game % 2 == 0 ? 0.0 : 0.3;
    for (Puck& puck : setup.pucks) {
      puck.inertia = std::pow(10.0, random.in(-6.0, -4.0));
      puck.spin_kg_m2_s = 0.0;
    }
    Billiard billiard(setup);
    const Ledger start = billiard.ledger();
    billiard.advanceTo(3.0);
    test::expectBalanced(billiard, start, test::kBalance);
    expectSlowerThanLight(billiard, setup);
    for (const WorldLine& line : billiard.worldLines()) {
      for (const Knot& knot : line.knots()) fastest_u = std::max(fastest_u, std::abs(knot.spin.rim_u));
      const Event eye{3.5, line.at(3.0).event.r_m + Vec3(0.3, -0.2, 0.4)};
      BodyView view;
      viewBody(line, eye, Lorentz(setup.lightSpeed_m_s), view);
      const std::array<float, 2> x{static_cast<float>(line.radius_m()), 0.0F}, zero{};
      std::array<float, 2> seenX{}, seenY{}, seenZ{}, doppler{}, time{};
      seePoints(view, {x, zero, zero}, {seenX, seenY, seenZ, doppler, time});
      for (const float value : {seenX[0], seenY[0], seenZ[0], doppler[0], doppler[1], time[0]})
        ASSERT_TRUE(std::isfinite(value));
    }
  }
  EXPECT_GT(fastest_u, 1e4);
}

// Any order in the file, mirror images, half turns, steps, strokes told late.
TEST(BilliardSpin, RoughGamesHaveTheSameBitsHoweverTheyAreTold) {
  constexpr std::uint64_t kGames = 40;
  constexpr std::size_t kMostEvents = 120;
  test::Tally tally;
  test::Random random(1802);
  for (std::uint64_t seed = 1; seed <= test::casesOf(kGames); ++seed) {
    CASE(random, seed);
    test::RandomGame game = test::randomGame(seed, {kMostEvents, 20});
    roughen(random, game.setup);
    if (seed % 3 == 0) game.setup.rules.spinDeceleration_m_s2 = random.in(0.0, 0.5);
    test::Findings found(tally);
    Billiard billiard(game.setup);
    test::checkLedger(billiard, game.setup, game.until_s, kMostEvents, found);
    expectSlowerThanLight(billiard, game.setup);
    if (billiard.events().size() <= 4 * kMostEvents) test::checkSameBits(game.setup, game.until_s, found);
    for (const test::Violation& violation : found.all)
      ADD_FAILURE() << violation.kind << ": " << violation.what << "\n\n" << test::scenarioText(game.setup);
    if (testing::Test::HasFailure()) return;
  }
}

/// Of the energies of bodies with the mass M: P(E) dE ∝ E exp(−E/T) dE for E ≥ M.
double juettnerBelow(double energy, double M, double T) {
  return 1.0 - (energy + T) / (M + T) * std::exp(-(energy - M) / T);
}

double distanceFromJuettner(std::vector<double> energies, double M, double T) {
  std::sort(energies.begin(), energies.end());
  const double n = static_cast<double>(energies.size());
  double largest = 0.0;
  for (std::size_t i = 0; i < energies.size(); ++i) {
    const double below = juettnerBelow(energies[i], M, T);
    largest = std::max({largest, std::abs(below - static_cast<double>(i) / n),
                        std::abs(static_cast<double>(i + 1) / n - below)});
  }
  return largest;
}

/// The temperature at which pucks of these masses have the energy on average: ⟨E⟩ = (M² + 2MT + 2T²)/(M + T).
double temperatureOf(const std::vector<double>& masses, double energy) {
  double low = 1e-6, high = energy;
  for (int step = 0; step < 100; ++step) {
    const double T = 0.5 * (low + high);
    double sum = 0.0;
    for (const double M : masses) sum += (M * M + 2.0 * M * T + 2.0 * T * T) / (M + T);
    (sum / static_cast<double>(masses.size()) < energy ? low : high) = T;
  }
  return low;
}

// Smooth rims keep their spins, which are inert: three classes of rest masses at one temperature.
TEST(BilliardSpin, AGasOfSmoothDiscsFollowsTheLawOfEachMass) {
  if (test::kSanitized) GTEST_SKIP() << "a question of statistics";
  constexpr double kLargestDistance = 0.016;
  BilliardSetup setup = test::gasSetup(200, 200 * std::numbers::pi * 4e-6, 2.5, 18);
  const double spins[3] = {0.0, 0.01, -0.025};
  std::vector<double> masses;
  double energy_j = 0.0;
  for (std::size_t i = 0; i < setup.pucks.size(); ++i) {
    Puck& puck = setup.pucks[i];
    puck.spin_kg_m2_s = spins[i % 3];
    masses.push_back(restMass_kg(puck, puck.spin_kg_m2_s, 1.0));
    energy_j += masses.back() / std::sqrt(1.0 - glm::dot(puck.beta, puck.beta));
  }
  ASSERT_GT(masses[2], 2.0 * masses[0]);
  Billiard billiard(setup);
  const Ledger start = billiard.ledger();
  EXPECT_NEAR(start.motion.energy_j, energy_j, 1e-12 * energy_j);
  double t_s = 0.0;
  while (billiard.events().size() < 12000) billiard.advanceTo(t_s += 1.0);
  std::vector<std::vector<double>> energies(3);
  for (int sample = 0; sample < 300; ++sample) {
    billiard.advanceTo(t_s += 10.0);
    for (std::size_t i = 0; i < setup.pucks.size(); ++i)
      energies[i % 3].push_back(masses[i] * gammaFromU(billiard.worldLines()[i].at(t_s).u));
  }
  test::expectBalanced(billiard, start, test::kBalance);
  const double T = temperatureOf(masses, energy_j / static_cast<double>(masses.size()));
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_LT(distanceFromJuettner(energies[k], masses[k], T), kLargestDistance) << "mass " << masses[k];
  for (std::size_t i = 0; i < setup.pucks.size(); ++i)
    EXPECT_EQ(billiard.worldLines()[i].knots().back().spin.omega_rad_s,
              billiard.worldLines()[i].knots().front().spin.omega_rad_s);
}

BilliardSetup onePuck(const Vec2& beta) {
  BilliardSetup setup;
  setup.lightSpeed_m_s = 1.42;
  setup.pucks = {{"a", 0.03, 0.02, 0.2, {0.0, 0.0}, beta}};
  return setup;
}

// dJ/dτ is constant until there is none, dφ/dτ = ω(J), here by Simpson's rule.
TEST(BilliardSpin, TheClothTakesSpinEvenly) {
  BilliardSetup setup = onePuck({0.6, 0.0});
  const double c = setup.lightSpeed_m_s, rim = 0.9, slowing = 2.0;
  setup.rules.spinDeceleration_m_s2 = slowing;
  Puck& puck = setup.pucks[0];
  puck.spin_kg_m2_s = spinAt_kg_m2_s(puck, -rim * c / puck.radius_m, c);
  Billiard billiard(setup);
  const Spin spin = billiard.worldLines()[0].knots()[0].spin;
  const double u0 = -rim / std::sqrt(1.0 - rim * rim), ends_s = -u0 * c / slowing;
  EXPECT_NEAR(spin.rim_u, u0, 1e-14);
  EXPECT_NEAR(spin.omega_rad_s, -rim * c / puck.radius_m, 1e-13);
  const auto omega = [&](double tau_s) {
    const double u = std::min(u0 + slowing / c * tau_s, 0.0);
    return u / std::sqrt(1.0 + u * u) * c / puck.radius_m;
  };
  for (const double tau_s : {0.1, 0.7, 0.999 * ends_s, ends_s, 2.0 * ends_s}) {
    EXPECT_NEAR(omegaAfter(spin, tau_s), omega(tau_s), 1e-12 * c / puck.radius_m);
    constexpr int kSteps = 20000;
    const double to_s = std::min(tau_s, ends_s), h = to_s / kSteps;
    double turned = omega(0.0) + omega(to_s);
    for (int i = 1; i < kSteps; ++i) turned += (i % 2 == 0 ? 2.0 : 4.0) * omega(i * h);
    EXPECT_NEAR(std::remainder(angleAfter(spin, tau_s) - turned * h / 3.0, 2.0 * std::numbers::pi), 0.0,
                1e-10);
  }
  EXPECT_EQ(omegaAfter(spin, -1.0), spin.omega_rad_s);
}

// The leg after a stroke begins with the angle and the spin that the leg before it ends with.
TEST(BilliardSpin, AnglesGoOnAtTurnsAndTheBooksKnowWhatTheClothTook) {
  for (const double friction : {0.0, 0.3}) {
    BilliardSetup setup = onePuck({0.5, 0.1});
    setup.board = Board{1.0, 1.0};
    setup.rules.spinDeceleration_m_s2 = 0.4;
    setup.rules.cushionFriction = 0.2;
    setup.rules.friction_m_s2 = friction;
    setup.pucks[0].spin_kg_m2_s = 0.02;
    setup.strokes = {{0, 0.35, std::nullopt, {0.1, -0.2}, 0.01}};
    Billiard billiard(setup);
    const Ledger start = billiard.ledger();
    billiard.advanceTo(5.0);
    test::expectBalanced(billiard, start, 1e-12);
    const auto knots = billiard.worldLines()[0].knots();
    ASSERT_GT(knots.size(), 3u);
    for (std::size_t k = 1; k < knots.size(); ++k) {
      const double own_s = knots[k].properTime_s - knots[k - 1].properTime_s;
      EXPECT_NEAR(std::remainder(angleAfter(knots[k - 1].spin, own_s) - knots[k].spin.angle_rad,
                                 2.0 * std::numbers::pi),
                  0.0, 1e-9);
    }
    for (const GameEvent& event : billiard.events()) {
      const Turn& turn = event.turns[0];
      const std::size_t k = &event - billiard.events().data() + 1;
      const double own_s = turn.properTime_s - knots[k - 1].properTime_s;
      EXPECT_NEAR(turn.spinBefore_kg_m2_s,
                  spinOfRim_kg_m2_s(setup.pucks[0], rimUAfter(knots[k - 1].spin, own_s), 1.42), 1e-15);
      EXPECT_NEAR(turn.spinAfter_kg_m2_s, spinOfRim_kg_m2_s(setup.pucks[0], knots[k].spin.rim_u, 1.42),
                  1e-15);
    }
  }
}

double determinant(const double (&m)[3][3]) {
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
         m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

// J' = J + det(u, d, (ΔE, Δp)), with the offset d as the puck's rest frame has it.
TEST(BilliardSpin, AStrokeBesideTheCentreTurnsThePuck) {
  test::Random random(1803);
  for (int i = 0; i < 200; ++i) {
    CASE(random, i);
    const bool rests = i % 4 == 0;
    const double speed = rests ? 0.0 : random.in(0.0, 0.85), way = random.in(0.0, 6.28);
    BilliardSetup setup = onePuck({speed * std::cos(way), speed * std::sin(way)});
    const double c = setup.lightSpeed_m_s;
    Puck& puck = setup.pucks[0];
    puck.spin_kg_m2_s = i % 3 == 0 ? 0.0 : random.in(-0.02, 0.02);
    puck.inertia = random.in(0.2, 1.0);
    const Vec2 p{random.in(-0.5, 0.5), random.in(-0.5, 0.5)};
    const double b = random.in(-0.5, 0.5) * puck.radius_m;
    setup.strokes = {{0, 0.5, std::nullopt, p, b}};
    Billiard billiard(setup);
    const Ledger start = billiard.ledger();
    billiard.advanceTo(1.0);
    test::expectBalanced(billiard, start, 1e-13);
    const Turn turn = billiard.events()[0].turns[0];
    const double J = turn.spinBefore_kg_m2_s, after = turn.spinAfter_kg_m2_s;
    EXPECT_NEAR(J, puck.spin_kg_m2_s, 1e-17);
    if (rests) {
      EXPECT_NEAR(after, J + b * glm::length(p), 1e-16);
    }
    const double M = restMass_kg(puck, J, c), MAfter = restMass_kg(puck, after, c);
    const Knot &knot = billiard.worldLines()[0].knots()[0], &then = billiard.worldLines()[0].knots()[1];
    EXPECT_NEAR(then.u.x * MAfter * c, knot.u.x * M * c + p.x, 1e-15);
    EXPECT_NEAR(then.u.y * MAfter * c, knot.u.y * M * c + p.y, 1e-15);
    const Vec2 right = Vec2(p.y, -p.x) / glm::length(p);
    const Displacement d = Lorentz::boost(knot.u, c) * Displacement{0.0, {b * right, 0.0}};
    const double dE = (gammaFromU(then.u) * MAfter - gammaFromU(knot.u) * M) * c;  // over c
    EXPECT_NEAR(
        after,
        J + determinant(
                {{gammaFromU(knot.u), knot.u.x, knot.u.y}, {c * d.dt_s, d.dr_m.x, d.dr_m.y}, {dE, p.x, p.y}}),
        1e-15);
  }
}

TEST(BilliardSpin, RefusesSpinsThatCannotBe) {
  const auto refuses = [](const auto& spoil) {
    BilliardSetup setup = onePuck({0.0, 0.0});
    EXPECT_NO_THROW(Billiard{setup});
    spoil(setup);
    EXPECT_THROW(Billiard{setup}, std::invalid_argument);
  };
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  refuses([](BilliardSetup& s) { s.pucks[0].inertia = 0.0; });
  refuses([](BilliardSetup& s) { s.pucks[0].inertia = 1e-12; });
  refuses([](BilliardSetup& s) { s.pucks[0].inertia = 1.01; });
  refuses([&](BilliardSetup& s) { s.pucks[0].spin_kg_m2_s = nan; });
  refuses([&](BilliardSetup& s) { s.pucks[0].spin_kg_m2_s = inf; });
  refuses([](BilliardSetup& s) { s.pucks[0].spin_kg_m2_s = 1e10; });
  refuses([](BilliardSetup& s) { s.rules.puckFriction = -0.1; });
  refuses([&](BilliardSetup& s) { s.rules.cushionFriction = nan; });
  refuses([](BilliardSetup& s) { s.rules.tangentialRestitution = 1.1; });
  refuses([&](BilliardSetup& s) { s.rules.spinDeceleration_m_s2 = inf; });
  refuses([](BilliardSetup& s) { s.strokes = {{0, 0.0, std::nullopt, {0.1, 0.0}, 0.031}}; });
}

}  // namespace
}  // namespace carom
