#include "app/files/scenario_lesson.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string_view>
#include <vector>

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

TimeViews readViews(const TomlTable& table) {
  std::vector<std::string> names;
  for (const NamedView& view : kNamedViews) names.emplace_back(view.name);
  TimeViews views;
  for (const PlacedText& given : table.texts("views")) {
    const auto found = std::find(names.begin(), names.end(), given.text);
    if (found != names.end()) {
      views.*kNamedViews[static_cast<std::size_t>(found - names.begin())].value = 1;
      continue;
    }
    if (given.text.empty()) continue;  // has been reported
    const auto nearest = nearestWord(given.text, names);
    table.fault(given.place, fmt::format("there is no view '{}', expected {}", given.text,
                                         nearest ? fmt::format("'{}'?", *nearest)
                                                 : fmt::format("one of {}", fmt::join(names, ", "))));
  }
  return views;
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
  lesson.views = readViews(table);
  lesson.plan = readLessonPlan(table, game);
  return lesson;
}

}  // namespace carom
