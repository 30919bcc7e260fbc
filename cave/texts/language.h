#pragma once
// The catalogue of texts by name, and the words of one language for it.

#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace carom::texts {

/// A text of the catalogue.
struct Entry {
  const char* name;     ///< "message.kStroke", "latency.kParts 1"
  const char* english;  ///< for one, if it counts something
  const char* plural;   ///< null: it counts nothing
  const char* note;     ///< for translators
};

/// Returns all texts, always in one order; the index of an entry is the number of its text.
std::span<const Entry> catalogue();

/// All words of one language. English is the absence of one.
class Language {
 public:
  explicit Language(std::string code) : code_(std::move(code)) {}
  /// Puts the forms of a text of the catalogue.
  void put(std::size_t index, std::vector<std::string> forms) { forms_[index] = std::move(forms); }
  /// Puts the words for an English text of a game.
  void putOther(std::string english, std::string words) { other_[std::move(english)] = std::move(words); }
  const std::string& code() const { return code_; }

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
