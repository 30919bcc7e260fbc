#include "cave/texts/language.h"

namespace carom::texts {
namespace {

struct Row {
  const char *name, *english, *plural, *note;
};

constexpr Row kRows[] = {
#include "cave/texts/language_entries.inc"
};

}  // namespace

const std::vector<Entry>& catalogue() {
  static const std::vector<Entry> all = [] {
    std::vector<Entry> entries{{"", CatalogueText(0, "", nullptr), ""}};
    for (const Row& row : kRows)
      entries.push_back({row.name, CatalogueText(entries.size(), row.english, row.plural), row.note});
    return entries;
  }();
  return all;
}

std::size_t pluralForm(std::string_view code, double n) {
  if (code == "ja") return 0;
  if (code == "fr") return n >= 2.0 ? 1 : 0;
  return n == 1.0 ? 0 : 1;
}

std::size_t pluralForms(std::string_view code) { return code == "ja" ? 1 : 2; }

}  // namespace carom::texts
