// Signs of UTF-8: each code point there and back by the format's own table, and bytes that are none.
#include "engine/text/code_points.h"

#include <gtest/gtest.h>

#include <string>

namespace carom {
namespace {

/// Writes a code point as the table of RFC 3629, section 3, says, also those that may not be written.
std::string written(char32_t code) {
  const auto tail = [code](unsigned shift) { return static_cast<char>(0x80U | (code >> shift & 0x3FU)); };
  if (code < 0x80) return {static_cast<char>(code)};
  if (code < 0x800) return {static_cast<char>(0xC0U | code >> 6U), tail(0)};
  if (code < 0x10000) return {static_cast<char>(0xE0U | code >> 12U), tail(6), tail(0)};
  return {static_cast<char>(0xF0U | code >> 18U), tail(12), tail(6), tail(0)};
}

TEST(CodePoints, OfEachSignAreThoseOfTheTable) {
  for (char32_t code = 0; code <= 0x10FFFF + 0x100; ++code) {
    const std::string text = written(code) + "x";
    const bool isSign = code <= 0x10FFFF && (code < 0xD800 || code > 0xDFFF);
    const std::u32string points = codePointsOf(text);
    if (isSign) {
      ASSERT_EQ(points, (std::u32string{code, U'x'})) << static_cast<unsigned>(code);
    } else {
      ASSERT_EQ(points.front(), U'\uFFFD') << static_cast<unsigned>(code);
      ASSERT_EQ(points.back(), U'x') << static_cast<unsigned>(code);
    }
  }
}

TEST(CodePoints, OfWhatIsNoTextAreReplacements) {
  EXPECT_EQ(codePointsOf("\xff\xfe"), U"\uFFFD\uFFFD");
  EXPECT_EQ(codePointsOf("a\xe3\x81"), U"a\uFFFD\uFFFD") << "cut off";
  EXPECT_EQ(codePointsOf("\xc0\x80"), U"\uFFFD\uFFFD") << "longer than it need be";
  EXPECT_EQ(codePointsOf("\xe0\x80\x80"), U"\uFFFD\uFFFD\uFFFD");
  EXPECT_EQ(codePointsOf(""), U"");
  std::string_view text = "\x80z";
  EXPECT_EQ(takeCodePoint(text), std::nullopt);
  EXPECT_EQ(text, "z") << "one byte is taken";
}

}  // namespace
}  // namespace carom
