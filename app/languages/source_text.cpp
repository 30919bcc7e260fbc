#include "app/languages/source_text.h"

namespace carom {

std::vector<SourceText> sourceTexts(std::span<const texts::Entry> catalogue) {
  std::vector<SourceText> all;
  for (const texts::Entry& entry : catalogue) {
    all.push_back({.context = entry.name,
                   .english = entry.english,
                   .plural = entry.plural ? entry.plural : "",
                   .note = entry.note ? entry.note : "",
                   .reference = {}});
  }
  return all;
}

}  // namespace carom
