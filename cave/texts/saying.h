#pragma once
// Words for people before a language is chosen: texts of the catalogue with their values, and texts of games.
// The record of a frame carries them (cave/record/notice.h), and each reader has them in their own language;
// the log and the session file have the English.
//
// As a line of JSON they are a list of parts: a string is a text of a game or a name; a list is a text of the
// catalogue and its values, which are numbers, names, or lists of parts themselves:
//   [["message.kStroke","red",1.2,1.3,[["message.kRightOfCentre",12]]]]

#include <cmath>
#include <concepts>
#include <string>
#include <string_view>
#include <type_traits>

#include <fmt/format.h>

#include "cave/texts/format.h"
#include "cave/texts/texts.h"

namespace carom::texts {

class Saying {
 public:
  Saying() = default;  ///< nothing
  /// A text of a game, or a name.
  explicit Saying(std::string_view words);
  // Implicit: a text without values is said as it is.
  Saying(const Text& text);  // NOLINT(google-explicit-constructor)

  /// Reads a line of JSON. Whatever it holds: what cannot be understood is left out.
  static Saying read(std::string_view line);

  bool empty() const { return parts_.empty(); }
  /// Returns it as a line of JSON; empty if there is nothing.
  std::string line() const;
  std::string words() const;  ///< in the language in use
  std::string english() const;

  Saying& operator+=(const Saying& more);
  friend Saying operator+(Saying first, const Saying& second) { return first += second; }
  bool operator==(const Saying&) const = default;

 private:
  template <typename... Values>
  friend Saying say(CheckedText<Values...> words, const Values&... values);

  void begin(const Text& text);
  void end() { parts_ += ']'; }
  void value(double number);
  void value(std::string_view name);
  void value(const Saying& saying);
  void value(const Text& text) { value(Saying(text)); }
  template <std::integral Whole>
  void value(Whole number) {
    parts_ += fmt::format(",{}", number);
  }

  std::string parts_;  ///< of the list, separated by commas
};

/// Returns a text with its values.
template <typename... Values>
Saying say(CheckedText<Values...> words, const Values&... values) {
  Saying saying;
  saying.begin(words.text);
  (saying.value(values), ...);
  saying.end();
  return saying;
}

}  // namespace carom::texts

/// A saying as a value: by its words.
template <>
struct fmt::formatter<carom::texts::Saying> : fmt::formatter<std::string_view> {
  auto format(const carom::texts::Saying& saying, format_context& context) const {
    return formatter<std::string_view>::format(saying.words(), context);
  }
};
