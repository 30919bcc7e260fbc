// A carom is counted when its second touch is seen: against the list of all collisions.
#include "app/play/carom_score.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

#include <glm/geometric.hpp>

#include "app/scenario/scenario.h"
#include "engine/billiard/billiard.h"
#include "engine/random_world.h"
#include "places.h"

namespace carom {
namespace {

constexpr double kNever_s = std::numeric_limits<double>::infinity();

/// When an eye that rests here sees the struck puck to have touched two others: for each other puck the
/// earliest touch that is seen, and of these times the second.
double caromSeen_s(const Billiard& game, std::size_t puck, double arrives_s, const Vec3& eye_m,
                   double c_m_s) {
  std::map<std::size_t, double> touched_s;
  for (const GameEvent& event : game.events()) {
    if (event.kind != EventKind::puckPuck || event.at.t_s < arrives_s) continue;
    const std::size_t a = event.turns[0].puck, b = event.turns[1].puck;
    if (a != puck && b != puck) continue;
    const double seen_s = event.at.t_s + glm::distance(event.at.r_m, eye_m) / c_m_s;
    const auto [other, isNew] = touched_s.try_emplace(a == puck ? b : a, seen_s);
    other->second = std::min(other->second, seen_s);
  }
  std::vector<double> times_s;
  for (const auto& [other, seen_s] : touched_s) times_s.push_back(seen_s);
  std::sort(times_s.begin(), times_s.end());
  return times_s.size() < 2 ? kNever_s : times_s[1];
}

TEST(CaromScore, CountsAShotOnceWhenItsSecondTouchIsSeen) {
  const Scenario scenario = readScenario(CAROM_CONFIG_DIR "/scenarios/table.toml");
  const double c_m_s = scenario.billiard.lightSpeed_m_s;
  test::Random random(11);
  int caroms = 0, misses = 0;
  for (int shot = 0; shot < 400; ++shot) {
    SCOPED_TRACE(shot);
    Billiard game(scenario.billiard);
    const auto puck = static_cast<std::size_t>(random.in(0.0, 2.999));
    const double angle_rad = random.in(-std::numbers::pi, std::numbers::pi), p_kg_m_s = random.in(0.1, 0.7);
    const double arrives_s = game.strike(
        {puck, 0.5, Vec3(0.0, -1.0, 1.0), p_kg_m_s * Vec2(std::cos(angle_rad), std::sin(angle_rad))});
    constexpr double kLong_s = 20.0, kStep_s = 0.05;
    game.advanceTo(kLong_s);
    const Vec3 eye_m(random.in(-1.0, 1.0), -1.6, 1.0);
    const double expected_s = caromSeen_s(game, puck, arrives_s, eye_m, c_m_s);
    CaromScore score;
    score.struck(puck, arrives_s);
    double counted_s = kNever_s;
    for (double t_s = 0.0; t_s < kLong_s; t_s += kStep_s) {
      if (score.look(game.events(), {t_s, eye_m}, c_m_s)) counted_s = std::min(counted_s, t_s);
    }
    const bool isCarom = expected_s < kLong_s - kStep_s;
    (isCarom ? caroms : misses) += 1;
    EXPECT_EQ(score.score().caroms, isCarom ? 1U : 0U);
    EXPECT_EQ(score.score().strokes, 1U);
    if (!isCarom) continue;
    EXPECT_GE(counted_s, expected_s);
    EXPECT_LE(counted_s, expected_s + kStep_s);
  }
  EXPECT_GT(caroms, 3);
  EXPECT_GT(misses, 3);
}

TEST(CaromScore, ATouchBeforeTheStrokeOrOfTheSamePuckAgainIsNone) {
  const auto touch = [](std::size_t a, std::size_t b, double t_s) {
    GameEvent event;
    event.kind = EventKind::puckPuck;
    event.at.t_s = t_s;
    for (const std::size_t puck : {a, b}) {
      Turn turn;
      turn.puck = puck;
      event.turns.push_back(turn);
    }
    return event;
  };
  CaromScore score;
  score.struck(0, 2.0);
  const std::vector<GameEvent> events{touch(0, 2, 1.0), touch(1, 0, 3.0), touch(0, 1, 4.0), touch(1, 2, 5.0)};
  EXPECT_FALSE(score.look(events, {100.0, Vec3(0.0)}, 1.42));
  EXPECT_TRUE(score.look(std::vector{touch(2, 0, 6.0)}, {100.0, Vec3(0.0)}, 1.42));
  EXPECT_FALSE(score.look(events, {100.0, Vec3(0.0)}, 1.42)) << "the shot is over";
}

}  // namespace
}  // namespace carom
