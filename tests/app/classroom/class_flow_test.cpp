// The course of a question: every step from every phase, against a table that is written down here.
#include "app/classroom/class_flow.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace carom {
namespace {

using Step = ClassStep;
using Phase = ClassPhase;

/// Takes steps of these names, which must be possible.
ClassFlow after(const std::vector<const char*>& steps) {
  ClassFlow flow;
  for (const char* name : steps) {
    const auto step = classStepNamed(name);
    EXPECT_TRUE(step && flow.take(*step)) << name;
  }
  return flow;
}

TEST(ClassFlow, GoesTheWholeWay) {
  ClassFlow flow;
  const struct {
    Step step;
    Phase phase;
    int round;
  } way[]{{Step::ask, Phase::vote, 1},          {Step::close, Phase::closed, 1},
          {Step::discuss, Phase::discuss, 1},   {Step::again, Phase::vote, 2},
          {Step::close, Phase::closed, 2},      {Step::show, Phase::shown, 2},
          {Step::explain, Phase::explained, 2}, {Step::next, Phase::idle, 0}};
  EXPECT_EQ(flow.phase(), Phase::idle);
  for (const auto& [step, phase, round] : way) {
    EXPECT_TRUE(flow.may(step)) << static_cast<int>(step);
    EXPECT_TRUE(flow.take(step)) << static_cast<int>(step);
    EXPECT_EQ(flow.phase(), phase);
    EXPECT_EQ(flow.round(), round);
    EXPECT_EQ(flow.isOpen(), phase == Phase::vote);
  }
}

TEST(ClassFlow, TakesOnlyTheStepsOfEachPhase) {
  const struct {
    std::vector<const char*> way;
    std::string possible;
  } cases[]{{{}, "ask show next "},
            {{"ask"}, "close "},
            {{"ask", "close"}, "discuss show next "},
            {{"ask", "close", "discuss"}, "again show next "},
            {{"ask", "close", "discuss", "again"}, "close "},
            {{"ask", "close", "discuss", "again", "close"}, "show next "},
            {{"ask", "close", "show"}, "explain next "},
            {{"show", "explain"}, "show next "}};
  for (const auto& [way, possible] : cases) {
    std::string found;
    for (std::size_t i = 0; i < kClassSteps.size(); ++i) {
      const auto step = static_cast<Step>(i);
      ClassFlow flow = after(way);
      const Phase before = flow.phase();
      const int round = flow.round();
      if (flow.may(step)) found += std::string(kClassSteps[i]) + " ";
      if (flow.take(step)) continue;
      EXPECT_EQ(flow.phase(), before) << "a refused step changes nothing";
      EXPECT_EQ(flow.round(), round);
    }
    EXPECT_EQ(found, possible);
  }
}

TEST(ClassFlow, FollowsTheLessonOnTheWall) {
  ClassFlow flow = after({"ask"});
  flow.follow(LessonPhase::asks);
  EXPECT_EQ(flow.phase(), Phase::vote) << "the lesson asks while the class votes";
  flow.follow(LessonPhase::shows);
  EXPECT_EQ(flow.phase(), Phase::shown);
  EXPECT_EQ(flow.round(), 1);
  flow.follow(LessonPhase::explains);
  EXPECT_EQ(flow.phase(), Phase::explained);
  flow.follow(LessonPhase::shows);
  EXPECT_EQ(flow.phase(), Phase::shown);
  flow.follow(LessonPhase::asks);
  EXPECT_EQ(flow.phase(), Phase::idle) << "asked anew";
  EXPECT_EQ(flow.round(), 0);
}

TEST(ClassFlow, HasNamesForItsSteps) {
  EXPECT_EQ(classStepNamed("again"), Step::again);
  for (const char* wrong : {"", "Ask", "asks", "nothing"}) EXPECT_FALSE(classStepNamed(wrong)) << wrong;
}

}  // namespace
}  // namespace carom
