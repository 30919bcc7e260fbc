// How a lesson goes, and how it is read from a scenario.
#include "app/operator/lesson.h"

#include <gtest/gtest.h>

#include "app/file_keys/lesson_keys.h"
#include "app/input_faults.h"
#include "app/temporary_folder.h"
#include "app/toml/toml_file.h"
#include "places.h"

namespace carom {
namespace {

using test::TemporaryFolder;

constexpr LessonState kAsks{LessonPhase::asks, 0};

const std::string kHead = "light_speed_m_s = 1\ntitle = 'Twins'\n";
const std::string kLesson = R"([lesson]
question = "Who is older?"
answers = ["Neither", "Who stayed"]
right = 2
todo = "Go."
notice = "The clocks."
number = "10 s and 8 s."
views = ["clocks", "my-now"]
from_s = 0.5
until_s = 3.0
moment_s = 1.0
)";

Scenario read(const std::string& text) {
  const TemporaryFolder folder;
  return readScenario(folder.file("given.toml", text));
}

TEST(LessonFlow, AnAnswerComesBeforeTheSight) {
  const LessonState shows = advance(kAsks, 3, 2, false);
  EXPECT_EQ(shows, (LessonState{LessonPhase::shows, 2}));
  const LessonState explains = advance(shows, 3, 0, true);
  EXPECT_EQ(explains, (LessonState{LessonPhase::explains, 2}));
  EXPECT_EQ(advance(explains, 3, 0, true), shows) << "and back";
}

TEST(LessonFlow, AQuestionCanBePassedOver) {
  EXPECT_EQ(advance(kAsks, 3, 0, true), (LessonState{LessonPhase::shows, 0}));
}

TEST(LessonFlow, WhatIsNoAnswerChangesNothing) {
  for (const int answer : {-1, 0, 4, 9}) EXPECT_EQ(advance(kAsks, 3, answer, false), kAsks) << answer;
  for (const LessonPhase phase : {LessonPhase::none, LessonPhase::shows, LessonPhase::explains}) {
    const LessonState state{phase, 1};
    EXPECT_EQ(advance(state, 3, 2, false), state) << "it has been answered, or there is no question";
  }
  EXPECT_EQ(advance({}, 0, 1, true), LessonState{}) << "there is no lesson";
}

TEST(LessonFlow, BeginsWithItsQuestionAndItsViewsBesideThoseThatAreOn) {
  const Scenario scenario = read(kHead + kLesson);
  OperatorSettings settings;
  settings.views.paths = 1;
  beginLesson(scenario, true, settings);
  EXPECT_EQ(settings.lesson, kAsks);
  EXPECT_EQ(settings.lessonAnswers, 2u);
  TimeViews views;
  views.paths = views.clocks = views.myNow = 1;
  EXPECT_EQ(settings.views, views);
}

TEST(LessonFlow, ASessionThatEndsByItselfDoesNotAsk) {
  OperatorSettings settings;
  beginLesson(read(kHead + kLesson), false, settings);
  EXPECT_EQ(settings.lesson, (LessonState{LessonPhase::shows, 0}));
}

TEST(LessonFlow, ItExplainsWithTheOfferedEffectsAsTheyWereAtFirst) {
  const Scenario scenario = read(kHead + kLesson + "offers_effects = ['contraction', 'colour']\n");
  OperatorSettings settings;
  beginLesson(scenario, false, settings);
  ASSERT_EQ(settings.lesson.phase, LessonPhase::shows);
  settings.switches = {0, 0, 1, 1, 0};
  goOn(settings);
  ASSERT_EQ(settings.lesson.phase, LessonPhase::explains);
  EXPECT_EQ(settings.switches, (Switches{0, 1, 1, 0, 0})) << "what the lesson does not offer stays";
  settings.switches.contraction = 0;
  goOn(settings);
  EXPECT_EQ(settings.switches.contraction, 0) << "the scene keeps what was chosen";
}

TEST(LessonFlow, TheNextGameWithoutALessonHasNone) {
  OperatorSettings settings;
  beginLesson(read(kHead + kLesson), true, settings);
  beginLesson(read(kHead), true, settings);
  EXPECT_EQ(settings.lesson, LessonState{});
  EXPECT_EQ(settings.lessonAnswers, 0u);
}

TEST(LessonFlow, TheJournalHasTheAnswerInWords) {
  const LessonWords words = read(kHead + kLesson).lesson->words;
  EXPECT_EQ(answerText(words, {LessonPhase::shows, 2}), "Who stayed");
  EXPECT_EQ(answerText(words, {LessonPhase::shows, 0}), "(skipped)");
}

TEST(LessonFile, IsRead) {
  const Scenario scenario = read(kHead + kLesson);
  ASSERT_TRUE(scenario.lesson);
  const LessonWords& words = scenario.lesson->words;
  EXPECT_EQ(words.title, "Twins");
  EXPECT_EQ(words.question, "Who is older?");
  EXPECT_EQ(words.answers, (std::vector<std::string>{"Neither", "Who stayed"}));
  EXPECT_EQ(words.right, 1u);
  EXPECT_EQ(words.todo, "Go.");
  EXPECT_EQ(words.notice, "The clocks.");
  EXPECT_EQ(words.number, "10 s and 8 s.");
  EXPECT_FALSE(read(kHead).lesson);
}

TEST(LessonFile, LettersAreCountedNotBytes) {
  std::string letters;
  for (std::size_t i = 0; i < kLessonTextLetters; ++i) letters += "γ";
  std::string text = kHead + kLesson;
  text.replace(text.find("Go."), 3, letters);
  EXPECT_EQ(read(text).lesson->words.todo, letters);
  text.insert(text.find(letters), "γ");
  EXPECT_THROW(read(text), InputErrors);
}

TEST(LessonFile, TheTeachersExampleIsOne) {
  const std::string page = test::contentOf(CAROM_CONFIG_DIR "/../app/doc/teachers.md");
  const auto begins = page.find("```toml\n") + 8, ends = page.find("```", begins);
  ASSERT_LT(ends, page.size());
  const Scenario scenario = read(page.substr(begins, ends - begins));
  ASSERT_TRUE(scenario.lesson);
  EXPECT_EQ(scenario.lesson->words.answers.size(), 3u);
  const auto& flashes = scenario.billiard.flashes;
  const Vec3 eye_m = scenario.observer.position_m + Vec3(0.0, 0.0, 1.7);
  const double later_s =
      (glm::distance(eye_m, flashes.at(1).at.r_m) - glm::distance(eye_m, flashes.at(0).at.r_m)) /
      scenario.billiard.lightSpeed_m_s;
  EXPECT_NEAR(later_s, 1.41, 0.005) << scenario.lesson->words.number;
}

TEST(LessonFile, ItsPlanIsRead) {
  const LessonPlan plan = read(kHead + kLesson + R"(slowness = 4
[[lesson.observer]]
name = "at rest"
beta = [0, 0, 0]
[[lesson.observer]]
name = "0.5 c to the left"
beta = [-0.5, 0, 0]
[[lesson.stopwatch]]
name = "in your frame"
clock = "room"
starts = "tick 1"
stops = "tick 2"
stands_m = [0, 0, 0.1]
[[lesson.stopwatch]]
name = "seen"
clock = "seen"
place_m = [1, 2, 3]
[[lesson.counter]]
body = "clock"
flashes = "tick"
[[lesson.line]]
from_m = [0, -1, 0]
to_m = [0, 1, 0]
[[lesson.simultaneous]]
with = "tick 2"
beta = [0.8, 0, 0]
[board]
length_m = 3
width_m = 2
[[body]]
name = "clock"
at = { t_s = 0, r_m = [0, 0, 0] }
[[body.leg]]
beta = [0, 0, 0]
[[flash]]
name = "tick 1"
at_s = 1
r_m = [0.5, 0, 0]
[[flash]]
name = "tick 2"
at_s = 2
r_m = [-0.5, 0, 0]
)")
                              .lesson->plan;
  EXPECT_EQ(plan.interval.from_s, 0.5);
  EXPECT_EQ(plan.interval.until_s, 3.0);
  EXPECT_EQ(plan.interval.moment_s, 1.0);
  EXPECT_EQ(plan.interval.slowness, 4.0);
  ASSERT_EQ(plan.observers.size(), 2u);
  EXPECT_EQ(plan.observers[1].beta, Vec3(-0.5, 0.0, 0.0));
  ASSERT_EQ(plan.stopwatches.size(), 2u);
  EXPECT_EQ(plan.stopwatches[0].clock, StopwatchClock::room);
  EXPECT_EQ(plan.stopwatches[0].starts.t_s, 1.0);
  EXPECT_EQ(plan.stopwatches[0].stops.value().r_m, Vec3(-0.5, 0.0, 0.0));
  EXPECT_EQ(plan.stopwatches[0].stands_m.value(), Vec3(0.0, 0.0, 0.1));
  EXPECT_EQ(plan.stopwatches[1].seen_m, Vec3(1.0, 2.0, 3.0));
  EXPECT_EQ(plan.stopwatches[1].starts.t_s, 0.5) << "the lesson's beginning";
  ASSERT_EQ(plan.counters.size(), 1u);
  EXPECT_EQ(plan.counters[0].body, 1u);
  EXPECT_EQ(plan.counters[0].ticks.size(), 2u);
  ASSERT_EQ(plan.lines.size(), 1u);
  EXPECT_EQ(plan.lines[0].to_m, Vec3(0.0, 1.0, 0.0));
  ASSERT_EQ(plan.simultaneous.size(), 1u);
  EXPECT_EQ(plan.simultaneous[0].with.t_s, 2.0);
  EXPECT_EQ(plan.simultaneous[0].beta.value(), Vec3(0.8, 0.0, 0.0));
  EXPECT_EQ(plan.simultaneous[0].to_m, 1.5) << "to the cushion";
}

TEST(LessonFlow, AfterTheQuestionChoicesAreVelocities) {
  OperatorSettings settings;
  settings.lessonAnswers = 3;
  settings.lessonObservers = 2;
  EXPECT_FALSE(offersChoices(settings)) << "there is no lesson";
  settings.lesson = kAsks;
  EXPECT_TRUE(offersChoices(settings));
  EXPECT_TRUE(choose(settings, 3));
  EXPECT_EQ(settings.lesson, (LessonState{LessonPhase::shows, 3}));
  EXPECT_EQ(settings.lessonObserver, 0u) << "an answer is no velocity";
  EXPECT_TRUE(choose(settings, 2));
  EXPECT_EQ(settings.lessonObserver, 1u);
  EXPECT_FALSE(choose(settings, 2)) << "it is chosen already";
  for (const int none : {-1, 0, 3, 9}) EXPECT_FALSE(choose(settings, none)) << none;
  EXPECT_EQ(settings.lesson, (LessonState{LessonPhase::shows, 3})) << "the answer stays";
  settings.lessonExplainedFor = 0;
  EXPECT_TRUE(choose(settings, 4)) << "the wand's last button";
  EXPECT_EQ(settings.lesson, (LessonState{LessonPhase::explains, 3}));
  EXPECT_EQ(settings.lessonObserver, 0u) << "it explains with the velocity of its number";
  settings.lessonObservers = 0;
  EXPECT_FALSE(offersChoices(settings));
  EXPECT_FALSE(choose(settings, 1));
}

TEST(LessonFile, PulsesAreRead) {
  const Scenario scenario =
      read(kHead + "[[pulse]]\nname = 'light'\nat_s = 0.5\npath_m = [[0, 0, 1], [0, 0, 2], [0, 0, 1]]\n");
  ASSERT_EQ(scenario.pulses.size(), 1u);
  EXPECT_EQ(scenario.pulses[0].name, "light");
  EXPECT_EQ(scenario.pulses[0].at_s, 0.5);
  EXPECT_EQ(scenario.pulses[0].path_m, (std::vector<Vec3>{{0, 0, 1}, {0, 0, 2}, {0, 0, 1}}));
}

/// A lesson with one piece of it changed.
struct Change {
  const char* what;
  std::string before, after;
  int line, column;
  const char* words;
};
std::ostream& operator<<(std::ostream& out, const Change& change) { return out << change.what; }
class LessonFaults : public ::testing::TestWithParam<Change> {};

TEST_P(LessonFaults, ArePlacedAndExplained) {
  const Change& change = GetParam();
  std::string text =
      kHead + kLesson + "[[pulse]]\nname = 'light'\nat_s = 0\npath_m = [[0, 0, 1], [0, 0, 2]]\n";
  const auto at = text.find(change.before);
  ASSERT_NE(at, std::string::npos);
  text.replace(at, change.before.size(), change.after);
  test::expectExplained({change.what, text, change.line, change.column, change.words}, read);
}

INSTANTIATE_TEST_SUITE_P(
    OneByOne, LessonFaults,
    ::testing::Values(
        Change{"unknown key", "todo =", "tudo =", 7, 1, "unknown key 'tudo', expected 'todo'?"},
        Change{"nothing to notice", "notice = \"The clocks.\"\n", "", 3, 1, "notice is missing"},
        Change{"one answer", R"(["Neither", "Who stayed"])", R"(["Neither"])", 5, 11,
               "1 answer here, expected answers = [...] with two to four"},
        Change{"five answers", R"(["Neither", "Who stayed"])", R"(["1", "2", "3", "4", "5"])", 5, 11,
               "5 answers here"},
        Change{"no answers", "answers = [\"Neither\", \"Who stayed\"]\n", "", 3, 1, "0 answers here"},
        Change{"an answer that is none", R"("Neither")", "7", 5, 12, "answers[0] is a whole number"},
        Change{"an empty answer", R"("Neither")", "\"\"", 5, 12, "answers[0] is empty"},
        Change{"an answer too long", "Who stayed", std::string(kAnswerLetters + 1, 'w'), 5, 23,
               "answers[1] has 71 letters, expected 70 at most"},
        Change{"right beyond the answers", "right = 2", "right = 3", 6, 9, "right is 3, expected"},
        Change{"right before them", "right = 2", "right = 0", 6, 9, "right is 0, expected"},
        Change{"a question too long", "Who is older?", std::string(kLessonTextLetters + 1, 'w'), 4, 12,
               "question has 161 letters, expected 160 at most"},
        Change{"a number too long", "10 s", std::string(kLessonNumberLetters, 'w'), 9, 10,
               "number has 239 letters"},
        Change{"a view mistyped", "\"clocks\"", "\"clock\"", 10, 10,
               "there is no view 'clock', expected 'clocks'?"},
        Change{"no array of views", R"(["clocks", "my-now"])", "1", 10, 9, "views is a whole number"},
        Change{"a moment before what is shown", "moment_s = 1.0", "moment_s = 0.4", 13, 12,
               "moment_s is 0.4, which lies outside what the lesson shows, expected a time from 0.5 to 3"},
        Change{"a moment after it", "moment_s = 1.0", "moment_s = 3.1", 13, 12,
               "moment_s is 3.1, which lies"},
        Change{"no moment", "moment_s = 1.0\n", "", 3, 1, "moment_s is missing"},
        Change{"an end before the beginning", "until_s = 3.0", "until_s = 0.5", 12, 11,
               "until_s is 0.5, expected a time after from_s"},
        Change{"an end of no time at all", "until_s = 3.0", "until_s = 0.0", 12, 11,
               "until_s is 0, expected a number"},
        Change{"a lesson without end", "until_s = 3.0", "until_s = 1e6", 12, 11, "until_s is 1000000"},
        Change{"time that runs faster", "moment_s = 1.0", "moment_s = 1.0\nslowness = 0.5", 14, 12,
               "slowness is 0.5"},
        Change{"an observer of light", "[[pulse]]",
               "[[lesson.observer]]\nname = 'light'\nbeta = [1.0, 0, 0]\n[[pulse]]", 16, 8,
               "beta has magnitude 1"},
        Change{"a stopwatch of a flash that is not there", "[[pulse]]",
               "[[flash]]\nname = 'lamp'\nat_s = 1.0\nr_m = [0, 0, 0]\n[[lesson.stopwatch]]\nname = 'time'\n"
               "starts = 'lamb'\n[[pulse]]",
               20, 10, "there is no flash 'lamb', expected 'lamp'?"},
        Change{"a flash after the end", "[[pulse]]",
               "[[flash]]\nname = 'lamp'\nat_s = 4.0\nr_m = [0, 0, 0]\n[[lesson.stopwatch]]\nname = 'time'\n"
               "starts = 'lamp'\n[[pulse]]",
               20, 10, "the flash 'lamp' is at 4 s, expected one that the lesson shows, up to 3 s"},
        Change{"a counter on nothing", "[[pulse]]",
               "[[flash]]\nname = 'tick 1'\nat_s = 1.0\nr_m = [0, 0, 0]\n[[lesson.counter]]\nbody = 'clock'\n"
               "flashes = 'tick'\n[[pulse]]",
               19, 8, "there is no body 'clock'"},
        Change{"a pulse of one place", "[[0, 0, 1], [0, 0, 2]]", "[[0, 0, 1]]", 17, 10,
               "path_m has one place, expected two places at least"},
        Change{"a pulse that stays", "[0, 0, 2]", "[0, 0, 1]", 17, 10, "path_m[1] is the place before it"},
        Change{"a place of two numbers", "[0, 0, 2]", "[0, 0]", 17, 22,
               "path_m[1] has 2 values, expected a place [x, y, z]"},
        Change{"a place that is none", "[0, 0, 2]", "[0, 0, 'x']", 17, 29, "path_m[1][2] is a text"},
        Change{"a pulse without a way", "path_m = [[0, 0, 1], [0, 0, 2]]\n", "", 14, 1, "path_m is missing"},
        Change{"a pulse without a name", "name = 'light'\n", "", 14, 1, "name is missing"}));

TEST(LessonFile, NamesOfPulsesAreTheirOwn) {
  const std::string pulse = "[[pulse]]\nname = 'light'\nat_s = 0\npath_m = [[0, 0, 1], [0, 0, 2]]\n";
  EXPECT_THROW(read(kHead + pulse + pulse), InputErrors);
}

}  // namespace
}  // namespace carom
