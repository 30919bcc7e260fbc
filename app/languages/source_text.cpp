#include "app/languages/source_text.h"

namespace carom {

bool standsOnPlates(std::string_view name) {
  return name.starts_with("plate.") || name.find(" lesson label ") != std::string_view::npos;
}

std::vector<SourceText> sourceTexts(std::span<const texts::Entry> catalogue) {
  std::vector<SourceText> all;
  for (const texts::Entry& entry : catalogue) {
    const std::string english = entry.text.english();
    const char* many = entry.text.englishOfMany();
    if (english.empty()) continue;
    all.push_back({entry.name, english, many ? many : "", entry.note, {}});
  }
  return all;
}

}  // namespace carom
