#include "app/languages/letters.h"

#include <string_view>
#include <utility>

#include "engine/text/code_points.h"

namespace carom {
namespace {

bool isIn(char32_t sign, char32_t first, char32_t last) { return sign >= first && sign <= last; }

char32_t small(char32_t sign) {
  if (isIn(sign, 'A', 'Z') || (isIn(sign, 0xC0, 0xDE) && sign != 0xD7)) return sign + 32;
  if (isIn(sign, 0x100, 0x137) || isIn(sign, 0x14A, 0x177)) return sign | 1U;  // capitals are even
  if (isIn(sign, 0x139, 0x148)) return sign + (sign & 1U);                     // and odd here
  if (isIn(sign, 0x391, 0x3A9) || isIn(sign, 0x410, 0x42F)) return sign + 32;
  if (isIn(sign, 0x400, 0x40F)) return sign + 80;
  return sign;
}

}  // namespace

bool isLetter(char32_t sign) {
  return isIn(sign, 'A', 'Z') || isIn(sign, 'a', 'z') ||
         (isIn(sign, 0xC0, 0x24F) && sign != 0xD7 && sign != 0xF7) || isIn(sign, 0x300, 0x52F) ||
         isIn(sign, 0x1E00, 0x1FFF);
}

bool isRightToLeft(char32_t sign) {
  return isIn(sign, 0x590, 0x8FF) || isIn(sign, 0xFB1D, 0xFDFF) || isIn(sign, 0xFE70, 0xFEFE) ||
         isIn(sign, 0x10800, 0x10FFF) || isIn(sign, 0x1E800, 0x1EFFF);
}

bool isDirectionMark(char32_t sign) {
  return sign == 0x61C || isIn(sign, 0x200E, 0x200F) || isIn(sign, 0x202A, 0x202E) ||
         isIn(sign, 0x2066, 0x2069);
}

bool isControl(char32_t sign) {
  return sign < 0x20 || isIn(sign, 0x7F, 0x9F) || isIn(sign, 0x2028, 0x2029) || sign == 0xFEFF ||
         isIn(sign, 0xFFF9, 0xFFFB) || isIn(sign, 0xE0000, 0xE007F);
}

std::u32string folded(std::string_view text) {
  std::u32string signs = codePointsOf(text);
  for (char32_t& sign : signs) {
    const bool isSpace = sign == 0xA0 || isIn(sign, 0x2000, 0x200A) || sign == 0x202F || sign == 0x3000;
    sign = isSpace ? U' ' : small(sign);
  }
  return signs;
}

std::vector<std::u32string> wordsOf(std::string_view text) {
  std::vector<std::u32string> words;
  std::u32string word;
  for (const char32_t sign : folded(text) + U' ') {
    if (isLetter(sign) || isIn(sign, '0', '9')) {
      word += sign;
      continue;
    }
    if (!word.empty()) words.push_back(std::exchange(word, {}));
    const bool isWithin = std::u32string_view(U" -'’").find(sign) != std::u32string_view::npos;
    if (!isWithin && !words.empty() && !words.back().empty()) words.emplace_back();
  }
  return words;
}

}  // namespace carom
