#include "cave/texts/pseudo.h"

#include <array>
#include <cstddef>

namespace carom::texts {
namespace {

constexpr double kLonger = 0.4;
constexpr const char* kFilling = "-";  // narrow: wider letters would make a text 60 % wider

const char* accented(char letter) {
  static constexpr std::string_view kPlain = "AEIOUaeiouncyNC";
  static constexpr std::array<const char*, kPlain.size()> kAccented{"Å", "É", "Î", "Ö", "Û", "å", "é", "î",
                                                                    "ö", "û", "ñ", "ç", "ý", "Ñ", "Ç"};
  const std::size_t at = kPlain.find(letter);
  return at == std::string_view::npos ? nullptr : kAccented[at];
}

bool isLetter(char letter) { return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z'); }
bool isLow(char letter) { return letter >= 'a' && letter <= 'z'; }

}  // namespace

std::string pseudoOf(std::string_view english) {
  const std::size_t begin = english.find_first_not_of(' ');
  if (begin == std::string_view::npos) return std::string(english);
  const std::size_t end = english.find_last_not_of(' ') + 1;
  std::string words;
  double letters = 0.0;
  bool hasLetters = false;
  for (std::size_t i = begin; i < end; ++i) {
    if (english[i] == '{') {
      const std::size_t closed = std::min(english.find('}', i), end - 1);
      words += english.substr(i, closed + 1 - i);
      i = closed;
      continue;
    }
    ++letters;
    // A key or a sign is a capital or a letter that stands alone; in a word every small letter changes.
    const bool isAlone =
        (i == begin || !isLetter(english[i - 1])) && (i + 1 >= end || !isLow(english[i + 1]));
    const char* const other = isAlone ? nullptr : accented(english[i]);
    hasLetters = hasLetters || (isLow(english[i]) && i + 1 < end && isLow(english[i + 1]));
    other ? words += other : words += english[i];
  }
  if (!hasLetters) return std::string(english);
  for (double more = 2.0; more < kLonger * letters; ++more) words += kFilling;
  return std::string(english.substr(0, begin)) + "[" + words + "]" + std::string(english.substr(end));
}

}  // namespace carom::texts
