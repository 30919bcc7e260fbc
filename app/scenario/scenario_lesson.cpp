#include "app/scenario/scenario_lesson.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string_view>
#include <vector>

#include "cave/record/effects.h"

namespace carom {
namespace {

/// Returns the length in letters, not in bytes.
std::size_t lettersOf(std::string_view text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

void checkLength(const TomlTable& table, FilePlace place, std::string_view name, std::string_view text,
                 std::size_t most) {
  const std::size_t letters = lettersOf(text);
  if (letters <= most) return;
  table.fault(place, fmt::format("{} has {} letters, expected {} at most, which a wall can show", name,
                                 letters, most));
}

std::vector<std::string> readAnswers(const TomlTable& table) {
  const FileKey& declared = table.declared("answers");
  std::vector<std::string> answers;
  for (const PlacedText& answer : table.texts("answers")) {
    checkLength(table, answer.place, fmt::format("answers[{}]", answers.size()), answer.text,
                declared.letters);
    answers.push_back(answer.text);
  }
  if (answers.size() < declared.fewest || answers.size() > declared.most) {
    table.fault("answers",
                fmt::format("a lesson has {} answer{} here, expected answers = [...] with two to four",
                            answers.size(), answers.size() == 1 ? "" : "s"));
  }
  return answers;
}

}  // namespace

std::string readWords(const TomlTable& table, std::string_view key) {
  std::string text = table.text(key);
  checkLength(table, table.place(key), key, text, table.declared(key).letters);
  return text;
}

namespace {

/// Reads the names of some rows. Returns their numbers; records a fault for each name that no row has.
template <typename Rows>
std::vector<std::size_t> readNames(const TomlTable& table, std::string_view key, std::string_view what,
                                   const Rows& rows) {
  std::vector<std::string> names;
  for (const auto& row : rows) names.emplace_back(row.name);
  std::vector<std::size_t> numbers;
  for (const PlacedText& given : table.texts(key)) {
    const auto found = std::find(names.begin(), names.end(), given.text);
    if (found != names.end()) {
      numbers.push_back(static_cast<std::size_t>(found - names.begin()));
      continue;
    }
    if (given.text.empty()) continue;  // has been reported
    const auto nearest = nearestWord(given.text, names);
    table.fault(given.place, fmt::format("there is no {} '{}', expected {}", what, given.text,
                                         nearest ? fmt::format("'{}'?", *nearest)
                                                 : fmt::format("one of {}", fmt::join(names, ", "))));
  }
  return numbers;
}

}  // namespace

TimeViews readViews(const TomlTable& table, std::string_view key) {
  TimeViews views;
  for (const std::size_t row : readNames(table, key, "view", kNamedViews)) views.*kNamedViews[row].value = 1;
  return views;
}

namespace {

/// Returns the puck of this name; records a fault if there is none.
std::size_t puckNamed(const TomlTable& table, FilePlace place, const std::string& name,
                      const std::vector<Puck>& pucks) {
  const auto found = std::ranges::find(pucks, name, &Puck::name);
  if (found != pucks.end()) return static_cast<std::size_t>(found - pucks.begin());
  table.fault(place, fmt::format("there is no puck '{}', expected the name of a [[puck]]", name));
  return 0;
}

TaskGoal readGoal(const TomlTable& table, const std::vector<Puck>& pucks) {
  using Kind = TaskGoal::Kind;
  TaskGoal goal;
  int goals = 0;
  for (const std::string_view key : {"hit", "cushions", "hit-both", "looks-faster", "clock-reads"})
    goals += table.has(key) ? 1 : 0;
  if (goals != 1) {
    table.fault(table.place(), fmt::format("the goal has {} keys, expected one of hit, cushions, hit-both, "
                                           "looks-faster and clock-reads",
                                           goals));
  }
  const auto one = [&](std::string_view key, Kind kind) {
    if (!table.has(key)) return;
    goal = {kind, {puckNamed(table, table.place(key), table.text(key), pucks)}, 0};
  };
  const auto two = [&](std::string_view key, Kind kind) {
    if (!table.has(key)) return;
    goal = {kind, {}, 0};
    for (const PlacedText& name : table.texts(key))
      goal.pucks.push_back(puckNamed(table, name.place, name.text, pucks));
    if (goal.pucks.size() != 2 || goal.pucks[0] == goal.pucks[1])
      table.fault(key, fmt::format("expected {} = [...] with the names of two pucks", key));
    goal.pucks.resize(2);
  };
  one("hit", Kind::hit);
  one("looks-faster", Kind::looksFaster);
  two("hit-both", Kind::hitBoth);
  two("clock-reads", Kind::clockReads);
  if (table.has("cushions")) goal = {Kind::cushions, {}, static_cast<std::size_t>(table.integer("cushions"))};
  return goal;
}

}  // namespace

std::vector<Task> readTasks(const TomlTable& root, const std::vector<Puck>& pucks) {
  std::vector<Task> tasks;
  for (const TomlTable& table : root.tables("task")) {
    Task task;
    task.name = readWords(table, "name");
    task.text = readWords(table, "text");
    if (const auto goal = table.requiredTable("goal")) task.goal = readGoal(*goal, pucks);
    task.world = static_cast<TaskWorld>(table.choice("world"));
    task.stars_j = table.numbers<2>("stars_j");
    if (task.stars_j[1] < task.stars_j[0]) {
      table.fault("stars_j", fmt::format("stars_j is [{}, {}], expected the smaller energy first",
                                         task.stars_j[0], task.stars_j[1]));
    }
    const bool isTwice = std::ranges::find(tasks, task.name, &Task::name) != tasks.end();
    if (isTwice)
      table.fault("name", fmt::format("there is another task '{}', expected a name of its own", task.name));
    tasks.push_back(std::move(task));
  }
  return tasks;
}

Lesson readLesson(const TomlTable& table, const std::string& title, const LessonGame& game) {
  Lesson lesson;
  LessonWords& words = lesson.words;
  words.title = title;
  words.question = readWords(table, "question");
  words.answers = readAnswers(table);
  const FileKey& declared = table.declared("answers");
  const bool offered = words.answers.size() >= declared.fewest && words.answers.size() <= declared.most;
  const std::size_t answers = offered ? words.answers.size() : kMostAnswers;
  words.right = static_cast<std::size_t>(table.integer("right", static_cast<int>(answers)) - 1);
  words.todo = readWords(table, "todo");
  words.notice = readWords(table, "notice");
  words.number = readWords(table, "number");
  if (table.has("predicted_wrongly")) words.predictedWrongly = readWords(table, "predicted_wrongly");
  if (table.has("go_on_with")) words.goOnWith = readWords(table, "go_on_with");
  lesson.views = readViews(table);
  lesson.explains = readViews(table, "explains_views");
  lesson.plan = readLessonPlan(table, game);
  for (const std::size_t row : readNames(table, "offers_effects", "effect", kNamedSwitches))
    lesson.plan.effects.push_back(static_cast<std::uint8_t>(row));
  return lesson;
}

}  // namespace carom
