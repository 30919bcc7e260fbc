#include "app/stage/shared_languages.h"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "app/languages/language_files.h"
#include "app/stage/all_ranks.h"
#include "cave/gl/glyph_bitmap.h"
#include "cave/gl/gui.h"
#include "cave/gl/letter_atlas.h"
#include "engine/text/code_points.h"

namespace carom {
namespace {

using Languages = std::vector<std::shared_ptr<const texts::Language>>;

/// Returns the letters beyond ASCII of these words of all languages.
std::u32string lettersOf(const Languages& languages, std::string (texts::Language::*wordsOf)() const) {
  std::u32string letters;
  for (const auto& language : languages) {
    if (!language) continue;
    const std::string words = ((*language).*wordsOf)();
    for (std::string_view left = words; !left.empty();) {
      const std::optional<char32_t> letter = takeCodePoint(left);
      if (letter && *letter >= 0x80) letters += *letter;
    }
  }
  std::ranges::sort(letters);
  letters.erase(std::unique(letters.begin(), letters.end()), letters.end());
  return letters;
}

/// Returns a language as a line; that of English is empty.
std::string packed(const std::string& name, std::span<const std::string> scenarios) {
  const std::shared_ptr<texts::Language> language =
      loadLanguage(name, {lettersWithoutFont, missingFontPackage});
  if (!language) return {};
  for (const std::string& scenario : scenarios) addWordsBeside(scenario, *language);
  return language->packed();
}

}  // namespace

std::vector<std::string> shareLanguages(const Cluster& cluster, const SessionLanguages& languages,
                                        std::span<const std::string> scenarios) {
  nlohmann::json shared;
  onAllRanks(cluster, [&] {
    if (cluster.rank() != 0) return;
    for (const std::string& name : languages.all) shared.push_back({name, packed(name, scenarios)});
  });
  std::string text = shared.dump();
  cluster.share(text);
  std::vector<std::string> names;
  Languages all;
  for (const nlohmann::json& one : nlohmann::json::parse(text)) {
    names.push_back(one.at(0));
    const std::string line = one.at(1);
    all.push_back(line.empty() ? nullptr
                               : std::make_shared<const texts::Language>(texts::Language::unpacked(line)));
  }
  Gui::setLetters(lettersOf(all, &texts::Language::allWords));
  setPlateLetters(lettersOf(all, &texts::Language::plateWords));
  texts::setSessionLanguages(std::move(all));
  return names;
}

}  // namespace carom
