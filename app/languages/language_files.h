#pragma once
// The files of languages: config/languages/CODE/carom.po and scenarios.po, and mine.CODE.po beside a scenario
// mine.toml of one's own.

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "app/languages/translation_rules.h"
#include "cave/texts/language.h"

namespace carom {

/// What this computer can draw.
struct LetterFonts {
  /// Returns the letters of a text that no font has (cave/gl/glyph_bitmap.h); null: not asked.
  std::function<std::u32string(std::string_view)> lettersWithoutFont{};
  /// Returns the package of a font that is missing here; empty if none is.
  std::function<std::string()> missingPackage{};
};

/// A file that has been read and judged.
struct ReadTranslation {
  TranslationRules rules;
  JudgedTranslation judged;
};

/// Reads a PO file and holds it against the texts that it is about: of a file mine.CODE.po beside mine.toml
/// those of that scenario, whose contexts may leave the file's name out; otherwise the catalogue, the shipped
/// scenarios or both, as its contexts say. Throws InputErrors if it is no PO file.
ReadTranslation readTranslation(const std::filesystem::path& file, const LetterFonts& fonts);

/// Returns the codes of the shipped languages, in alphabetical order, without English.
std::vector<std::string> shippedLanguages();

/// Returns the folder of a shipped language. Throws std::runtime_error, in one sentence, if it is none: an
/// unknown code, a path.
std::filesystem::path folderOfLanguage(const std::string& code);

/// Returns a language by its code, or by a PO file, beside which the other of carom.po and scenarios.po is
/// read, too; null for "en"; "pseudo" is made of the English. Texts without a translation stay English.
/// Throws InputErrors with all errors of its files, std::runtime_error if there is no such language, or if no
/// font here has its letters (one sentence, with the package that has them).
std::shared_ptr<texts::Language> loadLanguage(const std::string& given, const LetterFonts& fonts);

/// Adds the words of a scenario of one's own, mine.CODE.po beside mine.toml. Returns whether there is such a
/// file. Throws InputErrors with its errors.
bool addWordsBeside(const std::filesystem::path& scenario, texts::Language& language);

/// How much of a shipped language is translated.
struct LanguageProgress {
  std::string code;
  struct Part {
    std::size_t translated = 0, all = 0;
  };
  Part texts, games;
  std::string fault;  ///< the first error; empty: none
};

/// Returns how far each shipped language is.
std::vector<LanguageProgress> progressOfLanguages();

}  // namespace carom
