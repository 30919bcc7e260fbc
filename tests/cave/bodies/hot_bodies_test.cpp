#include "cave/bodies/hot_bodies.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "cave/frame/bodies.h"
#include "engine/billiard/billiard.h"
#include "engine/collision/kick.h"
#include "engine/light_speed.h"
#include "engine/random_world.h"

namespace carom {
namespace {

using test::kC_m_s;

constexpr std::uint64_t kAll = std::numeric_limits<std::uint64_t>::max();

// The sum of the heats of random kicks, against what each puck has of them.
TEST(SharedHeat, IsThatOfAKick) {
  test::Random random(7);
  int kicks = 0;
  for (int i = 0; i < 2000; ++i) {
    CASE(random, i);
    const auto some = [&] {
      const double angle = random.in(0.0, 6.28), u = random.in(0.0, 3.0);
      return fourVelocity(u * std::cos(angle), u * std::sin(angle));
    };
    const Vec21 u1 = some(), u2 = some();
    const std::array<double, 2> mass{random.in(0.01, 5.0), random.in(0.01, 5.0)};
    const Vec21 U = (u1 + u2) * (1.0 / std::sqrt(dot(u1 + u2, u1 + u2)));
    const Vec21 n = cross(U, some());
    const auto kick = kickPair(U, n, {u1, u2}, mass, random.in(0.0, 1.0));
    if (!kick) continue;
    const auto shared = sharedHeat(kick->heat[0] + kick->heat[1], mass);
    const double rounding = 1e-12 * (mass[0] + mass[1] + kick->heat[0] + kick->heat[1]);
    for (std::size_t k = 0; k < 2; ++k) EXPECT_NEAR(shared[k], kick->heat[k], rounding);
    ++kicks;
  }
  EXPECT_GT(kicks, 500);
}

GameEvent hit(std::uint64_t number, double t_s, double heat_j) {
  GameEvent event;
  event.number = number;
  event.kind = EventKind::puckCushion;
  event.at = {t_s, {0.3, 0.1, 0.0}};
  event.turns.push_back({0, event.at});
  event.heat_j = heat_j;
  return event;
}

double heatOf(const HotBlows& blows) {
  return static_cast<double>(blows.heats.x + blows.heats.y + blows.heats.z + blows.heats.w);
}

// Two equal pucks that come at 0.6 c each and stop: γ − 1 = 0.25 of each one's rest energy is heat then, and
// the eye has the blow where and when it was.
TEST(HotBodies, PucksThatStopHaveTheirKineticEnergyAsHeat) {
  BilliardSetup setup;
  setup.lightSpeed_m_s = kC_m_s;
  setup.rules.puckRestitution = 0.0;
  setup.rules.collisionEvent = CollisionEvent::contact;
  for (const double side : {-1.0, 1.0}) {
    Puck puck;
    puck.name = side < 0.0 ? "white" : "red";
    puck.radius_m = 0.1, puck.height_m = 0.04, puck.mass_kg = 0.2;
    puck.position_m = {side * 0.5, 0.0};
    puck.beta = {-side * 0.6, 0.0};
    setup.pucks.push_back(puck);
  }
  Billiard billiard(setup);
  billiard.advanceTo(3.0);
  const std::vector<GameEvent> events(billiard.events().begin(), billiard.events().end());
  ASSERT_EQ(events.size(), 1U);

  const std::vector<double> masses_kg{0.2, 0.2};
  HotBodies hot(masses_kg, 3, kC_m_s);
  hot.follow(events, kAll);
  const Event eye{2.0, {0.0, -1.0, 0.5}};
  const auto seen = hot.seenFrom(eye);
  ASSERT_EQ(seen.size(), 3U);
  EXPECT_EQ(heatOf(seen[kRestingBody]), 0.0);
  for (const std::size_t body : {kFirstPuck, kFirstPuck + 1}) {
    EXPECT_NEAR(heatOf(seen[body]), 0.25, 1e-6);
    for (int i = 0; i < 4; ++i) {
      if (seen[body].heats[i] == 0.0F) continue;
      const Displacement way = events[0].at - eye;
      const glm::vec4 expected(glm::vec4(static_cast<float>(kC_m_s * way.dt_s), glm::vec3(way.dr_m)));
      EXPECT_LT(glm::length(seen[body].fromEye_m[static_cast<std::size_t>(i)] - expected), 1e-6F);
    }
  }
  EXPECT_EQ(heatOf(hot.seenFrom({events[0].at.t_s - 0.01, eye.r_m})[kFirstPuck]), 0.0) << "before the blow";
}

TEST(HotBodies, RememberWhatTheGameForgotAndNotWhatItTookBack) {
  const double restEnergy_j = 0.2 * kC_m_s * kC_m_s;
  const std::vector<double> masses_kg{0.2};
  HotBodies hot(masses_kg, 2, kC_m_s);
  const auto seen = [&] { return heatOf(hot.seenFrom({20.0, Vec3(0.0)})[kFirstPuck]); };
  const std::vector<GameEvent> both{hit(0, 1.0, 0.1 * restEnergy_j), hit(1, 2.0, 0.2 * restEnergy_j)};
  hot.follow(both, kAll);
  EXPECT_NEAR(seen(), 0.3, 1e-6);
  hot.follow(both, kAll);
  EXPECT_NEAR(seen(), 0.3, 1e-6) << "the same events once more";
  hot.follow(std::span(both).subspan(1), kAll);
  EXPECT_NEAR(seen(), 0.3, 1e-6) << "the first is forgotten";
  const std::vector<GameEvent> other{hit(1, 3.0, 0.5 * restEnergy_j)};
  hot.follow(other, 1);
  EXPECT_NEAR(seen(), 0.6, 1e-6) << "a stroke has changed the second";
  hot.follow({}, kAll);
  EXPECT_NEAR(seen(), 0.6, 1e-6) << "all are forgotten";
  hot.follow({}, 1);
  EXPECT_NEAR(seen(), 0.1, 1e-6) << "the second is taken back";
  hot.follow({}, 0);
  EXPECT_EQ(seen(), 0.0) << "a game begins";
}

TEST(HotBodies, KeepTheFourBlowsOfWhichMostIsLeft) {
  const double restEnergy_j = 0.2 * kC_m_s * kC_m_s;
  const std::vector<double> masses_kg{0.2};
  HotBodies hot(masses_kg, 2, kC_m_s);
  std::vector<GameEvent> events;
  for (const double heat : {0.5, 0.01, 0.3, 0.02, 0.2, 0.015, 0.1})
    events.push_back(hit(events.size(), 1.0 + 0.1 * static_cast<double>(events.size()), heat * restEnergy_j));
  hot.follow(events, kAll);
  EXPECT_NEAR(heatOf(hot.seenFrom({5.0, Vec3(0.0)})[kFirstPuck]), 1.1, 1e-6);
}

TEST(HotBodies, HeatThatNobodySeesIsNone) {
  const std::vector<double> masses_kg{0.2};
  HotBodies hot(masses_kg, 2, kC_m_s);
  const std::vector<GameEvent> events{hit(0, 1.0, 0.03 * 0.2 * kC_m_s * kC_m_s)};
  hot.follow(events, kAll);
  EXPECT_EQ(heatOf(hot.seenFrom({5.0, Vec3(0.0)})[kFirstPuck]), 0.0);
}

}  // namespace
}  // namespace carom
