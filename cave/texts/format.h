#pragma once
// Texts of the catalogue with their values, in the language in use: its words, its form for a count, its
// decimal sign and its space between thousands. What a program reads is never written by these.

#include <concepts>
#include <iterator>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

#include <fmt/format.h>

#include "cave/texts/language.h"
#include "cave/texts/texts.h"

template <>
struct fmt::formatter<carom::texts::Text> : fmt::formatter<std::string_view> {
  auto format(const carom::texts::Text& text, format_context& context) const {
    return formatter<std::string_view>::format(text.words(), context);
  }
};

namespace carom::texts {

template <typename Value>
concept Countable = std::is_arithmetic_v<Value> && !std::same_as<Value, bool> && !std::same_as<Value, char>;

/// A number that is written as the language in use writes it.
template <Countable Value>
struct Number {
  Value value;
};

/// Writes digits with the language's signs in place of the point, and between thousands from five digits on.
fmt::appender write(std::string_view number, const Digits& digits, fmt::appender out);

}  // namespace carom::texts

template <typename Value>
struct fmt::formatter<carom::texts::Number<Value>> : fmt::formatter<Value> {
  auto format(carom::texts::Number<Value> number, format_context& context) const {
    const carom::texts::Language* const language = carom::texts::language();
    if (!language) return formatter<Value>::format(number.value, context);
    memory_buffer plain;
    format_context inner(appender(plain), context.args(), context.locale());
    formatter<Value>::format(number.value, inner);
    return carom::texts::write({plain.data(), plain.size()}, language->digits(), context.out());
  }
};

namespace carom::texts {

/// A text whose English has a place for each of these values, in a format that fits it: the compiler says so.
template <typename... Values>
struct Checked {
  // Implicit, so that a text may be given where one is checked.
  consteval Checked(const Text& checked)  // NOLINT(google-explicit-constructor)
      : text(checked) {
    [[maybe_unused]] const fmt::format_string<Values...> one(fmt::string_view(checked.english()));
    if (checked.englishOfMany()) [[maybe_unused]]
      const fmt::format_string<Values...> many(fmt::string_view(checked.englishOfMany()));
  }
  Text text;
};
template <typename... Values>
using CheckedText = Checked<std::type_identity_t<Values>...>;

template <typename Value>
decltype(auto) localized(const Value& value) {
  if constexpr (Countable<Value>) {
    return Number<Value>{value};
  } else {
    return (value);
  }
}

/// Returns the words of a text with a count for that many.
const char* formFor(const Text& text, double number);

/// Returns the words of a text for its values. If it has a count, that is the first value.
template <typename... Values>
const char* wordsFor(const Text& text, const Values&... values) {
  if constexpr (sizeof...(Values) > 0) {
    const auto first = [](const auto& value, const auto&...) {
      if constexpr (Countable<std::remove_cvref_t<decltype(value)>>) return static_cast<double>(value);
      return 0.0;
    };
    if (text.englishOfMany()) return formFor(text, first(values...));
  }
  return text.words();
}

/// Returns a text with its values.
template <typename... Values>
std::string format(CheckedText<Values...> words, const Values&... values) {
  return fmt::vformat(wordsFor(words.text, values...), fmt::make_format_args(localized(values)...));
}

/// Appends it.
template <typename... Values>
void formatTo(std::string& text, CheckedText<Values...> words, const Values&... values) {
  fmt::vformat_to(std::back_inserter(text), wordsFor(words.text, values...),
                  fmt::make_format_args(localized(values)...));
}

/// Writes it into memory, cut at its end, and returns the words: no frame allocates memory for it.
template <typename... Values>
std::string_view formatTo(std::span<char> memory, const Text& words, const Values&... values) {
  const auto end = fmt::vformat_to_n(memory.data(), memory.size(), wordsFor(words, values...),
                                     fmt::make_format_args(localized(values)...));
  return {memory.data(), std::min(end.size, memory.size())};
}

}  // namespace carom::texts
