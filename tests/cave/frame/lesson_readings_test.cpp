// What the stopwatches of a lesson read, and which events are simultaneous, against closed forms.
#include "cave/frame/lesson_readings.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "engine/random_world.h"
#include "engine/spacetime/lorentz.h"

namespace carom {
namespace {

constexpr double kC_m_s = 1.42;
constexpr double kRounding = 1e-12;  // of seconds of order one

Vec3 anyVec(test::Random& random, double size) {
  return {random.in(-size, size), random.in(-size, size), random.in(-size, size)};
}

/// The record of a head at `now` in a room that moves with `beta`.
struct Sight {
  Sight(const Event& now, const Vec3& beta, LessonPhase phaseNow)
      : boardFromRoom(Lorentz::boost(uFromBeta(beta), kC_m_s)), phase(phaseNow) {
    observer.middle.observation = now;
  }
  double reads_s(const Stopwatch& watch) const { return reading_s(watch, {observer, boardFromRoom, phase}); }
  ObserverView observer;
  Lorentz boardFromRoom;
  LessonPhase phase;
};

TEST(LessonReadings, TimeBetweenEventsIsTheTransformOfLorentz) {
  test::Random random(71);
  for (int i = 0; i < 200; ++i) {
    CASE(random, i);
    const Event from{random.in(-3.0, 3.0), anyVec(random, 2.0)},
        to{random.in(-3.0, 3.0), anyVec(random, 2.0)};
    const Vec3 beta = anyVec(random, 0.57);
    const double gamma = 1.0 / std::sqrt(1.0 - glm::dot(beta, beta));
    const double expected_s = gamma * (to.t_s - from.t_s - glm::dot(beta, to.r_m - from.r_m) / kC_m_s);
    ASSERT_NEAR(elapsed_s(from, to, beta, kC_m_s), expected_s, 1e-9);  // γ up to 30
    const Event simultaneous{simultaneousAt_s(from, to.r_m, beta, kC_m_s), to.r_m};
    ASSERT_NEAR(elapsed_s(from, simultaneous, beta, kC_m_s), 0.0, 1e-9);
  }
}

// Where the event that stops it comes first, there is nothing to run: it says so once both have happened.
TEST(LessonReadings, AStopwatchWhoseEventsComeInTheOtherOrderShowsByHowMuch) {
  Stopwatch watch;
  watch.clock = StopwatchClock::room;
  watch.starts = {0.9, Vec3(-1.2, 0.0, 0.0)};
  watch.stops = Event{1.6, Vec3(1.2, 0.0, 0.0)};
  const double expected_s = 1.25 * (0.7 - 0.6 * 2.4 / kC_m_s);
  ASSERT_LT(expected_s, -0.3);
  const auto reads_s = [&](double after_s) {  // for a person at A who moves with 0.6 c
    const Event now{0.9 + 1.25 * after_s, Vec3(-1.2 + 1.25 * after_s * 0.6 * kC_m_s, 0.0, 0.0)};
    return Sight(now, Vec3(0.6, 0.0, 0.0), LessonPhase::shows).reads_s(watch);
  };
  EXPECT_EQ(reads_s(-1.0), 0.0);
  EXPECT_EQ(reads_s(-0.01), 0.0);
  for (const double after_s : {0.01, 3.0}) EXPECT_NEAR(reads_s(after_s), expected_s, kRounding) << after_s;
}

TEST(LessonReadings, AStopwatchRunsBetweenItsEventsAndThenStays) {
  Stopwatch watch;
  watch.starts = {1.0, Vec3(0.0)};
  watch.stops = Event{3.0, Vec3(0.0)};
  for (const auto& [t_s, expected_s] : {std::pair{0.5, 0.0}, {1.0, 0.0}, {2.5, 1.5}, {3.0, 2.0}, {9.0, 2.0}})
    EXPECT_NEAR(Sight({t_s, Vec3(0.0)}, Vec3(0.0), LessonPhase::shows).reads_s(watch), expected_s, kRounding)
        << t_s;
  EXPECT_NEAR(Sight({0.5, Vec3(0.0)}, Vec3(0.0), LessonPhase::explains).reads_s(watch), 2.0, kRounding)
      << "while the lesson explains it has stopped";
  watch.stops.reset();
  EXPECT_NEAR(Sight({9.0, Vec3(0.0)}, Vec3(0.0), LessonPhase::explains).reads_s(watch), 8.0, kRounding);
}

TEST(LessonReadings, AStopwatchOfTheRoomIsThatOfItsFrame) {
  Stopwatch room;
  room.clock = StopwatchClock::room;
  room.starts = {1.5, {1.42, 0.0, 0.0}};
  room.stops = Event{1.5, {-1.42, 0.0, 0.0}};
  for (const double beta : {-0.5, 0.0, 0.5}) {
    Stopwatch frame = room;
    frame.clock = StopwatchClock::frame;
    frame.beta = {beta, 0.0, 0.0};
    const double expected_s = beta * 2.84 / kC_m_s / std::sqrt(1.0 - beta * beta);  // γβL/c
    const Sight sight({1.0, {0.0, -2.0, 0.9}}, {beta, 0.0, 0.0}, LessonPhase::explains);
    EXPECT_NEAR(sight.reads_s(room), expected_s, kRounding) << beta;
    EXPECT_NEAR(sight.reads_s(frame), expected_s, kRounding) << beta;
  }
}

TEST(LessonReadings, LightsWayAndTheOwnClock) {
  Stopwatch light;
  light.starts = {1.0, {0.0, 3.0, 0.0}};
  light.stopsWhenSeen = true;
  const Vec3 eye_m(4.0, 0.0, 0.0);  // 5 m away
  EXPECT_NEAR(Sight({2.0, eye_m}, Vec3(0.0), LessonPhase::shows).reads_s(light), 1.0, kRounding);
  EXPECT_NEAR(Sight({9.0, eye_m}, Vec3(0.0), LessonPhase::shows).reads_s(light), 5.0 / kC_m_s, kRounding);
  Stopwatch seen;
  seen.clock = StopwatchClock::seen;
  seen.seen_m = {0.0, 3.0, 0.0};
  EXPECT_NEAR(Sight({2.0, eye_m}, Vec3(0.0), LessonPhase::shows).reads_s(seen), 2.0 - 5.0 / kC_m_s, kRounding)
      << "before the light of its start has come it is negative";
  Stopwatch mine;
  mine.clock = StopwatchClock::mine;
  Sight own({9.0, eye_m}, Vec3(0.0), LessonPhase::explains);
  own.observer.properTime_s = 2.25;
  EXPECT_EQ(own.reads_s(mine), 2.25);
}

TEST(LessonReadings, TheVelocityIsFoundAgain) {
  LessonPlan plan;
  plan.observers = {{"at rest", Vec3(0.0)}, {"right", {0.5, 0.0, 0.0}}};
  const auto found = [&](const Vec3& beta) {
    const glm::dquat turn = glm::angleAxis(0.7, glm::normalize(Vec3(0.1, 0.2, 1.0)));
    return observerOf(plan, Lorentz::boost(uFromBeta(beta), kC_m_s) * Lorentz::rotation(turn, kC_m_s));
  };
  EXPECT_EQ(found({0.0, 0.0, 0.0}), 0u);
  EXPECT_EQ(found({0.5, 0.0, 0.0}), 1u);
  EXPECT_FALSE(found({0.49, 0.0, 0.0})) << "steered by hand";
}

}  // namespace
}  // namespace carom
