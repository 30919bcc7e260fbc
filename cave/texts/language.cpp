#include "cave/texts/language.h"

namespace carom::texts {
namespace {

constexpr Entry kEntries[] = {
#include "cave/texts/language_entries.inc"
};

}  // namespace

std::span<const Entry> catalogue() { return kEntries; }

std::size_t pluralForm(std::string_view code, double n) {
  if (code == "ja") return 0;
  if (code == "fr") return n >= 2.0 ? 1 : 0;
  return n == 1.0 ? 0 : 1;
}

std::size_t pluralForms(std::string_view code) { return code == "ja" ? 1 : 2; }

}  // namespace carom::texts
