// Which events of a game are heard in which frame, how loud and how high.
#include "cave/audio/heard.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "cave/one_eye.h"
#include "engine/light_speed.h"
#include "engine/random_world.h"

namespace carom {
namespace {

using test::kC_m_s;
using test::observerAt;

constexpr Switches kNow{0, 1, 1, 0, 0};  // without retardation

GameEvent bounceAt(const Event& at, std::uint64_t number, double beta = 0.6) {
  GameEvent event;
  event.kind = EventKind::puckCushion;
  event.number = number;
  event.at = at;
  event.turns.push_back({0, at, {beta, 0.0}, {-beta, 0.0}, 0.0});
  return event;
}

// A person who walks about: every event is heard once, in the first frame at which its light has come.
TEST(Heard, EachOnceInTheFrameInWhichItsLightComes) {
  test::Random random(95);
  for (int game = 0; game < 20; ++game) {
    std::vector<GameEvent> events;
    for (std::uint64_t i = 0; i < 40; ++i)
      events.push_back(bounceAt({random.in(0.0, 8.0), random.inBox(1.5)}, i));
    const bool retarded = game % 2 == 0;
    Event eye{0.0, {0.0, -1.5, 0.9}};
    std::vector<int> times(events.size(), 0);
    std::vector<Heard> heard;
    for (int frame = 0; frame < 900; ++frame) {
      const Event before = eye;
      const Vec3 step_m = random.inBox(0.008);
      eye = {eye.t_s + std::hypot(1.0 / 60.0, glm::length(step_m) / kC_m_s), eye.r_m + step_m};
      heardBetween(observerAt(before), observerAt(eye), retarded ? Switches{} : kNow, events, heard);
      std::size_t due = 0;
      for (std::size_t i = 0; i < events.size(); ++i) {
        const auto late_s = [&](const Event& o) {
          return events[i].at.t_s + (retarded ? glm::distance(o.r_m, events[i].at.r_m) / kC_m_s : 0.0) -
                 o.t_s;
        };
        if (late_s(before) > 0.0 && late_s(eye) <= 0.0) {
          ++times[i];
          ++due;
        }
      }
      ASSERT_EQ(heard.size(), due) << "game " << game << ", frame " << frame;
    }
    for (std::size_t i = 0; i < times.size(); ++i)
      ASSERT_EQ(times[i], 1) << "game " << game << ", event " << i;
  }
}

// A stroke takes back what was committed and not yet seen; what comes again as it was is not heard twice.
TEST(Heard, WhatIsTakenBackAndComesAgainIsNotHeardTwice) {
  const Vec3 eye_m(0.0, -1.5, 0.9);
  const GameEvent first = bounceAt({1.0, Vec3(0.0)}, 0);
  const double seen_s = 1.0 + glm::length(eye_m) / kC_m_s;
  const auto frame = [&](int i) { return observerAt({seen_s + (i - 0.5) / 60.0, eye_m}); };
  std::vector<Heard> heard;
  heardBetween(frame(0), frame(1), {}, {first}, heard);
  EXPECT_EQ(heard.size(), 1u);
  GameEvent again = first;
  again.number = 7;
  const GameEvent other = bounceAt({1.0 + 1.0 / 60.0, Vec3(0.0)}, 8);  // and one that had not been heard
  heardBetween(frame(1), frame(2), {}, {again, other}, heard);
  ASSERT_EQ(heard.size(), 1u);
  heardBetween(frame(2), frame(3), {}, {again, other}, heard);
  EXPECT_TRUE(heard.empty());
}

TEST(Heard, NothingWhileTimeStandsRunsBackOrLeaps) {
  const Vec3 eye_m(0.0, -1.0, 0.0);
  const std::vector<GameEvent> events{bounceAt({0.0, Vec3(0.0)}, 0)};
  const double seen_s = 1.0 / kC_m_s;
  const auto count = [&](double from_s, double to_s) {
    std::vector<Heard> heard;
    heardBetween(observerAt({from_s, eye_m}), observerAt({to_s, eye_m}), {}, events, heard);
    return heard.size();
  };
  EXPECT_EQ(count(seen_s - 0.01, seen_s + 0.01), 1u);
  EXPECT_EQ(count(seen_s + 0.01, seen_s - 0.01), 0u);
  EXPECT_EQ(count(seen_s, seen_s), 0u);
  EXPECT_EQ(count(seen_s - 0.5, seen_s + 0.5), 0u);
}

// Soft pucks turn only after they touch: they are heard at the first touch, as loud as they close, and
// neither when they part nor when their far sides hear of it.
TEST(Heard, SoftPucksAtTheirFirstTouch) {
  const Vec3 eye_m(0.0, -0.5, 0.0);
  const double seen_s = 0.5 / kC_m_s;
  const auto hear = [&](EventKind kind, std::optional<Cushion> cushion, std::vector<Vec2> betas) {
    GameEvent event;
    event.kind = kind;
    event.cushion = cushion;
    event.at = {0.0, Vec3(0.0)};
    for (const Vec2& beta : betas) event.turns.push_back({0, event.at, beta, beta, 0.0});
    std::vector<Heard> heard;
    heardBetween(observerAt({seen_s - 0.01, eye_m}), observerAt({seen_s + 0.01, eye_m}), {}, {event}, heard);
    return heard;
  };
  const auto loudness = [&](EventKind kind, std::optional<Cushion> cushion, std::vector<Vec2> betas) {
    return hear(kind, cushion, std::move(betas)).at(0).loudness;
  };
  using enum EventKind;
  EXPECT_EQ(hear(softSoft, std::nullopt, {{0.3, 0.1}, {0.0, 0.1}}).at(0).kind, puckPuck);
  EXPECT_EQ(hear(softCushion, Cushion::plusX, {{0.3, 0.1}}).at(0).kind, puckCushion);
  for (const EventKind silent : {parted, farSide})
    EXPECT_TRUE(hear(silent, std::nullopt, {{0.3, 0.1}}).empty()) << nameOf(silent);
  // s/(1 + s) at a closing speed s, within the distance of full loudness.
  EXPECT_NEAR(loudness(softSoft, std::nullopt, {{0.3, 0.1}, {0.0, -0.3}}), 0.5 / 1.5, 1e-12);
  EXPECT_NEAR(loudness(softCushion, Cushion::plusX, {{0.3, -0.1}}), 0.3 / 1.3, 1e-12);
  EXPECT_NEAR(loudness(softCushion, Cushion::minusY, {{0.3, -0.1}}), 0.1 / 1.1, 1e-12);
}

// D = γ (1 + β cos θ) for a head that moves at β, θ from the way to what rests: 3 straight towards it at 0.8
// c.
TEST(Heard, IsShiftedAndLoudAsItShould) {
  const auto hear = [](double beta, double puckBeta, double away_m) {
    const Lorentz headFromBoard = Lorentz::boost(uFromBeta({beta, 0.0, 0.0}), kC_m_s).inverse();
    const double seen_s = away_m / kC_m_s;
    std::vector<Heard> heard;
    heardBetween(observerAt({seen_s - 0.01, {-away_m, 0, 0}}, headFromBoard),
                 observerAt({seen_s + 0.01, {-away_m, 0, 0}}, headFromBoard), {},
                 {bounceAt({0.0, Vec3(0.0)}, 0, puckBeta)}, heard);
    return heard.at(0);
  };
  EXPECT_NEAR(hear(0.8, 0.6, 1.0).doppler, 3.0, 1e-9);
  EXPECT_NEAR(hear(-0.8, 0.6, 1.0).doppler, 1.0 / 3.0, 1e-9);
  EXPECT_NEAR(hear(0.8, 0.6, 1.0).seen_m.x, 3.0, 1e-9) << "where it is seen";
  EXPECT_GT(hear(0.0, 0.9, 1.0).loudness, hear(0.0, 0.3, 1.0).loudness);
  EXPECT_GT(hear(0.0, 0.6, 1.0).loudness, hear(0.0, 0.6, 2.0).loudness);
  EXPECT_LE(hear(0.0, 0.999, 0.1).loudness, 1.0);
}

}  // namespace
}  // namespace carom
