#include "engine/spacetime/world_line.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstring>
#include <memory_resource>
#include <vector>

#include "engine/light/vertex_history.h"
#include "engine/light_speed.h"
#include "engine/random_world.h"

namespace carom {
namespace {

using test::kC_m_s;

TEST(WorldLine, LegsHoldFromTheirTurns) {
  const Knot first{{0.0, Vec3(0.0)}, uFromBeta({0.5, 0.0, 0.0}), 0.0, {}, 0.0};
  WorldLine line(first, kC_m_s);
  const Motion turn = line.at(2.0);
  EXPECT_NEAR(turn.event.r_m.x, 0.5 * kC_m_s * 2.0, 1e-15);
  EXPECT_NEAR(turn.properTime_s, 2.0 * std::sqrt(0.75), 1e-15);
  line.append({turn.event, uFromBeta({0.0, 0.8, 0.0}), turn.properTime_s, turn.event, 0.0});
  EXPECT_EQ(line.at(-5.0).leg, 0U);
  EXPECT_EQ(line.at(3.0).leg, 1U);
  EXPECT_NEAR(line.at(3.0).event.r_m.y, 0.8 * kC_m_s, 1e-15);
  EXPECT_NEAR(line.at(-1.0).event.r_m.x, -0.5 * kC_m_s, 1e-15);
}

TEST(WorldLine, RefusesJumpsAndTimeGoingBack) {
  WorldLine line({{0.0, Vec3(0.0)}, Vec3(0.0), 0.0, {}, 0.0}, kC_m_s);
  EXPECT_THROW(line.append({{1.0, {0.1, 0.0, 0.0}}, Vec3(0.0), 1.0, {}, 0.0}), std::invalid_argument);
  EXPECT_THROW(line.append({{-1.0, Vec3(0.0)}, Vec3(0.0), 0.0, {}, 0.0}), std::invalid_argument);
  EXPECT_THROW(line.append({{NAN, Vec3(0.0)}, Vec3(0.0), 0.0, {}, 0.0}), std::invalid_argument);
  EXPECT_EQ(line.knots().size(), 1U);
}

/// Counts what lies in it.
class CountedMemory : public std::pmr::memory_resource {
 public:
  std::size_t bytes = 0, allocations = 0;

