#pragma once
// A glossary: the one word of a language for each thing, so that a visitor meets one word for one thing.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "app/toml/input_file.h"

namespace carom {

/// A line "english = translation | stem, stem": a translation of a text with the English term has one of
/// these words, in any case of its letters, also as a part of a longer word.
struct GlossaryTerm {
  std::vector<std::u32string> english;  ///< its words, in small letters
  std::vector<std::u32string> words;    ///< in small letters; the first is the translation
  std::string line;                     ///< for messages: "proper time = temps propre"
};

class Glossary {
 public:
  /// Reads a file of at most 1 MiB; lines that begin with '#' are comments. Throws InputErrors.
  static Glossary read(const std::filesystem::path& file);
  /// Returns the glossary.txt beside a file; without terms if there is none.
  static Glossary beside(const std::filesystem::path& file);

  /// Returns the terms of an English text that have no word in its translation. The longest term counts: with
  /// "rest frame" in a text, "frame" alone is not asked for there.
  std::vector<const GlossaryTerm*> missingIn(std::string_view english, std::string_view translation) const;

  /// Returns whether an English word is the same in both languages: it has the line "position = position".
  bool isShared(std::string_view word) const;

  const std::vector<GlossaryTerm>& terms() const { return terms_; }

 private:
  std::vector<GlossaryTerm> terms_;  ///< those of most words first
};

}  // namespace carom
