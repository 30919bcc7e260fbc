#include "app/tools/answers.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <map>
#include <memory>
#include <tuple>

#include "app/journal/session_file.h"
#include "app/tables/csv_text.h"
#include "engine/base/log.h"
#include "engine/base/whole_file.h"

namespace carom {
namespace {

/// Returns whether an answer is the right one of a lesson; none if the lesson does not offer it.
std::optional<bool> isRight(const std::optional<Lesson>& lesson, const std::string& answer) {
  if (!lesson) return {};
  const std::vector<std::string>& answers = lesson->words.answers;
  const auto found = std::find(answers.begin(), answers.end(), answer);
  if (found == answers.end()) return {};
  return static_cast<std::size_t>(found - answers.begin()) == lesson->words.right;
}

std::string csvOf(const std::vector<AnswerRow>& rows) {
  std::string text = "lesson,question,answer,right,attempt,seconds,viewer,group,frame\n";
  for (const AnswerRow& row : rows) {
    text += fmt::format("{},{},{},{},{},{:.3f},{},{},{}\n", csvField(row.lesson), csvField(row.question),
                        csvField(row.answer), row.isRight ? (*row.isRight ? "1" : "0") : "", row.attempt,
                        row.seconds, csvField(row.viewer), row.group, row.frame);
  }
  return text;
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

}  // namespace

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
  CLI::App* command = app.add_subcommand(
      "answers",
      "List what visitors answered to the questions of lessons: right or wrong, which attempt, how soon");
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
    const std::vector<AnswerRow> rows = answersOf(line->files);
    WholeFile out(line->csv.value_or("-"));
    out.commit(line->csv ? csvOf(rows) : tableOf(rows));
    status = 0;
  });
}

}  // namespace carom
