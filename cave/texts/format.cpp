#include "cave/texts/format.h"

#include <algorithm>
#include <cctype>

namespace carom::texts {

const char* formFor(const Text& text, double number) {
  if (const Language* const used = language()) return used->wordsFor(text, number);
  return pluralForm("en", number) == 0 ? text.english() : text.englishOfMany();
}

fmt::appender write(std::string_view number, const Digits& digits, fmt::appender out) {
  constexpr std::size_t kGroup = 3, kUngrouped = 4;
  const auto isDigit = [](char letter) { return std::isdigit(static_cast<unsigned char>(letter)) != 0; };
  const auto copy = [&](std::string_view words) { out = std::copy(words.begin(), words.end(), out); };
  const auto begin = static_cast<std::size_t>(std::ranges::find_if(number, isDigit) - number.begin());
  const auto end = static_cast<std::size_t>(
      std::find_if_not(number.begin() + static_cast<std::ptrdiff_t>(begin), number.end(), isDigit) -
      number.begin());
  copy(number.substr(0, begin));
  for (std::size_t i = begin; i < end; ++i) {
    if (i > begin && end - begin > kUngrouped && (end - i) % kGroup == 0) copy(digits.group);
    copy(number.substr(i, 1));
  }
  if (end < number.size() && number[end] == '.') {
    copy(digits.point);
    copy(number.substr(end + 1));
  } else {
    copy(number.substr(end));
  }
  return out;
}

}  // namespace carom::texts
