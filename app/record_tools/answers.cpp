#include "app/record_tools/answers.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iterator>
#include <map>
#include <memory>
#include <tuple>

#include "app/journal/session_file.h"
#include "app/tables/csv_table.h"
#include "engine/text/log.h"
#include "engine/text/whole_file.h"

namespace carom {
namespace {

/// With fewer votes on a question a distribution would tell what single students answered.
constexpr std::size_t kLeast = 5;

/// Returns whether an answer is the right one of a lesson; none if the lesson does not offer it.
std::optional<bool> isRight(const std::optional<Lesson>& lesson, const std::string& answer) {
  if (!lesson) return {};
  const std::vector<std::string>& answers = lesson->words.answers;
  const auto found = std::find(answers.begin(), answers.end(), answer);
  if (found == answers.end()) return {};
  return static_cast<std::size_t>(found - answers.begin()) == lesson->words.right;
}

const std::vector<CsvColumn<AnswerRow>>& columns() {
  static const std::vector<CsvColumn<AnswerRow>> kColumns{
      {"lesson", [](const AnswerRow& row) { return row.lesson; }},
      {"question", [](const AnswerRow& row) { return row.question; }},
      {"answer", [](const AnswerRow& row) { return row.answer; }},
      {"right", [](const AnswerRow& row) { return row.isRight; }},
      {"attempt", [](const AnswerRow& row) { return row.attempt; }},
      {"seconds", [](const AnswerRow& row) { return fmt::format("{:.3f}", row.seconds); }},
      {"viewer", [](const AnswerRow& row) { return row.viewer; }},
      {"group", [](const AnswerRow& row) { return row.group > 0 ? std::optional(row.group) : std::nullopt; }},
      {"frame", [](const AnswerRow& row) { return row.frame; }}};
  return kColumns;
}

/// How often each answer was given at a first attempt.
struct Question {
  std::map<std::string, std::size_t> answers;
  std::map<std::string, std::optional<bool>> right;
  std::size_t count = 0;
  double seconds = 0.0;
};

std::string tableOf(const std::vector<AnswerRow>& rows) {
  std::map<std::pair<std::string, std::string>, Question> questions;
  std::vector<std::pair<std::string, std::string>> order;
  for (const AnswerRow& row : rows) {
    const std::pair key{row.lesson, row.question};
    if (!questions.contains(key)) order.push_back(key);
    Question& question = questions[key];
    if (row.attempt > 1) continue;
    ++question.answers[row.answer];
    question.right[row.answer] = row.isRight;
    ++question.count;
    question.seconds += row.seconds;
  }
  std::string text = rows.empty() ? "no answers: nobody was asked\n" : "";
  for (const auto& key : order) {
    const Question& question = questions[key];
    text += fmt::format("{}\n  {}\n", key.first, key.second);
    for (const auto& [answer, count] : question.answers) {
      const std::optional<bool> right = question.right.at(answer);
      text += fmt::format("  {:>4}  {:<6} {}\n", count, right ? (*right ? "right" : "wrong") : "", answer);
    }
    if (question.count > 0)
      text += fmt::format("  first attempts: {}; {:.1f} s in the mean\n\n", question.count,
                          question.seconds / static_cast<double>(question.count));
  }
  return text;
}

/// Returns the votes of each question, answer by answer.
std::string tableOf(const std::vector<VotedQuestion>& questions) {
  std::string text;
  for (const VotedQuestion& question : questions) {
    text += fmt::format("{}\n  {}\n  vote 1  vote 2\n", question.lesson, question.question);
    for (const VotedQuestion::Answer& answer : question.answers) {
      const auto count = [&](std::size_t vote) {
        return question.all[vote] < kLeast ? std::string("-") : std::to_string(answer.count[vote]);
      };
      text += fmt::format("  {:>6}  {:>6}  {:<6} {}\n", count(0), count(1),
                          answer.isRight ? (*answer.isRight ? "right" : "wrong") : "", answer.words);
    }
    text += fmt::format("  phones that voted: {}, then {}\n\n", question.all[0], question.all[1]);
  }
  return text;
}

/// Returns the question of the list with these words, added to it if it is new, with the answers of its
/// lesson.
VotedQuestion& questionIn(std::vector<VotedQuestion>& questions, const ClassVote& vote,
                          const SessionGame& game) {
  const auto known = std::find_if(questions.begin(), questions.end(), [&](const VotedQuestion& one) {
    return one.lesson == vote.lesson && one.question == vote.question;
  });
  if (known != questions.end()) return *known;
  VotedQuestion& added = questions.emplace_back();
  added.lesson = vote.lesson;
  added.question = vote.question;
  const std::optional<Lesson> lesson = readScenario(game.scenario, game.scenarioText).lesson;
  if (!lesson || lesson->words.question != vote.question) return added;
  for (const std::string& answer : lesson->words.answers)
    added.answers.push_back({answer, isRight(lesson, answer)});
  return added;
}

}  // namespace

std::vector<VotedQuestion> votesOf(const std::vector<std::filesystem::path>& files) {
  std::vector<VotedQuestion> questions;
  for (const std::filesystem::path& file : files) {
    const SessionFile session(file);
    for (const CountedVote& counted : session.votes()) {
      const ClassVote& vote = counted.vote;
      if (vote.round < 1 || vote.round > 2) continue;
      VotedQuestion& question = questionIn(questions, vote, session.games()[counted.game]);
      const auto round = static_cast<std::size_t>(vote.round - 1);
      auto answer = std::find_if(question.answers.begin(), question.answers.end(),
                                 [&](const VotedQuestion::Answer& one) { return one.words == vote.answer; });
      if (answer == question.answers.end())
        answer = question.answers.insert(question.answers.end(), {vote.answer, std::nullopt});
      ++answer->count[round];
      ++question.all[round];
      constexpr std::size_t kClass = 0;
      question.votes.push_back({vote.lesson, vote.question, vote.answer, answer->isRight, round + 1,
                                vote.seconds, vote.token, kClass, counted.frame});
    }
  }
  return questions;
}

std::vector<AnswerRow> answersOf(const std::vector<std::filesystem::path>& files) {
  std::vector<AnswerRow> rows;
  std::size_t groupsBefore = 0;
  for (const std::filesystem::path& file : files) {
    std::map<std::tuple<std::size_t, std::string, std::string, std::string>, std::size_t> attempts;
    std::map<std::size_t, std::optional<Lesson>> lessons;  // by game
    std::size_t groups = 0;
    const SessionFile session(file);
    for (const GivenAnswer& given : session.answers()) {
      const SessionGame& game = session.games()[given.game];
      if (!lessons.contains(given.game))
        lessons[given.game] = readScenario(game.scenario, game.scenarioText).lesson;
      groups = std::max(groups, given.group);
      rows.push_back({given.lesson, given.question, given.answer, isRight(lessons[given.game], given.answer),
                      ++attempts[{given.group, given.viewer, given.lesson, given.question}], given.seconds,
                      given.viewer, groupsBefore + given.group, given.frame});
    }
    groupsBefore += groups;
  }
  return rows;
}

void addAnswers(CLI::App& app, int& status) {
  struct Line {
    std::vector<std::filesystem::path> files;
    std::optional<std::filesystem::path> csv;
  };
  CLI::App* command = app.add_subcommand("answers",
                                         "List what visitors answered to the questions of lessons: right or "
                                         "wrong, which attempt, how soon; and how "
                                         "a class voted by phone, before and after it discussed");
  const auto line = std::make_shared<Line>();
  command->add_option("FILE", line->files, "Session files")->required();
  command
      ->add_option(
          "--csv", line->csv,
          "Write the answers to this file, one row each; - is standard output. By default, how often each "
          "answer was given is printed")
      ->type_name("FILE");
  command->footer(
      "Examples:\n  carom answers class-7.db\n  carom answers monday.db tuesday.db --csv answers.csv");
  command->callback([line, &status] {
    std::vector<AnswerRow> rows = answersOf(line->files);
    WholeFile out(line->csv.value_or("-"));
    const std::vector<VotedQuestion> votes = votesOf(line->files);
    const std::string visitors = rows.empty() && !votes.empty() ? "" : tableOf(rows);
    for (const VotedQuestion& question : votes) {
      std::copy_if(question.votes.begin(), question.votes.end(), std::back_inserter(rows),
                   [&](const AnswerRow& vote) { return question.all[vote.attempt - 1] >= kLeast; });
    }
    out.commit(line->csv ? csvText(columns(), rows) : visitors + tableOf(votes));
    status = 0;
  });
}

}  // namespace carom
