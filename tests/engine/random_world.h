#pragma once
// Seeded random world lines, offsets and eyes for tests. print.h prints them, CASE says how to make them
// again.

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <ostream>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "engine/spacetime/world_line.h"
#include "print.h"

namespace carom::test {

class Random {
 public:
  explicit Random(std::uint64_t seed) : seed_(seed), engine_(seed) {}

  /// Begins a case: what is drawn from here on depends on the seed and the case alone. False where the
  /// environment variable CAROM_CASE names another case.
  bool begin(std::uint64_t number) {
    static const char* const wanted = std::getenv("CAROM_CASE");
    if (wanted && std::to_string(number) != wanted) return false;
    case_ = number;
    engine_.seed(seed_ ^
                 (number + 1) * 0x9e3779b97f4a7c15u);  // 2⁶⁴ over the golden ratio: cases lie far apart
    return true;
  }
  /// Returns the seed, the case and the command that runs the case alone.
  std::string words() const {
    const std::string seed = "seed " + std::to_string(seed_);
    if (!case_) return seed;
    static const std::string program = std::filesystem::read_symlink("/proc/self/exe");
    const testing::TestInfo* test = testing::UnitTest::GetInstance()->current_test_info();
    const std::string number = std::to_string(*case_);
    return seed + ", case " + number + "; again: CAROM_CASE=" + number + ' ' + program +
           " --gtest_filter=" + (test ? std::string(test->test_suite_name()) + '.' + test->name() : "*");
  }
  friend void PrintTo(const Random& random, std::ostream* out) { *out << random.words(); }

  /// Uniform in [low, high), the same on every platform.
  double in(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1.0p-53;
  }
  Vec3 inBox(double half) { return {in(-half, half), in(-half, half), in(-half, half)}; }
  Vec3 direction() {
    for (;;) {
      const Vec3 v = inBox(1.0);
      const double length = glm::length(v);
      if (length > 0.1 && length < 1.0) return v / length;
    }
  }
  Vec3 inBall(double radius) { return direction() * (radius * std::cbrt(in(0.0, 1.0))); }
  Vec3 u(double maxBeta) { return uFromBeta(direction() * in(0.0, maxBeta)); }

 private:
  std::uint64_t seed_;
  std::optional<std::uint64_t> case_;
  std::mt19937_64 engine_;
};

/// The first statement of a loop over cases: draws case `i` of `random`, and a failure in it says which it
/// was and the command that runs it alone. What the test expects of all cases together does not hold then.
#define CASE(random, i)                                         \
  if (!(random).begin(static_cast<std::uint64_t>(i))) continue; \
  SCOPED_TRACE((random).words())

/// A body that bounces `bounces` times, `spacing_s` board seconds apart on average. As for a puck, the signal
/// of each bounce comes from a point of the body and reaches the centre at the turn.
inline WorldLine randomWorldLine(Random& random, double c_m_s, double radius_m, int bounces, double spacing_s,
                                 double maxBeta, double friction_m_s2 = 0.0) {
  Knot knot{{random.in(-1.0, 0.0), random.inBox(1.0)}, random.u(maxBeta), 0.0, {}, 0.0};
  knot.signal = knot.turn;
  WorldLine line(knot, c_m_s, radius_m);
  for (int i = 0; i < bounces; ++i) {
    const Knot& last = line.knots().back();
    const double t_s = last.turn.t_s + random.in(0.02, 2.0) * spacing_s;
    const Motion motion = motionOnLeg(last, t_s, c_m_s);
    const double depth_m = random.in(0.0, radius_m);
    const Displacement signalInBody{-depth_m / c_m_s, random.direction() * depth_m};
    Knot next{motion.event, random.u(maxBeta), motion.properTime_s, {}, friction_m_s2};
    next.signal = motion.event + Lorentz::boost(motion.u, c_m_s) * signalInBody;
    line.append(next);
  }
  return line;
}

/// The same motion of a body that spins: its rim moves at up to `maxRim` c on each leg, and its angle goes
/// on at each turn, as it does for a puck. The cloth takes its spin. No rim is slower than `minRim`.
inline WorldLine spun(Random& random, const WorldLine& line, double maxRim, double slowing_1_s = 0.0,
                      double minRim = 0.0) {
  std::vector<Knot> knots(line.knots().begin(), line.knots().end());
  for (std::size_t i = 0; i < knots.size(); ++i) {
    const double drawn = random.in(-maxRim, maxRim);
    knots[i].spin.omega_rad_s =
        std::copysign(std::max(std::abs(drawn), minRim), drawn) * line.lightSpeed_m_s() / line.radius_m();
    knots[i].spin.angle_rad = random.in(-3.0, 3.0);
    const double rim = knots[i].spin.omega_rad_s * line.radius_m() / line.lightSpeed_m_s();
    knots[i].spin.rim_u = rim / std::sqrt(1.0 - rim * rim);
    knots[i].spin.slowing_1_s = slowing_1_s;
    if (i == 0) continue;
    const double since_s = knots[i].properTime_s - knots[i - 1].properTime_s;
    knots[i].spin.angle_rad = angleAfter(knots[i - 1].spin, since_s);
  }
  WorldLine spinning(knots[0], line.lightSpeed_m_s(), line.radius_m(), line.appears_s());
  for (std::size_t i = 1; i < knots.size(); ++i) spinning.append(knots[i]);
  return spinning;
}

}  // namespace carom::test
