// The simulated device in a simulated hand: the device as a whole never gives out energy that it has not got,
// whatever the stiffness, delay and rate; a hand that stops comes to rest; forces keep their limits.

#include "devices/force/force_loop.h"
#include "devices/force/simulated_force.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <glm/geometric.hpp>

namespace carom {
namespace {

constexpr double kMass_kg = 0.2, kLight_m_s = 1.42;

struct Case {
  double rate_hz = 1000.0, damping_ns_m = 0.3, stiffness_n_m = 600.0, beta = 0.0;
  int delay = 1;
  bool holds = false;

  ForceLimits limits() const {
    ForceLimits limits;
    limits.period_s = limits.spring_s = 1.0 / rate_hz;
    limits.damping_ns_m = damping_ns_m;
    limits.stiffness_n_m = stiffness_n_m;
    limits.leastRate_hz = 0.45 * rate_hz;
    limits.delay_ticks = delay;
    return limits;
  }
  ForceLaw law() const {
    ForceLaw law;
    law.kind = holds ? ForceLaw::Kind::heldPuck : ForceLaw::Kind::cue;
    law.held = true;
    const double rest_j = kMass_kg * kLight_m_s * kLight_m_s;
    law.cue = {rest_j, 0.08, forceScale(rest_j, 0.08, limits())};
    law.puck = {kMass_kg,
                kLight_m_s,
                {beta * kLight_m_s, 0.0, 0.0},
                stiffness_n_m,
                couplingDamping_ns_m(limits(), stiffness_n_m)};
    return law;
  }
  friend void PrintTo(const Case& c, std::ostream* out) {
    *out << c.rate_hz << " Hz, K = " << c.stiffness_n_m << " N/m, " << (c.holds ? "held at " : "cue ")
         << c.beta << " c, delay " << c.delay << " ticks";
  }
};

std::vector<Case> allCases() {
  std::vector<Case> cases;
  for (const auto& [rate_hz, b_ns_m] : {std::pair{125.0, 1.0}, {500.0, 0.6}, {1000.0, 0.3}}) {
    const double limit_n_m = 2.0 * b_ns_m * rate_hz;
    for (const double k_n_m : {100.0, 0.5 * (100.0 + limit_n_m), limit_n_m}) {
      for (int delay = 1; delay <= 4; ++delay) {
        cases.push_back({rate_hz, b_ns_m, k_n_m, 0.0, delay, false});
        for (const double beta : {0.0, 0.5, 0.9, 0.99})
          cases.push_back({rate_hz, b_ns_m, k_n_m, beta, delay, true});
      }
    }
  }
  return cases;
}

/// A hand that wants to be somewhere else every 0.15 s, and moves there smoothly.
class Pushes {
 public:
  explicit Pushes(std::uint64_t seed) : random_(seed) {}

  glm::dvec3 at(double time_s, double step_s) {
    if (time_s >= next_s_) {
      next_s_ += 0.15;
      const auto in = [&](double half) {
        return half * (2.0 * static_cast<double>(random_() >> 11) * 0x1.0p-53 - 1.0);
      };
      goal_m_ = {in(0.12), in(0.08), in(0.12)};
    }
    place_m_ += step_s / 0.06 * (goal_m_ - place_m_);
    return place_m_;
  }

