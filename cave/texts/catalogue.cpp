#include <initializer_list>
#include <string>
#include <unordered_map>

#include <fmt/format.h>

#include "cave/texts/texts.h"

namespace carom::texts {
namespace {

void addText(std::vector<Entry>& all, const char* name, Text text, const char* values, const char* seen) {
  all.push_back({name, text, *values ? values : seen});
}

void addList(std::vector<Entry>& all, const char* name, std::initializer_list<const char*> words,
             const char* seen) {
  int number = 0;
  for (const char* const english : words)
    all.push_back({fmt::format("{} {}", name, ++number), Text(all.size(), english), seen});
}

std::vector<Entry> allTexts() {
  std::vector<Entry> all{{"", {}, ""}};
#define CAROM_WORDS(word) #word
#define CAROM_NAME(group, name) CAROM_WORDS(group) "." #name
#define TEXT(name, english, ...) \
  addText(all, CAROM_NAME(GROUP, name), Text(all.size(), english), "" __VA_ARGS__, SEEN);
#define PLURAL(name, one, many, ...) \
  addText(all, CAROM_NAME(GROUP, name), Text(all.size(), one, many), "" __VA_ARGS__, SEEN);
#define TEXTS(name, ...) addList(all, CAROM_NAME(GROUP, name), {__VA_ARGS__}, SEEN);
#include "cave/texts/catalogue/all.inc"
#undef TEXT
#undef PLURAL
#undef TEXTS
#undef CAROM_NAME
#undef CAROM_WORDS
  return all;
}

}  // namespace

const std::vector<Entry>& catalogue() {
  static const std::vector<Entry> all = allTexts();
  return all;
}

std::map<std::string, std::string> pageWords(std::string_view group) {
  std::map<std::string, std::string> words;
  for (const Entry& entry : catalogue()) {
    const std::string_view name = entry.name;
    if (!name.starts_with(group) || name.size() < group.size() + 3 || name[group.size()] != '.') continue;
    const std::string_view own = name.substr(group.size() + 1);
    const bool isConstant = own[0] == 'k' && own[1] >= 'A' && own[1] <= 'Z';
    if (!isConstant) words.emplace(own, entry.text.words());
  }
  return words;
}

Text textNamed(std::string_view name) {
  static const auto byName = [] {
    std::unordered_map<std::string_view, Text> texts;
    for (const Entry& entry : catalogue()) texts.emplace(entry.name, entry.text);
    return texts;
  }();
  const auto found = byName.find(name);
  return found == byName.end() ? Text() : found->second;
}

}  // namespace carom::texts
