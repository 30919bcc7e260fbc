// A way of thrusts, gone in pieces, against the sum of what it was planned to give.
#include "app/viewer/thrust_way.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "engine/random_world.h"

namespace carom {
namespace {

std::vector<Thrust> randomThrusts(test::Random& random) {
  std::vector<Thrust> thrusts(static_cast<std::size_t>(random.in(1.0, 6.0)));
  for (Thrust& thrust : thrusts) thrust = {random.in(0.05, 2.0), random.inBall(0.9)};
  return thrusts;
}

Vec3 sumOf(const std::vector<Thrust>& thrusts) {
  Vec3 sum_m_s(0.0);
  for (const Thrust& thrust : thrusts) sum_m_s += thrust.for_s * thrust.thrust_m_s2;
  return sum_m_s;
}

ThrustWay along(const std::vector<Thrust>& thrusts) {
  ThrustWay way(1);
  way.take(thrusts);
  return way;
}

// What the way adds to the rapidity does not depend on the frames in which it is gone, nor on how weak the
// platform is: it then takes longer.
TEST(ThrustWay, GivesWhatWasPlannedHoweverItIsGone) {
  constexpr double kRounding_m_s = 1e-12;
  test::Random random(31);
  for (int i = 0; i < 200; ++i) {
    CASE(random, i);
    const std::vector<Thrust> thrusts = randomThrusts(random);
    ThrustWay whole = along(thrusts), inPieces = along(thrusts);
    const double strongest_m_s2 = i % 2 == 0 ? 1.0 : random.in(0.1, 0.9);
    const Vec3 gain_m_s = whole.gain_m_s(1e3, strongest_m_s2);
    ASSERT_LT(glm::distance(gain_m_s, sumOf(thrusts)), kRounding_m_s);
    Vec3 gained_m_s(0.0);
    double passed_s = 0.0;
    while (!inPieces.isOver() && passed_s < 1e3) {
      const double frame_s = random.in(0.001, 0.5);
      const Vec3 more_m_s = inPieces.gain_m_s(frame_s, strongest_m_s2);
      ASSERT_LE(glm::length(more_m_s), frame_s * strongest_m_s2 * (1.0 + 1e-9)) << "stronger than it may be";
      gained_m_s += more_m_s;
      inPieces.pass(frame_s, strongest_m_s2);
      passed_s += frame_s;
    }
    ASSERT_LT(glm::distance(gained_m_s, sumOf(thrusts)), kRounding_m_s);
  }
}

// Thrust by thrust, in frames that last longer under thrust.
TEST(ThrustWay, GoesOnThrustByThrust) {
  test::Random random(32);
  for (int i = 0; i < 200; ++i) {
    CASE(random, i);
    const std::vector<Thrust> thrusts = randomThrusts(random);
    ThrustWay way = along(thrusts);
    Vec3 gained_m_s(0.0);
    const auto left_s = [&](const Vec3& thrust_m_s2) { return 0.1 * (1.0 + glm::length(thrust_m_s2)); };
    while (const auto next = way.next(left_s)) {
      ASSERT_GT(next->for_s, 0.0);
      ASSERT_LE(next->for_s, left_s(next->thrust_m_s2));
      gained_m_s += next->for_s * next->thrust_m_s2;
    }
    ASSERT_TRUE(way.isOver());
    ASSERT_LT(glm::distance(gained_m_s, sumOf(thrusts)), 1e-12);
    way.take(thrusts);
    ASSERT_FALSE(way.isOver());
    way.leave();
    ASSERT_TRUE(way.isOver());
    ASSERT_EQ(way.gain_m_s(1.0, 1.0), Vec3(0.0));
  }
}

}  // namespace
}  // namespace carom
