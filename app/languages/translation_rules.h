#pragma once
// The rules of a translation. An entry with an error is an error of its file: a wall that shows a value too
// few, or names another key, would mislead people. Warnings are for translators; the file can be used.

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/languages/glossary.h"
#include "app/languages/po_file.h"
#include "app/languages/source_text.h"
#include "app/toml/findings.h"

namespace carom {

/// What a translation is held against.
struct TranslationRules {
  std::string code;                   ///< of the language that the file must be in; empty: any
  std::vector<SourceText> sources{};  ///< the English of today
  Glossary glossary{};
  /// Returns the letters that no font has (cave/gl/glyph_bitmap.h); null: not asked.
  std::function<std::u32string(std::string_view)> lettersWithoutFont{};
};

/// A translation that can be shown: current, whole, not fuzzy.
struct Translated {
  std::size_t source = 0;  ///< index of its English
  std::vector<std::string> forms;
};

struct JudgedTranslation {
  std::string code;                    ///< of the file's language: "fr"
  std::vector<Finding> findings;       ///< in the order of the file
  std::vector<Translated> translated;  ///< those without errors
};

/// Judges a file by the rules.
///
/// Errors: no header or one of another language, charset or number of plural forms; a text without a name, or
/// twice; values that are missing, added or of another format; braces without their partners; plural forms
/// that are missing; control signs; marks of direction and right-to-left letters, which are not drawn yet;
/// other keys than the English. Warnings: texts that are missing, fuzzy, stale (their English is another
/// today) or unknown; spaces at their ends that the English has not; a text that is the same as in English
/// though it has real words (three letters or more, not all capitals, no options "--capture", not glued to a
/// value), unless the glossary has each of them as a word of both languages; a term that the glossary
/// translates otherwise; letters that no font has; the same English in two ways in texts of games: the first
/// is shown.
JudgedTranslation judge(const PoFile& file, const TranslationRules& rules);

/// Returns whether this is a language's code, such as "fr" or "pt_BR".
bool isLanguageCode(std::string_view code);

}  // namespace carom
