#include "engine/base/plain_words.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace carom {
namespace {

/// A sign with the number of its bytes; 0 bytes: there is none.
struct Sign {
  std::uint32_t code = 0;
  std::size_t bytes = 0;
};

/// Returns the sign with which a text begins, if that is UTF-8 (RFC 3629, section 3).
Sign firstSign(std::string_view text) {
  const auto byte = [&](std::size_t i) {
    return static_cast<std::uint32_t>(static_cast<unsigned char>(text[i]));
  };
  const std::uint32_t lead = byte(0);
  if (lead < 0x80) return {lead, 1};
  const std::size_t bytes = lead >= 0xC2 && lead < 0xE0 ? 2 : lead >= 0xE0 && lead < 0xF0 ? 3 : 4;
  if (lead < 0xC2 || lead > 0xF4 || bytes > text.size()) return {};
  std::uint32_t code = lead & (0xFFU >> (bytes + 1));
  for (std::size_t i = 1; i < bytes; ++i) {
    if ((byte(i) & 0xC0U) != 0x80U) return {};
    code = code << 6U | (byte(i) & 0x3FU);
  }
  constexpr std::array<std::uint32_t, 5> kLeast{0, 0, 0x80, 0x800, 0x10000};  // shorter forms have the rest
  const bool isHalf = code >= 0xD800 && code <= 0xDFFF;                       // of a pair of UTF-16
  if (code < kLeast.at(bytes) || code > 0x10FFFF || isHalf) return {};
  return {code, bytes};
}

bool showsNothing(std::uint32_t code) {
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
    const Sign sign = firstSign(text);
    const std::string_view letters = text.substr(0, std::max<std::size_t>(sign.bytes, 1));
    text.remove_prefix(letters.size());
    const bool divides = sign.code == '\n' || sign.code == '\t';
    if (sign.bytes > 0 && showsNothing(sign.code) && !divides) continue;
    words += divides ? std::string_view(" ") : sign.bytes == 0 ? std::string_view("?") : letters;
    ++signs;
  }
  return words;
}

}  // namespace carom