 private:
  std::mt19937_64 random_;
  double next_s_ = 0.0;
  glm::dvec3 goal_m_{0.0}, place_m_{0.0};
};

struct Outcome {
  double leastPort_j = 0.0, mostForce_n = 0.0, mostSlew = 0.0, firstSwing_m = 0.0, lastSwing_m = 0.0;
  std::uint64_t falls = 0;
};

/// Pushes at random for `pushed_s`, then keeps the wish where it is for `quiet_s`.
Outcome run(const Case& c, double pushed_s, double quiet_s, std::uint64_t seed) {
  const ForceLimits limits = c.limits();
  SimulatedForce device(limits, static_cast<std::size_t>(c.delay));
  ForceLoop loop(limits);
  ForceLaw law = c.law();
  Pushes pushes(seed);
  Outcome outcome;
  glm::dvec3 wish_m(0.0), before_n(0.0);
  const long ticks = std::lround((pushed_s + quiet_s) * c.rate_hz);
  double sure_j = 0.0;
  for (long i = 0; i < ticks; ++i) {
    const double now_s = static_cast<double>(i) / c.rate_hz;
    if (now_s < pushed_s) wish_m = pushes.at(now_s, limits.period_s);
    law.posted_s = now_s;
    device.wish(wish_m);
    const glm::dvec3 force_n = loop.tick(now_s, device.read(now_s), law).force_n;
    ForceCommand command;
    command.force_n = force_n;
    device.write(command);
    outcome.leastPort_j = std::min(outcome.leastPort_j, device.port_j());
    outcome.mostForce_n = std::max(outcome.mostForce_n, glm::length(force_n));
    outcome.mostSlew = std::max(
        outcome.mostSlew, glm::distance(force_n, before_n) / (limits.force_n * limits.period_s / kSlew_s));
    before_n = force_n;
    sure_j += device.port_j();
    const double speed_m_s = glm::length(device.velocity_m_s());
    if (now_s >= pushed_s && now_s < pushed_s + 1.0)
      outcome.firstSwing_m = std::max(outcome.firstSwing_m, speed_m_s);
    if (now_s >= pushed_s + quiet_s - 1.0) outcome.lastSwing_m = std::max(outcome.lastSwing_m, speed_m_s);
  }
  if (!std::isfinite(sure_j)) outcome.leastPort_j = -1.0;
  outcome.falls = loop.report().falls;
  return outcome;
}

TEST(Stability, SixtySecondsOfPushingTakeNoEnergyOutOfTheDevice) {
  for (const Case& c : allCases()) {
    SCOPED_TRACE(testing::PrintToString(c));
    const Outcome outcome = run(c, 60.0, 0.0, 4304);
    EXPECT_GE(outcome.leastPort_j, -1e-6);
    EXPECT_LE(outcome.mostForce_n, 9.0 * (1.0 + 1e-12));
    EXPECT_LE(outcome.mostSlew, 1.0 + 1e-9);
    EXPECT_EQ(outcome.falls, 0u);
  }
}

TEST(Stability, AHandThatStopsComesToRest) {
  for (const Case& c : allCases()) {
    SCOPED_TRACE(testing::PrintToString(c));
    const Outcome outcome = run(c, 3.0, 30.0, 4305);
    EXPECT_LE(outcome.lastSwing_m, outcome.firstSwing_m);
  }
}

// What the tests above look for is there without the limit on stiffness and the controller: a spring of 20
// kN/m at 125 Hz makes energy.
TEST(Stability, AnUncheckedSpringMakesEnergy) {
  ForceLimits limits = Case{125.0, 1.0, 250.0, 0.0, 2, false}.limits();
  SimulatedForce device(limits, 2);
  ForceCommand command;
  double least_j = 0.0;
  for (int i = 0; i < 1000; ++i) {
    const double now_s = i / 125.0;
    device.wish({i < 20 ? 0.01 : 0.0, 0.0, 0.0});
    command.force_n = -2e4 * device.read(now_s).position_m;
    device.write(command);
    least_j = std::min(least_j, device.port_j());
  }
  EXPECT_LT(least_j, -1.0);
}

// The shown mass: the least-squares ratio of the felt force and the hand's own acceleration, here with the
// true acceleration of the simulated hand as another method beside the loop's own figure.
TEST(Stability, AShakenPuckShowsItsMass) {
  for (const double beta : {0.0, 0.2, 0.5, 0.7, 0.8}) {
    for (const bool isAcross : {false, true}) {
      const Case c{1000.0, 0.3, 600.0, beta, 1, true};
      const double amplitude_m = 0.1 * (1.0 - beta) * kLight_m_s / (2.0 * std::numbers::pi);
      SimulatedForce device(c.limits());
      ForceLoop loop(c.limits());
      ForceLaw law = c.law();
      double forceTimesA = 0.0, aTimesA = 0.0;
      glm::dvec3 before_m_s(0.0);
      for (int i = 0; i < 8000; ++i) {
        const double now_s = i * 1e-3, swing_m = amplitude_m * std::min(1.0, 0.5 * now_s) *
                                                 std::sin(2.0 * std::numbers::pi * now_s);
        law.posted_s = now_s;
        device.wish(isAcross ? glm::dvec3(0.0, 0.0, swing_m) : glm::dvec3(swing_m, 0.0, 0.0));
        const ForceDeviceState state = device.read(now_s);
        const glm::dvec3 a_m_s2 = (device.velocity_m_s() - before_m_s) * 1e3;
        before_m_s = device.velocity_m_s();
        if (i >= 7000) {
          forceTimesA += glm::dot(state.held_n, a_m_s2);
          aTimesA += glm::dot(a_m_s2, a_m_s2);
        }
        device.write(loop.tick(now_s, state, law));
      }
      const double gamma = 1.0 / std::sqrt(1.0 - beta * beta);
      const double mass_kg = kMass_kg * (isAcross ? gamma : gamma * gamma * gamma);
      EXPECT_NEAR(loop.report().shown_kg / mass_kg, 1.0, 0.1) << beta << ' ' << isAcross;
      EXPECT_NEAR(-forceTimesA / aTimesA / mass_kg, 1.0, 0.1) << beta << ' ' << isAcross;
      EXPECT_FALSE(ShownMass::isHidden(mass_kg, c.stiffness_n_m));
    }
  }
  EXPECT_TRUE(ShownMass::isHidden(kMass_kg * 12.07, 600.0)) << "along at 0.9 c";
  EXPECT_FALSE(ShownMass::isHidden(kMass_kg * 2.29, 600.0)) << "and across";
}

TEST(Stability, FIntegratesToWInASlowDraw) {
  ForceLimits limits;
  ForceLoop loop(limits);
  ForceDeviceState device;
  ForceLaw law;
  law.kind = ForceLaw::Kind::cue;
  law.held = true;
  const double rest_j = kMass_kg * kLight_m_s * kLight_m_s;
  law.cue = {rest_j, 0.08, forceScale(rest_j, 0.08, limits)};
  double sum_j = 0.0;
  constexpr int kTicks = 20000;
  for (int i = 0; i <= kTicks; ++i) {
    const double now_s = i * 1e-3, x_m = -0.2 * i / kTicks;
    const double moved_m = x_m - device.position_m.x;
    device.position_m.x = x_m;
    device.time_s = law.posted_s = now_s;
    const glm::dvec3 before_n = device.held_n;
    device.held_n = loop.tick(now_s, device, law).force_n;
    sum_j -= 0.5 * (before_n.x + device.held_n.x) * moved_m;
  }
  EXPECT_NEAR(sum_j / law.cue.energy_j(0.2), 1.0, 1e-6);
}

}  // namespace
}  // namespace carom
