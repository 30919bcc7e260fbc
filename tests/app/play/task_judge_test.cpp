// Whether a task is done: when the light of what it asks for arrives at the one who plays, by closed forms.
#include "app/play/task_judge.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace carom {
namespace {

constexpr double kC_m_s = 1.42;

Task taskOf(TaskGoal::Kind kind, const std::vector<std::size_t>& pucks, TaskWorld world = TaskWorld::seen) {
  Task task;
  task.goal.kind = kind;
  task.goal.pucks = pucks;
  task.world = world;
  return task;
}

GameEvent meeting(std::size_t a, std::size_t b, const Event& at) {
  GameEvent event;
  event.kind = EventKind::puckPuck;
  event.at = at;
  for (const std::size_t puck : {a, b}) {
    Turn turn;
    turn.puck = puck;
    turn.event = at;
    event.turns.push_back(turn);
  }
  return event;
}

/// A viewer whose eye rests in the origin of the board, and whose own time is told.
ObserverView viewAt(double t_s, double own_s) {
  ObserverView view;
  view.headFromBoard = Lorentz(kC_m_s);
  view.left.observation = view.middle.observation = view.right.observation = {t_s, Vec3(0.0)};
  view.properTime_s = own_s;
  return view;
}

bool look(TaskJudge& judge, std::span<const GameEvent> events, double t_s,
          std::span<const WorldLine> pucks = {}) {
  return judge.look(events, pucks, viewAt(t_s, t_s), Lorentz(kC_m_s));
}

TEST(TaskJudge, AWorldIsDrawnWithItsEffectsAndTheColoursThatWereThere) {
  for (const std::uint8_t colour : {std::uint8_t{0}, std::uint8_t{1}}) {
    Switches before;
    before.colour = colour;
    before.searchlight = colour == 0 ? 1 : 0;
    const auto effects = [&](TaskWorld world) {
      const Switches now = switchesOf(world, before);
      EXPECT_EQ(now.colour, before.colour);
      EXPECT_EQ(now.searchlight, before.searchlight);
      return std::to_string(now.retardation) + std::to_string(now.contraction) +
             std::to_string(now.aberration);
    };
    EXPECT_EQ(effects(TaskWorld::newton), "100");
    EXPECT_EQ(effects(TaskWorld::measured), "010");
    EXPECT_EQ(effects(TaskWorld::seen), "111");
  }
}

// Light that leaves 2 light seconds away at 5 s is here at 7 s. A world that is measured shows it at 5 s.
TEST(TaskJudge, AHitCountsWhenItIsSeen) {
  const std::vector<GameEvent> events{meeting(0, 1, {5.0, Vec3(2.0 * kC_m_s, 0.0, 0.0)})};
  for (const TaskWorld world : {TaskWorld::seen, TaskWorld::newton, TaskWorld::measured}) {
    SCOPED_TRACE(static_cast<int>(world));
    const Task task = taskOf(TaskGoal::Kind::hit, {1}, world);
    const double seen_s = world == TaskWorld::measured ? 5.0 : 7.0;
    TaskJudge judge(task, kC_m_s);
    EXPECT_FALSE(look(judge, events, 8.0)) << "before the first stroke";
    judge.struck(0, 4.0);
    EXPECT_FALSE(look(judge, events, seen_s - 1e-6));
    EXPECT_TRUE(look(judge, events, seen_s + 1e-6));
  }
}

TEST(TaskJudge, AHitIsOneOfTheStruckPuckAfterItsStroke) {
  const std::vector<GameEvent> events{meeting(0, 1, {5.0, Vec3(0.0)})};
  const auto isDone = [&](std::size_t target, std::size_t struck, double arrives_s) {
    const Task task = taskOf(TaskGoal::Kind::hit, {target});
    TaskJudge judge(task, kC_m_s);
    judge.struck(struck, arrives_s);
    return look(judge, events, 9.0);
  };
  EXPECT_TRUE(isDone(1, 0, 4.9));
  EXPECT_TRUE(isDone(0, 1, 4.9));
  EXPECT_FALSE(isDone(1, 0, 5.1)) << "it hit before the stroke arrived";
  EXPECT_FALSE(isDone(1, 2, 4.9)) << "another puck was struck";
  EXPECT_FALSE(isDone(2, 0, 4.9)) << "another puck was hit";
  EXPECT_FALSE(isDone(1, 1, 4.9)) << "the puck itself was struck";
}

// Two hits at distances whose light arrives so long after one another, by a clock that may go slower than the
// board's.
TEST(TaskJudge, TwoHitsAtOnceAreAtMostATenthOfASecondOfTheOwnTimeApart) {
  const auto isDone = [](double apart_s, double rate) {
    const Task task = taskOf(TaskGoal::Kind::hitBoth, {1, 2});
    TaskJudge judge(task, kC_m_s);
    judge.struck(0, 0.5);
    const std::vector<GameEvent> events{meeting(0, 1, {2.0, Vec3(kC_m_s, 0.0, 0.0)}),
                                        meeting(0, 2, {2.5, Vec3(0.0, (0.5 + apart_s) * kC_m_s, 0.0)})};
    for (int frame = 0; frame < 300; ++frame) {
      const double t_s = frame / 60.0;
      if (judge.look(events, {}, viewAt(t_s, rate * t_s), Lorentz(kC_m_s))) return true;
    }
    return false;
  };
  for (const double rate : {1.0, 0.5}) {
    SCOPED_TRACE(rate);
    EXPECT_TRUE(isDone(0.0, rate));
    EXPECT_TRUE(isDone(0.099 / rate, rate));
    EXPECT_FALSE(isDone(0.101 / rate, rate));
  }
}

// A clock that rests at a distance d is seen to read t − d/c.
TEST(TaskJudge, ClocksReadTheSameAsTheyAreSeen) {
  const auto isDone = [](double apart_s, TaskWorld world) {
    const Task task = taskOf(TaskGoal::Kind::clockReads, {0, 1}, world);
    std::vector<WorldLine> pucks;
    for (const double way_s : {1.0, 1.0 + apart_s}) {
      Knot knot;
      knot.turn = {0.0, Vec3(way_s * kC_m_s, 0.0, 0.0)};
      pucks.emplace_back(knot, kC_m_s, 0.03);
    }
    TaskJudge judge(task, kC_m_s);
    judge.struck(0, 1.0);
    return look(judge, {}, 10.0, pucks);
  };
  EXPECT_TRUE(isDone(0.049, TaskWorld::seen));
  EXPECT_FALSE(isDone(0.051, TaskWorld::seen));
  EXPECT_TRUE(isDone(0.051, TaskWorld::measured)) << "where nothing is late";
}

}  // namespace
}  // namespace carom
