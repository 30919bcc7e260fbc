#include "engine/text/plain_words.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>

#include "engine/text/code_points.h"

namespace carom {
namespace {

bool showsNothing(char32_t code) {
  constexpr std::array<std::array<std::uint32_t, 2>, 11> kHidden{{{0x00, 0x1f},
                                                                  {0x7f, 0x9f},
                                                                  {0xad, 0xad},
                                                                  {0x61c, 0x61c},
                                                                  {0x200b, 0x200b},
                                                                  {0x200e, 0x200f},
                                                                  {0x2028, 0x202e},
                                                                  {0x2060, 0x2069},
                                                                  {0xfeff, 0xfeff},
                                                                  {0xfff0, 0xfffb},
                                                                  {0xe0000, 0xe0fff}}};
  return std::any_of(kHidden.begin(), kHidden.end(),
                     [code](const auto& range) { return code >= range[0] && code <= range[1]; });
}

}  // namespace

std::string plainWords(std::string_view text, std::size_t most) {
  std::string words;
  for (std::size_t signs = 0; !text.empty() && signs < most;) {
    const std::string_view before = text;
    const std::optional<char32_t> sign = takeCodePoint(text);
    const bool divides = sign == U'\n' || sign == U'\t';
    if (sign && showsNothing(*sign) && !divides) continue;
    words += divides ? " " : sign ? before.substr(0, before.size() - text.size()) : "?";
    ++signs;
  }
  return words;
}

}  // namespace carom
