// `carom answers`: two groups of visitors at one lesson, whose answers stand in one session file.
#include "app/record_tools/answers.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "app/journal_frames.h"
#include "app/program.h"
#include "app/scenario/scenario.h"
#include "places.h"

namespace carom {
namespace {

using namespace test;

class Answers : public testing::Test {
 protected:
  /// Writes a game of `count` frames from frame `first` on, ten a second, that asks in its frames from `asks`
  /// to `given` and has the answer then.
  struct Asked {
    std::uint64_t asks, given;
    std::string answer, viewer;
  };
  void play(bool isAnother, std::uint64_t first, std::uint64_t count, const std::vector<Asked>& asked,
            bool thenNext) {
    SessionFacts facts = kFacts;
    facts.scenario = scenario_;
    facts.scenarioText = contentOf(scenario_);
    facts.viewers = {"anna", "ben"};
    facts.isAnotherGame = isAnother;
    Journal journal(file_, facts, isAnother);
    const Lesson lesson = *readScenario(scenario_).lesson;
    for (std::uint64_t number = first; number < first + count; ++number) {
      FrameState state = frameOf(number - first);
      state.record.number = number;
      state.record.display_s = 0.1 * static_cast<double>(number);
      state.record.lesson.phase = LessonPhase::shows;
      for (const Asked& question : asked) {
        if (question.asks <= number && number < question.given) state.record.lesson.phase = LessonPhase::asks;
        if (question.given == number)
          journal.addAnswer(number, lesson.words.title, lesson.words.question, question.answer,
                            question.viewer == "ben" ? 1 : 0);
      }
      if (thenNext && number + 1 == first + count) journal.addInput(number, "visitor", "");
      journal.add(state, std::vector<HeadEstimate>(2), {});
    }
  }

