#include "engine/text/code_points.h"

#include <array>
#include <cstddef>

namespace carom {
namespace {

/// A sign with the number of its bytes; 0 bytes: there is none.
struct Sign {
  char32_t code = 0;
  std::size_t bytes = 0;
};

/// Returns the sign with which a text begins, if that is UTF-8.
Sign firstSign(std::string_view text) {
  const auto byte = [&](std::size_t i) { return char32_t{static_cast<unsigned char>(text[i])}; };
  const char32_t lead = byte(0);
  if (lead < 0x80) return {lead, 1};
  const std::size_t bytes = lead >= 0xC2 && lead < 0xE0 ? 2 : lead >= 0xE0 && lead < 0xF0 ? 3 : 4;
  if (lead < 0xC2 || lead > 0xF4 || bytes > text.size()) return {};
  char32_t code = lead & (0xFFU >> (bytes + 1));
  for (std::size_t i = 1; i < bytes; ++i) {
    if ((byte(i) & 0xC0U) != 0x80U) return {};
    code = code << 6U | (byte(i) & 0x3FU);
  }
  constexpr std::array<char32_t, 5> kLeast{0, 0, 0x80, 0x800, 0x10000};  // shorter forms have the rest
  const bool isHalf = code >= 0xD800 && code <= 0xDFFF;                  // of a pair of UTF-16
  if (code < kLeast.at(bytes) || code > 0x10FFFF || isHalf) return {};
  return {code, bytes};
}

}  // namespace

std::optional<char32_t> takeCodePoint(std::string_view& text) {
  const Sign sign = firstSign(text);
  text.remove_prefix(sign.bytes > 0 ? sign.bytes : 1);
  return sign.bytes > 0 ? std::optional(sign.code) : std::nullopt;
}

std::u32string codePointsOf(std::string_view text) {
  constexpr char32_t kReplacement = 0xFFFD;
  std::u32string points;
  while (!text.empty()) points.push_back(takeCodePoint(text).value_or(kReplacement));
  return points;
}

}  // namespace carom
