#pragma once
// The catalogue of texts: every text of the program that a visitor, student, teacher or operator reads on
// walls, in the console, on phones and in other windows, by name: texts::message::kStroke. The lists stand in
// cave/texts/catalogue, one file a group:
//
//   TEXT(kName, "English", "what fills its values")   the last for translators; where there is no value, not
//   PLURAL(kName, "{} puck", "{} pucks", "…")         the first value is the number that decides
//   TEXTS(kName, "first", "second", …)                a list: std::array<Text, n>
//
// A text is in the language in use (cave/texts/language.h); the values of "{}" (the notation of the library
// fmt) are checked against the English by the compiler.
//
// Not here: the texts of games and lessons, which stand in their files (config/scenarios), one file a game;
// the messages of the command line, of the log and of trackers, which name facts of the code that writes them
// and stand beside it; names that files contain (keys of a scenario, words of a session file), which no
// translation may change. tests/app/texts.py finds texts that are elsewhere.

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

namespace carom::texts {

/// A text of the catalogue. It turns into words of the language in use, which stay where they are as long as
/// the language does.
class Text {
 public:
  constexpr Text() = default;  ///< none: number 0, no words
  constexpr Text(std::size_t index, const char* one, const char* many = nullptr)
      : index_(static_cast<std::uint16_t>(index)), one_(one), many_(many) {}

  constexpr std::size_t index() const { return index_; }  ///< in catalogue()
  constexpr const char* english() const { return one_; }
  constexpr const char* englishOfMany() const { return many_; }  ///< null: the text has no count
  constexpr explicit operator bool() const { return index_ != 0; }
  constexpr bool operator==(const Text& other) const { return index_ == other.index_; }

  const char* words() const;
  operator const char*() const { return words(); }       // NOLINT(google-explicit-constructor)
  operator std::string_view() const { return words(); }  // NOLINT(google-explicit-constructor)

 private:
  std::uint16_t index_ = 0;
  const char *one_ = "", *many_ = nullptr;
};

inline std::ostream& operator<<(std::ostream& out, const Text& text) { return out << text.words(); }

/// What a translator is told of a text.
struct Entry {
  std::string name;  ///< "message.kStroke"; of a list "latency.kParts 1"
  Text text;         ///< its English is empty where there is nothing to translate
  std::string note;  ///< what fills its values, and where it is seen
};

/// Returns all texts; a text's index is its place here. The first is none.
const std::vector<Entry>& catalogue();
/// Returns the text of a name; none if there is none.
Text textNamed(std::string_view name);

/// Returns the words of a group that a page of its own asks for by name, in the language in use: those whose
/// names do not begin with a k.
std::map<std::string, std::string> pageWords(std::string_view group);

/// Returns how many values a macro was given.
template <typename... Values>
consteval std::size_t countOf(const Values&...) {
  return sizeof...(Values);
}

#define CAROM_JOIN(a, b) a##_##b
#define CAROM_JOINED(a, b) CAROM_JOIN(a, b)
/// The number of each text: its group and name.
namespace number {
enum : std::uint16_t {
  none,
#define TEXT(name, ...) CAROM_JOINED(GROUP, name),
#define PLURAL(name, ...) CAROM_JOINED(GROUP, name),
#define TEXTS(name, ...)     \
  CAROM_JOINED(GROUP, name), \
      CAROM_JOINED(GROUP, CAROM_JOIN(name, last)) = CAROM_JOINED(GROUP, name) + countOf(__VA_ARGS__) - 1,
#include "cave/texts/catalogue/all.inc"
#undef TEXT
#undef PLURAL
#undef TEXTS
};
}  // namespace number

/// Returns a list of texts whose numbers follow one another.
template <typename... Words>
consteval auto listOf(std::size_t first, Words... words) {
  return std::array<Text, sizeof...(Words)>{Text(first++, words)...};
}

#define TEXT(name, english, ...)                                          \
  namespace GROUP {                                                       \
  inline constexpr Text name(number::CAROM_JOINED(GROUP, name), english); \
  }
#define PLURAL(name, one, many, ...)                                        \
  namespace GROUP {                                                         \
  inline constexpr Text name(number::CAROM_JOINED(GROUP, name), one, many); \
  }
#define TEXTS(name, ...)                                                               \
  namespace GROUP {                                                                    \
  inline constexpr auto name = listOf(number::CAROM_JOINED(GROUP, name), __VA_ARGS__); \
  }
#include "cave/texts/catalogue/all.inc"
#undef TEXT
#undef PLURAL
#undef TEXTS
#undef CAROM_JOIN
#undef CAROM_JOINED

}  // namespace carom::texts