  TemporaryFolder folder_;
  const std::filesystem::path file_ = folder_ / "class.db";
  const std::filesystem::path scenario_ = CAROM_CONFIG_DIR "/scenarios/comes-and-goes.toml";
};

TEST_F(Answers, HaveTheirAttemptTimeViewerAndGroup) {
  const std::vector<std::string> offered = readScenario(scenario_).lesson->words.answers;
  play(false, 0, 100,
       {{0, 25, offered[0], "anna"}, {50, 62, offered[1], "anna"}, {70, 75, offered[1], "ben"}}, true);
  play(true, 100, 50, {{100, 117, offered[2], "anna"}, {130, 140, "what is no answer", "anna"}}, false);
  const std::vector<AnswerRow> rows = answersOf({file_});
  ASSERT_EQ(rows.size(), 5);
  const std::vector<std::optional<bool>> right{false, true, true, false, std::nullopt};
  const double seconds[]{2.5, 1.2, 0.5, 1.7, 1.0};
  const std::size_t attempts[]{1, 2, 1, 1, 2}, groups[]{1, 1, 1, 2, 2};
  const std::uint64_t frames[]{25, 62, 75, 117, 140};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(rows[i].isRight, right[i]) << i;
    EXPECT_NEAR(rows[i].seconds, seconds[i], 1e-9) << i;
    EXPECT_EQ(rows[i].attempt, attempts[i]) << i;
    EXPECT_EQ(rows[i].group, groups[i]) << i;
    EXPECT_EQ(rows[i].frame, frames[i]) << i;
    EXPECT_EQ(rows[i].viewer, i == 2 ? "ben" : "anna") << i;
  }
  EXPECT_EQ(answersOf({file_, file_}).back().group, 4) << "the second file's groups come after the first's";
}

TEST_F(Answers, AreAFileAndASummary) {
  const std::vector<std::string> offered = readScenario(scenario_).lesson->words.answers;
  play(false, 0, 60, {{0, 25, offered[0], "anna"}, {30, 40, offered[1], "ben"}}, false);
  const auto csv = runCarom(folder_, {"answers", file_.string(), "--csv", "-"});
  EXPECT_EQ(csv.status, 0) << csv.err;
  EXPECT_EQ(csv.out.substr(0, csv.out.find('\n')),
            "lesson,question,answer,right,attempt,seconds,viewer,group,frame");
  EXPECT_NE(csv.out.find(",At the same speed both ways,0,1,2.500,anna,1,25\n"), std::string::npos) << csv.out;
  EXPECT_NE(
      csv.out.find(",\"Slower when receding, faster than light when approaching\",1,1,1.000,ben,1,40\n"),
      std::string::npos)
      << csv.out;
  const auto summary = runCarom(folder_, {"answers", file_.string()});
  EXPECT_NE(summary.out.find("   1  right  Slower when receding"), std::string::npos) << summary.out;
  EXPECT_NE(summary.out.find("first attempts: 2; 1.8 s in the mean"), std::string::npos) << summary.out;
  const auto missing = runCarom(folder_, {"answers", (folder_ / "none.db").string()});
  EXPECT_EQ(missing.status, 1);
  EXPECT_NE(missing.err.find("none.db"), std::string::npos) << missing.err;
}

/// A class of seven votes on a lesson, then four discuss it and vote again.
TEST_F(Answers, CountTheVotesOfAClass) {
  const Lesson lesson = *readScenario(scenario_).lesson;
  {
    SessionFacts facts = kFacts;
    facts.scenario = scenario_;
    facts.scenarioText = contentOf(scenario_);
    facts.hasClass = true;
    Journal journal(file_, facts, false);
    const auto vote = [&](int round, int phone, std::size_t answer) {
      journal.addVote(1, {round, lesson.words.title, lesson.words.question, "phone" + std::to_string(phone),
                          lesson.words.answers[answer], 2, 3.0, ""});
    };
    for (const int phone : {1, 2, 3, 4, 5, 6, 7}) vote(1, phone, phone < 6 ? 0 : lesson.words.right);
    for (const int phone : {1, 2, 3, 4}) vote(2, phone, lesson.words.right);
    for (const std::uint64_t number : {0, 1, 2})
      journal.add(frameOf(number), std::vector<HeadEstimate>(1), {});
  }
  const std::vector<VotedQuestion> questions = votesOf({file_});
  ASSERT_EQ(questions.size(), 1U);
  EXPECT_EQ(questions[0].all, (std::array<std::size_t, 2>{7, 4}));
  ASSERT_EQ(questions[0].answers.size(), lesson.words.answers.size());
  EXPECT_EQ(questions[0].answers[0].count, (std::array<std::size_t, 2>{5, 0}));
  EXPECT_EQ(questions[0].answers[lesson.words.right].count, (std::array<std::size_t, 2>{2, 4}));
  EXPECT_EQ(questions[0].answers[lesson.words.right].isRight, true);
  const auto printed = runCarom(folder_, {"answers", file_.string()});
  EXPECT_NE(printed.out.find("       5       -  wrong  " + lesson.words.answers[0]), std::string::npos)
      << printed.out;
  EXPECT_NE(printed.out.find("       2       -  right  "), std::string::npos)
      << "four votes have no distribution: " << printed.out;
  EXPECT_NE(printed.out.find("  phones that voted: 7, then 4\n"), std::string::npos) << printed.out;
  EXPECT_EQ(printed.out.find("nobody was asked"), std::string::npos) << printed.out;
  // One row a vote, of the first round alone: four votes tell what single students answered.
  const auto csv = runCarom(folder_, {"answers", file_.string(), "--csv", "-"});
  EXPECT_EQ(std::count(csv.out.begin(), csv.out.end(), '\n'), 1 + 7) << csv.out;
  EXPECT_NE(csv.out.find(",0,1,3.000,phone1,,1\n"), std::string::npos) << csv.out;
  EXPECT_NE(csv.out.find(",1,1,3.000,phone7,,1\n"), std::string::npos) << csv.out;
}

}  // namespace
}  // namespace carom
