#include "engine/spacetime/event.h"

#include <cmath>

#include <gtest/gtest.h>

#include "engine/light_speed.h"
#include "engine/random_world.h"

namespace carom {
namespace {

template <class A, class B>
concept Addable = requires(A a, B b) {
  a + b;
};
static_assert(!Addable<Event, Event>, "events are points: they have no sum");
static_assert(Addable<Event, Displacement> && Addable<Displacement, Displacement>);

// Eighths up to 1000 add without rounding: the algebra of points and arrows holds to the last bit.
TEST(Event, PointsAndArrowsAddUp) {
  test::Random random(1);
  const auto eighths = [&] { return std::floor(random.in(-8000.0, 8000.0)) / 8.0; };
  const auto event = [&] { return Event{eighths(), {eighths(), eighths(), eighths()}}; };
  for (int i = 0; i < 1000; ++i) {
    CASE(random, i);
    const Event a = event(), b = event(), c = event();
    const Displacement d = b - a;
    EXPECT_EQ(d.dt_s, b.t_s - a.t_s);
    EXPECT_EQ(d.dr_m, b.r_m - a.r_m);
    EXPECT_EQ((a + d).t_s, b.t_s);
    EXPECT_EQ((a + d).r_m, b.r_m);
    EXPECT_EQ((b - d).r_m, a.r_m);
    EXPECT_EQ((-d).dr_m, (a - b).dr_m);
    const Displacement around = (b - a) + (c - b) + (a - c);
    EXPECT_EQ(around.dt_s, 0.0);
    EXPECT_EQ(around.dr_m, Vec3(0.0));
  }
}

// By its factors: c²Δt² − Δr² = (cΔt + Δr)(cΔt − Δr).
TEST(Event, IntervalIsPositiveBetweenEventsThatOneClockAttends) {
  using test::kC_m_s;
  test::Random random(2);
  for (int i = 0; i < 1000; ++i) {
    CASE(random, i);
    const Displacement d{random.in(-2.0, 2.0), random.inBall(2.0)};
    const double ct_m = kC_m_s * d.dt_s, r_m = std::sqrt(glm::dot(d.dr_m, d.dr_m));
    EXPECT_NEAR(interval_m2(d, kC_m_s), (ct_m + r_m) * (ct_m - r_m), 1e-14 * 10.0);
    EXPECT_EQ(interval_m2(-d, kC_m_s), interval_m2(d, kC_m_s));
  }
  EXPECT_GT(interval_m2({1.0, {1.41, 0.0, 0.0}}, kC_m_s), 0.0);
  EXPECT_LT(interval_m2({1.0, {0.0, 1.43, 0.0}}, kC_m_s), 0.0);
  EXPECT_EQ(interval_m2({0.5, {0.3, 0.4, 0.0}}, 1.0), 0.25 - (0.3 * 0.3 + 0.4 * 0.4));
}

}  // namespace
}  // namespace carom
