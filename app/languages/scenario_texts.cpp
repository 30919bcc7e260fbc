#include "app/languages/scenario_texts.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <unordered_set>
#include <utility>

#include "app/file_keys/scenario_keys.h"
#include "app/languages/letters.h"
#include "app/toml/config_folder.h"
#include "app/toml/toml_file.h"
#include "cave/texts/numbered_name.h"
#include "engine/text/code_points.h"

namespace carom {
namespace {

/// Returns whether there is something to translate: two letters in a row.
bool hasWords(std::string_view text) {
  const std::u32string signs = codePointsOf(text);
  return std::adjacent_find(signs.begin(), signs.end(),
                            [](char32_t a, char32_t b) { return isLetter(a) && isLetter(b); }) != signs.end();
}

/// Gathers the texts of a file under their names, in the order in which they stand there.
class Gathered {
 public:
  explicit Gathered(const std::filesystem::path& file) : file_(file.filename().string()) {}

  /// Adds a text unless there is none, or one of this name.
  void add(const std::string& name, const std::string& text, FilePlace at) {
    if (!hasWords(text) || !names_.insert(name).second) return;
    texts_.emplace(std::pair(at.line, at.column),
                   SourceText{.context = file_ + ' ' + name,
                              .english = text,
                              .plural = {},
                              .note = {},
                              .reference = fmt::format("{}:{}", file_, at.line),
                              .hasValues = false});
  }
  /// Adds the text of a key, if the table has it.
  void add(const TomlTable& table, std::string_view key, const std::string& name) {
    if (table.has(key)) add(name, table.text(key, ""), table.place(key));
  }
  /// Adds a key of each of some tables, which are counted from 1.
  void addEach(const std::vector<TomlTable>& tables, std::string_view key, const std::string& name) {
    for (std::size_t i = 0; i < tables.size(); ++i)
      add(tables[i], key, fmt::format("{} {} {}", name, i + 1, key));
  }
  /// Adds the names of things of a kind.
  void addNames(const std::vector<TomlTable>& things) {
    for (const TomlTable& thing : things) {
      if (!thing.has("name")) continue;
      const std::string whole = thing.text("name", "");
      const std::string name(texts::nameWithoutNumber(whole));
      add("name " + name, name, thing.place("name"));
    }
  }

  std::vector<SourceText> all() const {
    std::vector<SourceText> texts;
    for (const auto& [at, text] : texts_) texts.push_back(text);
    return texts;
  }

 private:
  std::string file_;
  std::multimap<std::pair<int, int>, SourceText> texts_;  // by line and column
  std::unordered_set<std::string> names_;
};

void addLesson(const TomlTable& lesson, Gathered& texts) {
  texts.add(lesson, "question", "lesson question");
  const std::vector<PlacedText> answers = lesson.texts("answers");
  for (std::size_t i = 0; i < answers.size(); ++i)
    texts.add(fmt::format("lesson answer {}", i + 1), answers[i].text, answers[i].place);
  for (const char* key : {"todo", "notice", "number", "predicted_wrongly", "go_on_with"})
    texts.add(lesson, key, fmt::format("lesson {}", key));
  texts.addEach(lesson.tables("observer"), "name", "lesson observer");
  texts.addEach(lesson.tables("stopwatch"), "name", "lesson stopwatch");
  texts.addEach(lesson.tables("label"), "text", "lesson label");
}

}  // namespace

std::vector<SourceText> scenarioTexts(const std::filesystem::path& path) {
  const TomlFile file(path, scenarioKeys());
  const TomlTable& root = file.root();
  Gathered texts(path);
  texts.add(root, "title", "title");
  if (const auto lesson = root.table("lesson")) addLesson(*lesson, texts);
  const std::vector<TomlTable> captions = root.tables("caption"), tasks = root.tables("task");
  for (std::size_t i = 0; i < captions.size(); ++i) {
    for (const char* key : {"text", "hand_text"})
      texts.add(captions[i], key, fmt::format("caption {} {}", i + 1, key));
  }
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    for (const char* key : {"name", "text"}) texts.add(tasks[i], key, fmt::format("task {} {}", i + 1, key));
  }
  for (const char* kind : {"puck", "body", "flash", "pulse"}) texts.addNames(root.tables(kind));
  return texts.all();
}

std::vector<SourceText> shippedScenarioTexts() {
  std::vector<SourceText> all;
  for (const std::string& name : shippedNames("scenarios")) {
    const auto file = configFolder() / "scenarios" / (name + ".toml");
    if (std::filesystem::is_regular_file(file))  // a schema for editors may lie beside them
      std::ranges::move(scenarioTexts(file), std::back_inserter(all));
  }
  return all;
}

}  // namespace carom
