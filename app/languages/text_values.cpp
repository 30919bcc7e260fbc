#include "app/languages/text_values.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstddef>

#include "app/languages/letters.h"
#include "engine/text/code_points.h"

namespace carom {
namespace {

bool isDigit(char32_t sign) { return sign >= U'0' && sign <= U'9'; }
bool isCapital(char32_t sign) { return sign >= U'A' && sign <= U'Z'; }
bool isApostrophe(char32_t sign) { return sign == U'\'' || sign == U'’'; }
/// Returns whether a sign makes one word with a letter beside it.
bool isWordSign(char32_t sign) { return isLetter(sign) || isDigit(sign) || sign == U'²' || sign == U'°'; }

std::string utf8(char32_t ascii) { return {static_cast<char>(ascii)}; }

/// Returns a text without its places for values, which name no keys.
std::string withoutValues(std::string_view text) {
  std::string rest;
  bool isValue = false;
  for (const char c : text) {
    if (c == '{') isValue = true;
    rest += isValue ? '|' : c;
    if (c == '}') isValue = false;
  }
  return rest;
}

/// Returns whether a sentence begins at a sign: only spaces, or the end of another one, stand before it.
bool beginsSentence(const std::u32string& signs, std::size_t at) {
  while (at > 0 && (signs[at - 1] == U' ' || signs[at - 1] == 0xA0 || signs[at - 1] == 0x202F)) --at;
  return at == 0 || std::u32string_view(U".!?:…«“„(¿¡").find(signs[at - 1]) != std::u32string_view::npos;
}

/// Returns whether a capital that stands alone may be a word (see keysOf).
bool maybeWord(const std::u32string& signs, std::size_t at, bool isEnglish) {
  std::size_t next = at + 1;
  while (next < signs.size() && (signs[next] == U' ' || signs[next] == 0xA0)) ++next;
  if (next == at + 1 || next == signs.size() || !isLetter(signs[next]) || isCapital(signs[next]))
    return false;
  return isEnglish ? signs[at] == U'I' || (signs[at] == U'A' && beginsSentence(signs, at))
                   : beginsSentence(signs, at);
}

/// Returns whether an apostrophe joins a capital with a word behind it; "A's" is a capital of its own.
bool isElided(const std::u32string& signs, std::size_t at) {
  if (at + 2 >= signs.size() || !isApostrophe(signs[at + 1]) || !isLetter(signs[at + 2])) return false;
  const bool isOwner = signs[at + 2] == U's' && (at + 3 >= signs.size() || !isLetter(signs[at + 3]));
  return !isOwner;
}

}  // namespace

TextValues valuesOf(std::string_view text) {
  TextValues found;
  std::size_t next = 0, numbered = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '}') {
      found.fault = "a '}' without its '{', expected places of values alone, such as {} or {:.2f}";
      return found;
    }
    if (text[i] != '{') continue;
    const std::size_t end = text.find_first_of("{}", i + 1);
    if (end == std::string_view::npos || text[end] == '{') {
      found.fault = end == i + 1
                        ? "'{{', which no text has, expected places of values alone, such as {} or {:.2f}"
                        : "a '{' without its '}', expected a place of a value, such as {} or {:.2f}";
      return found;
    }
    const std::string_view inside = text.substr(i + 1, end - i - 1);
    const std::size_t colon = std::min(inside.find(':'), inside.size());
    std::string number(inside.substr(0, colon));
    number.empty() ? ++next : ++numbered;
    if (number.empty()) number = std::to_string(next - 1);
    found.values.push_back({number, std::string(inside.substr(std::min(colon + 1, inside.size())))});
    i = end;
  }
  if (next > 0 && numbered > 0)
    found.fault =
        "places of values with and without numbers, expected numbers in all, as in {1} {0}, or in none";
  std::ranges::sort(found.values);
  return found;
}

std::vector<std::string> printfValuesOf(std::string_view text) {
  std::vector<std::string> found;
  for (std::size_t i = text.find('%'); i != std::string_view::npos; i = text.find('%', i + 1)) {
    std::size_t end = i + 1;
    while (end < text.size() &&
           std::string_view("-+#.0123456789*hlLqjzt").find(text[end]) != std::string_view::npos)
      ++end;
    const bool isValue = end < text.size() && ((text[end] | 0x20) >= 'a' && (text[end] | 0x20) <= 'z');
    if (isValue) found.emplace_back(text.substr(i, end + 1 - i));
  }
  return found;
}

std::string wordsFor(const std::vector<TextValue>& values) {
  if (values.empty()) return "none";
  std::vector<std::string> words;
  for (const TextValue& value : values) {
    words.push_back(value.format.empty() ? fmt::format("{{{}}}", value.number)
                                         : fmt::format("{{{}:{}}}", value.number, value.format));
  }
  return fmt::format("{}", fmt::join(words, " "));
}

TextKeys keysOf(std::string_view text, bool isEnglish) {
  const std::u32string signs = codePointsOf(withoutValues(text));
  TextKeys keys;
  for (std::size_t i = 0; i < signs.size(); ++i) {
    if (!isCapital(signs[i]) || (i > 0 && (isWordSign(signs[i - 1]) || isApostrophe(signs[i - 1])))) continue;
    std::size_t end = i + 1;
    if (signs[i] == U'F') {
      while (end < signs.size() && end < i + 3 && isDigit(signs[end])) ++end;
    }
    if (end < signs.size() && isWordSign(signs[end])) continue;
    std::string key;
    for (std::size_t at = i; at < end; ++at) key += utf8(signs[at]);
    if (end == i + 1 && isElided(signs, i)) continue;
    keys.all.insert(key);
    if (end > i + 1 || !maybeWord(signs, i, isEnglish)) keys.sure.insert(key);
    i = end - 1;
  }
  return keys;
}

}  // namespace carom
