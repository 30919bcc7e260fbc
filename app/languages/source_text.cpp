#include "app/languages/source_text.h"

namespace carom {

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
