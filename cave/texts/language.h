#pragma once
// The catalogue of texts by name, and the words of one language for it.

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace carom::texts {

/// A text of the catalogue.
class CatalogueText {
 public:
  CatalogueText(std::size_t index, const char* one, const char* many)
      : index_(index), one_(one), many_(many) {}
  std::size_t index() const { return index_; }
  const char* english() const { return one_; }
  const char* englishOfMany() const { return many_; }  ///< null: it counts nothing

 private:
  std::size_t index_;
  const char *one_, *many_;
};

/// What a translator is told of a text.
struct Entry {
  std::string name;    ///< "message.kStroke", "latency.kParts 1"
  CatalogueText text;  ///< its English is empty where there is nothing to translate
  std::string note;    ///< what fills its values, and where it is seen
};

/// Returns all texts, always in one order; a text's index is its place here.
const std::vector<Entry>& catalogue();

/// All words of one language. English is the absence of one.
class Language {
 public:
  explicit Language(std::string code) : code_(std::move(code)) {}
  /// Returns the made language "pseudo", which shows what is not in the catalogue.
  static Language pseudo() { return Language("pseudo"); }
  /// Puts the forms of a text of the catalogue.
  void put(std::size_t index, std::vector<std::string> forms) { forms_[index] = std::move(forms); }
  /// Puts the words for an English text of a game.
  void putOther(std::string english, std::string words) { other_[std::move(english)] = std::move(words); }
  const std::string& code() const { return code_; }
  /// Returns the words of a game's text; the English where there are no others.
  std::string other(std::string_view english) const {
    const auto found = other_.find(english);
    return found == other_.end() ? std::string(english) : found->second;
  }

 private:
  std::string code_;
  std::map<std::size_t, std::vector<std::string>> forms_;
  std::map<std::string, std::string, std::less<>> other_;
};

/// Returns the plural form of a number in a language; unknown languages count as English does.
std::size_t pluralForm(std::string_view code, double n);

/// Returns how many plural forms a language has.
std::size_t pluralForms(std::string_view code);

}  // namespace carom::texts
