#pragma once
// What a translation must have in common with its English: the places of values, and the keys that it names.

#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace carom {

/// A place for a value in a text, in the notation of the library fmt: "{}", "{:.2f}", "{1:.2f}".
struct TextValue {
  std::string number;  ///< which value, "0", also where the text leaves it out; or a name
  std::string format;  ///< behind the colon
  auto operator<=>(const TextValue&) const = default;
};

struct TextValues {
  std::vector<TextValue> values;  ///< in the order of their numbers
  std::string fault;              ///< a fault of the braces, and the expectation; empty: none
};

/// Returns the places for values of a text.
TextValues valuesOf(std::string_view text);

/// Returns the places for values in the notation of printf, as sliders have them: "%.2f".
std::vector<std::string> printfValuesOf(std::string_view text);

/// Returns places in words: "{0} and {1:.2f}"; "none".
std::string wordsFor(const std::vector<TextValue>& values);

/// The keys of a keyboard that a text names: F1 to F12, and capitals that stand alone ("W A S D").
struct TextKeys {
  std::set<std::string> sure;
  std::set<std::string> all;  ///< with capitals that may be words: "Y a-t-il", "A puck"
};

/// Returns the keys. A capital that begins a sentence, before a small letter, may be a word: in English "A"
/// and "I" alone, which may stand anywhere; in other languages each. No key is a capital before an apostrophe
/// ("L’observateur") or beside a letter or digit.
TextKeys keysOf(std::string_view text, bool isEnglish);

}  // namespace carom