 private:
  void* do_allocate(std::size_t size, std::size_t alignment) override {
    bytes += size, ++allocations;
    return std::pmr::new_delete_resource()->allocate(size, alignment);
  }
  void do_deallocate(void* memory, std::size_t size, std::size_t alignment) override {
    bytes -= size;
    std::pmr::new_delete_resource()->deallocate(memory, size, alignment);
  }
  bool do_is_equal(const std::pmr::memory_resource& other) const noexcept override { return this == &other; }
};

// A copy is on its own, and what is copied or moved into a line lies in the memory of that line.
TEST(WorldLine, KnotsLieInTheMemoryThatWasGiven) {
  test::Random random(8);
  const WorldLine whole = randomWorldLine(random, kC_m_s, 0.1, 10, 1.0, 0.9);
  CountedMemory memory, other;
  {
    WorldLine line(whole.knots()[0], kC_m_s, 0.1, -1.0, &memory);
    for (std::size_t i = 1; i < 10; ++i) line.append(whole.knots()[i]);
    const std::size_t bytes = memory.bytes;
    EXPECT_GT(bytes, 9 * sizeof(Knot) / 2);
    WorldLine copy = line;
    EXPECT_EQ(memory.bytes, bytes);
    copy.append(whole.knots()[10]);
    EXPECT_EQ(copy.knots()[9].turn.t_s, line.knots()[9].turn.t_s);
    EXPECT_EQ(copy.settled_s(10), whole.settled_s(10));
    WorldLine elsewhere(whole.knots()[0], kC_m_s, 0.1, -1.0, &other);
    elsewhere = WorldLine(line);
    EXPECT_GT(other.bytes, 9 * sizeof(Knot) / 2);
    EXPECT_EQ(elsewhere.knots().size(), 10U);
    WorldLine moved = std::move(line);
    EXPECT_EQ(memory.bytes, bytes);
    EXPECT_EQ(moved.knots()[9].u, whole.knots()[9].u);
  }
  EXPECT_EQ(memory.bytes, 0U);
  EXPECT_EQ(other.bytes, 0U);
}

// A knot takes 100 bytes while heights, friction and spin are the same throughout, and its value is what was
// given.
TEST(WorldLine, KnotsAreKeptWithoutLossAndSmall) {
  test::Random random(11);
  for (const bool spins : {false, true}) {
    CountedMemory memory;
    Knot next{{0.0, {0.0, 0.0, 0.25}}, Vec3(0.0), 0.0, {0.0, {0.0, 0.0, 0.25}}, 0.0};
    WorldLine line(next, kC_m_s, 0.1, -1.0, &memory);
    std::vector<Knot> given{next};
    for (int i = 1; i < 1000; ++i) {
      const Motion turn = line.at(next.turn.t_s + random.in(0.1, 1.0));
      const Vec3 beta = random.inBall(0.9);
      next = {turn.event, uFromBeta({beta.x, beta.y, 0.0}), turn.properTime_s, turn.event, 0.0};
      if (spins && i >= 500)
        next.u.z = -0.0, next.spin = {random.in(-1.0, 1.0), random.in(-1.0, 1.0), 0.25, 0.5};
      if (spins && i == 700) next.deceleration_m_s2 = 0.125;
      line.append(next), given.push_back(next);
    }
    ASSERT_EQ(line.knots().size(), given.size());
    for (std::size_t i = 0; i < given.size(); ++i) {
      CASE(random, static_cast<int>(i));
      const Knot kept = line.knots()[i];
      EXPECT_EQ(std::memcmp(&kept, &given[i], sizeof(Knot)), 0);
    }
    EXPECT_LT(memory.bytes, (spins ? 240U : 110U) * given.size());
  }
}

// What is forgotten makes room for what comes: a line that keeps its length takes no more memory.
TEST(WorldLine, ForgettingMakesRoom) {
  CountedMemory memory;
  WorldLine line({{0.0, Vec3(0.0)}, Vec3(0.0), 0.0, {}, 0.0}, kC_m_s, 0.0, 0.0, &memory);
  std::size_t allocations = 0;
  for (int i = 1; i < 200; ++i) {
    line.append({{1.0 * i, Vec3(0.0)}, Vec3(0.0), 1.0 * i, {1.0 * i, Vec3(0.0)}, 0.0});
    line.forgetBefore(i - 9.5);
    if (i == 30) allocations = memory.allocations;
  }
  EXPECT_EQ(memory.allocations, allocations);
  EXPECT_EQ(line.knots().size(), 11U);
  EXPECT_EQ(line.at(195.0).properTime_s, 195.0);
}

TEST(WorldLine, TruncationForgetsTheFuture) {
  test::Random random(3);
  WorldLine line = randomWorldLine(random, kC_m_s, 0.1, 10, 1.0, 0.9);
  const WorldLine whole = line;
  const double cut_s = line.knots()[6].turn.t_s;
  line.truncateFrom(cut_s);
  ASSERT_EQ(line.knots().size(), 6U);
  EXPECT_TRUE(line.settlesBeforeNext(5));
  for (std::size_t i = 6; i < whole.knots().size(); ++i) line.append(whole.knots()[i]);
  for (std::size_t i = 0; i < whole.knots().size(); ++i) {
    CASE(random, i);
    EXPECT_EQ(line.settlesBeforeNext(i), whole.settlesBeforeNext(i));
    EXPECT_EQ(line.settled_s(i), whole.settled_s(i));
  }
}

// Constant proper deceleration by steps: du/dt = −a/c, dx/dt = c u/γ, dτ/dt = 1/γ.
TEST(WorldLine, FrictionLegMatchesNumericalIntegration) {
  const double a_m_s2 = 0.7;
  const Knot knot{{1.0, {0.2, 0.0, 0.0}}, {0.0, 1.5, 0.0}, 3.0, {}, a_m_s2};
  const double stop_s = 1.5 * kC_m_s / a_m_s2;
  for (const double dt_s : {0.5, 2.0, stop_s, stop_s + 1.0}) {
    const int steps = 200000;
    const double h_s = dt_s / steps;
    double y_m = 0.0;
    double tau_s = 3.0;
    for (int i = 0; i < steps; ++i) {
      const double u = std::max(0.0, 1.5 - a_m_s2 / kC_m_s * (i + 0.5) * h_s);
      y_m += kC_m_s * u / std::sqrt(1 + u * u) * h_s;
      tau_s += h_s / std::sqrt(1 + u * u);
    }
    const Motion motion = motionOnLeg(knot, 1.0 + dt_s, kC_m_s);
    EXPECT_NEAR(motion.event.r_m.y, y_m, 1e-9) << dt_s;
    EXPECT_NEAR(motion.properTime_s, tau_s, 1e-9) << dt_s;
    EXPECT_NEAR(motion.u.y, std::max(0.0, 1.5 - a_m_s2 / kC_m_s * dt_s), 1e-12) << dt_s;
  }
  // Before its turn the leg is continued without friction.
  const Motion earlier = motionOnLeg(knot, 0.0, kC_m_s);
  EXPECT_EQ(earlier.u.y, 1.5);
  EXPECT_NEAR(earlier.event.r_m.y, -kC_m_s * 1.5 / std::sqrt(3.25), 1e-15);
  EXPECT_NEAR(earlier.properTime_s, 3.0 - 1.0 / std::sqrt(3.25), 1e-15);
}

TEST(WorldLine, AnglesLieWithinHalfATurn) {
  test::Random random(15);
  for (int i = 0; i < 1000; ++i) {
    CASE(random, i);
    const double rim = random.in(-0.99, 0.99);
    Spin spin{random.in(-3.0, 3.0), 40.0 * rim, rim / std::sqrt(1.0 - rim * rim), 0.0};
    if (i % 2 == 0) spin.slowing_1_s = random.in(0.01, 1.0);
    const double own_s = random.in(-100.0, 1000.0), angle_rad = angleAfter(spin, own_s);
    EXPECT_LE(std::abs(angle_rad), M_PI);
    if (spin.slowing_1_s == 0.0) {
      EXPECT_NEAR(std::remainder(spin.angle_rad + spin.omega_rad_s * own_s - angle_rad, 2.0 * M_PI), 0.0,
                  1e-10);
    }
  }
}

// The bound against what points really do.
TEST(WorldLine, EveryPointHasJoinedItsLegWhenItIsSettled) {
  test::Random random(4);
  for (int i = 0; i < 300; ++i) {
    CASE(random, i);
    const double radius_m = 0.05;
    const WorldLine line = randomWorldLine(random, kC_m_s, radius_m, 6, random.in(0.05, 2.0), 0.9);
    for (int k = 0; k < 20; ++k) {
      const Vec3 offset_m = random.inBall(radius_m);
      const auto history = vertexHistory(line, offset_m);
      const Knot& last = line.knots().back();
      // The last piece begins where the point joins the last leg.
      const Displacement joined = Lorentz::boost(-last.u, kC_m_s) * (history.back().start - last.turn);
      ASSERT_LE(joined.dt_s, line.settled_s(line.knots().size() - 1)) << "case " << i << " point " << k;
    }
  }
}

// A body that is slowed by a blow from behind, and then by friction that all but tears it apart: its points
// chase what brakes away from them, longer than without friction, and have joined when both bounds say so.
TEST(WorldLine, GlidingPointsHaveJoinedTheirLegWhenItIsSettled) {
  const double radius_m = 0.05;
  for (const double pull : {0.25, 0.4, 0.499}) {  // R a, over c²
    for (const double beta : {0.6, 0.8}) {
      SCOPED_TRACE(testing::Message() << "R a = " << pull << " c², then " << beta << " c");
      const double friction_m_s2 = pull * kC_m_s * kC_m_s / radius_m;
      WorldLine line({{0.0, Vec3(0.0)}, uFromBeta({0.899, 0.0, 0.0}), 0.0, {}, friction_m_s2}, kC_m_s,
                     radius_m);
      const Motion turn = line.at(1e-4);
      line.append({turn.event, uFromBeta({beta, 0.0, 0.0}), turn.properTime_s, turn.event, friction_m_s2});
      const Lorentz bodyFromBoard = Lorentz::boost(-line.knots()[1].u, kC_m_s);
      const double bound_s = joinedAfter_s(line);
      for (int point = 0; point < 24; ++point) {
        const double around = 2.0 * M_PI * point / 24;
        const Event joined =
            vertexHistory(line, radius_m * Vec3(std::cos(around), std::sin(around), 0.0)).back().start;
        const double joined_s = (bodyFromBoard * (joined - turn.event)).dt_s;
        EXPECT_LE(joined_s, line.settled_s(1)) << "point " << point;
        EXPECT_LE(joined_s, bound_s) << "point " << point;
      }
    }
  }
}

TEST(WorldLine, WhatHasBeenForgottenCanBeginAnew) {
  test::Random random(12);
  const WorldLine whole = test::randomWorldLine(random, 1.42, 0.03, 20, 0.5, 0.8);
  WorldLine line = whole;
  ASSERT_GT(line.forgetBefore(whole.knots()[8].turn.t_s), 0U);
  const double start_s = whole.knots()[0].turn.t_s;
  line.truncateFrom(start_s);
  ASSERT_EQ(line.knots().size(), 1U);
  EXPECT_EQ(line.at(start_s - 1.0).event.r_m, whole.at(start_s - 1.0).event.r_m);
  for (const Knot& knot : whole.knots().subspan(1)) line.append(knot);
  for (std::size_t knot = 0; knot < whole.knots().size(); ++knot) {
    CASE(random, knot);
    EXPECT_EQ(line.settled_s(knot), whole.settled_s(knot)) << "knot " << knot;
    EXPECT_EQ(line.settlesBeforeNext(knot), whole.settlesBeforeNext(knot)) << "knot " << knot;
  }
}

}  // namespace
}  // namespace carom
