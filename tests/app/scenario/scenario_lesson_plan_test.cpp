// What a lesson shows, measures and draws: its tables, their usual values, and names that are not in the
// game.
#include "app/scenario/scenario_lesson_plan.h"

#include <gtest/gtest.h>

#include <string>

#include "app/scenario/scenario_text.h"
#include "cave/frame/bodies.h"

namespace carom {
namespace {

using test::Fault;
using test::kHead;
using test::kOther;
using test::kPuck;
using test::nameOfFault;
using test::read;
using test::ScenarioFaults;

/// A game of the pucks a and b with flashes at 2 s and 9 s, and a lesson from `from_s` on, in line 29.
std::string lessonFrom(const std::string& times, const std::string& lines = "") {
  return kHead + kPuck + kOther +
         "[[flash]]\nname = 'go 1'\nat_s = 2\nr_m = [0, 1, 0]\n[[flash]]\nname = 'go 2'\nat_s = 9\n"
         "r_m = [0, 0, 0]\n[lesson]\nquestion = 'q'\nanswers = ['1', '2']\nright = 1\ntodo = 't'\n"
         "notice = 'n'\nnumber = 'm'\n" +
         times + lines;
}

/// Such a lesson with these lines, which begin in line 32.
std::string withLines(const std::string& lines) {
  return lessonFrom("from_s = 1\nuntil_s = 5\nmoment_s = 3\n", lines);
}

LessonPlan planOf(const std::string& lines) { return read(withLines(lines)).lesson.value().plan; }

TEST(LessonPlan, ReadsItsIntervalAndWhatItMeasures) {
  const LessonPlan plan = planOf(
      "slowness = 4\n[[lesson.observer]]\nname = 'me'\nbeta = [0.6, 0, 0]\n"
      "[[lesson.stopwatch]]\nname = 'ours'\nbeta = [0, 0.5, 0]\nstarts = 'go 1'\nstops_when_seen = true\n"
      "[[lesson.stopwatch]]\nname = 'there'\nclock = 'seen'\nplace_m = [1, 2, 3]\n"
      "[[lesson.counter]]\nbody = 'a'\nflashes = 'go'\n"
      "[[lesson.gauge]]\nbody = 'b'\nshows = 'gamma'\n");
  EXPECT_EQ(plan.interval.from_s, 1.0);
  EXPECT_EQ(plan.interval.until_s, 5.0);
  EXPECT_EQ(plan.interval.moment_s, 3.0);
  EXPECT_EQ(plan.interval.slowness, 4.0);
  ASSERT_EQ(plan.observers.size(), 1u);
  EXPECT_EQ(plan.observers[0].beta, Vec3(0.6, 0, 0));
  ASSERT_EQ(plan.stopwatches.size(), 2u);
  EXPECT_EQ(plan.stopwatches[0].starts.t_s, 2.0);
  EXPECT_EQ(plan.stopwatches[0].starts.r_m, Vec3(0, 1, 0));
  EXPECT_EQ(plan.stopwatches[0].beta, Vec3(0, 0.5, 0));
  EXPECT_TRUE(plan.stopwatches[0].stopsWhenSeen);
  EXPECT_FALSE(plan.stopwatches[0].stops);
  EXPECT_EQ(plan.stopwatches[1].clock, StopwatchClock::seen);
  EXPECT_EQ(plan.stopwatches[1].seen_m, Vec3(1, 2, 3));
  ASSERT_EQ(plan.counters.size(), 1u);
  EXPECT_EQ(plan.counters[0].body, kFirstPuck);
  EXPECT_EQ(plan.counters[0].ticks.size(), 2u);
  ASSERT_EQ(plan.gauges.size(), 1u);
  EXPECT_EQ(plan.gauges[0].body, kFirstPuck + 1);
  EXPECT_EQ(plan.gauges[0].quantity, GaugeQuantity::gamma);
}

// A line of simultaneity reaches from cushion to cushion; on an open plane, 1.5 m to each side.
TEST(LessonPlan, LinesOfSimultaneityEndAtTheCushions) {
  const std::string line = "[[lesson.simultaneous]]\nwith = 'go 1'\n";
  const SimultaneityLine open = planOf(line).simultaneous.at(0);
  EXPECT_EQ(open.from_m, -1.5);
  EXPECT_EQ(open.to_m, 1.5);
  EXPECT_FALSE(open.beta) << "of the observer's room";
  const SimultaneityLine onBoard =
      read(withLines(line + "[board]\nlength_m = 4\nwidth_m = 3\n")).lesson->plan.simultaneous.at(0);
  EXPECT_EQ(onBoard.from_m, -2.0);
  EXPECT_EQ(onBoard.to_m, 2.0);
  EXPECT_EQ(planOf(line + "to_m = 0.5\n").simultaneous.at(0).to_m, 0.5);
}

INSTANTIATE_TEST_SUITE_P(
    LessonPlans, ScenarioFaults,
    ::testing::Values(
        Fault{"ends before it begins", lessonFrom("from_s = 3\nuntil_s = 2\nmoment_s = 3\n"), 30, 11,
              "above 3 and up to 63"},
        Fault{"lasts too long", lessonFrom("from_s = 3\nuntil_s = 63.5\nmoment_s = 3\n"), 30, 11,
              "above 3 and up to 63"},
        Fault{"moment outside", lessonFrom("from_s = 1\nuntil_s = 5\nmoment_s = 5.5\n"), 31, 12,
              "expected a time from 1 to 5"},
        Fault{"gauge of nothing", withLines("[[lesson.gauge]]\nbody = 'c'\n"), 33, 8,
              "there is no body 'c', expected"},
        Fault{"flash of nothing", withLines("[[lesson.simultaneous]]\nwith = 'go 3'\n"), 33, 8,
              "there is no flash 'go 3'"},
        Fault{"flash after it", withLines("[[lesson.simultaneous]]\nwith = 'go 2'\n"), 33, 8,
              "the flash 'go 2' is at 9 s, expected one that the lesson shows, up to 5 s"},
        Fault{"counter of nothing", withLines("[[lesson.counter]]\nbody = 'a'\nflashes = 'stop'\n"), 34, 11,
              "there is no flash 'stop'"},
        Fault{"observer as fast as light",
              withLines("[[lesson.observer]]\nname = 'x'\nbeta = [0.6, 0.8, 0]\n"), 34, 8, "below light"},
        Fault{"long label", withLines("[[lesson.label]]\ntext = 'abcdefghijklm'\nat_m = [0, 0, 0]\n"), 33, 8,
              "the label has 13 letters, expected at most 12"},
        Fault{"arrow to nothing", withLines("[[lesson.arrow]]\n"), 32, 1, "expected either body or at_m"},
        Fault{"arrow to two things", withLines("[[lesson.arrow]]\nbody = 'a'\nat_m = [0, 0, 0]\n"), 33, 8,
              "expected either body or at_m"},
        Fault{"explained for no observer", withLines("explained_for = 2\n"), 32, 17, "explained_for is 2"}),
    nameOfFault);

}  // namespace
}  // namespace carom
