#pragma once
// A language: the words of every text of the catalogue, and of the texts of games. English is the absence of
// one. Which is in use is each thread's own choice, for as long as it says or writes something for one
// reader.

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "cave/texts/texts.h"

namespace carom::texts {

/// How a language writes numbers.
struct Digits {
  const char* point = ".";  ///< before the decimals
  const char* group = "";   ///< between groups of three, from five digits on
};

/// Returns how many forms a text with a count has in a language, and which one a number takes. Unicode CLDR:
/// English and German have one for 1 and one for the rest, French one up to less than 2; Japanese has one.
std::size_t pluralForms(std::string_view code);
std::size_t pluralForm(std::string_view code, double number);

class Language {
 public:
  /// `code`: as HTML names it, "fr".
  explicit Language(std::string code);
  /// Returns the made language "pseudo", in which every text is 40 % longer, with accents and in brackets.
  /// Words without brackets are not in the catalogue; words that are cut lack the closing one.
  static Language pseudo();

  /// Sets the words of a text; with a count as many forms as the language has.
  void put(std::size_t index, std::vector<std::string> forms);
  /// Sets the words of a text of a game, by its English.
  void putOther(std::string english, std::string words);
  /// Says that words of a game stand on plates, too.
  void putOnPlates(std::string_view words) { gamePlates_ += words; }

  /// Returns all of it in one line, for another node, and makes it from such a line.
  std::string packed() const;
  static Language unpacked(const std::string& line);
  /// Returns all its words, one after the other.
  std::string allWords() const;
  /// Returns those that stand on plates, whose letters are few (cave/gl/letter_atlas.h).
  std::string plateWords() const;

  const std::string& code() const { return code_; }
  const Digits& digits() const { return digits_; }
  /// Returns the words of a text; the English where there are no others. They stay where they are.
  const char* words(const Text& text) const;
  /// Returns the words of a text for that many.
  const char* wordsFor(const Text& text, double number) const;
  /// Returns the words of a game's text or of a name in it; without a translation the English. A number at
  /// the end of a name stays: "left 3"; a number alone has the language's signs: "1,2 c".
  std::string other(std::string_view english) const;

 private:
  std::string code_;
  Digits digits_;
  bool isPseudo_ = false;
  std::vector<std::vector<std::string>> forms_;  ///< of each text; none: English
  std::unordered_map<std::string, std::string> others_;
  std::string gamePlates_;  ///< those of others_ that stand on plates
};

/// Sets the languages of the session, by their numbers in its records; null: English. They are read by all
/// threads: set them before there are others.
void setSessionLanguages(std::vector<std::shared_ptr<const Language>> languages);
/// Returns the session's language of that number; null: English. Before a session has set its languages, the
/// one in use.
const Language* ofSession(std::size_t number);

/// Returns the language in use; null: English.
const Language* language();
/// Its code; "en" of English.
std::string languageCode();
/// Returns the words of a game's text or of a name in it, in the language in use.
std::string other(std::string_view english);

/// Puts a language in use on this thread, until this object ends. `language` may be null.
class InLanguage {
 public:
  explicit InLanguage(const Language* language);
  ~InLanguage();
  InLanguage(const InLanguage&) = delete;
  InLanguage& operator=(const InLanguage&) = delete;

 private:
  const Language* before_;
};

}  // namespace carom::texts
