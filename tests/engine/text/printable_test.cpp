#include "engine/text/printable.h"

#include <gtest/gtest.h>

namespace carom {
namespace {

TEST(Printable, EveryControlBecomesAQuestionMark) {
  for (int c = 0; c < 0x80; ++c) {
    const std::string text{'a', static_cast<char>(c), 'b'};
    const bool isControl = c < 0x20 || c == 0x7f;
    EXPECT_EQ(printable(text), isControl ? "a?b" : text) << c;
  }
}

TEST(Printable, ThoseThatAreKeptStay) { EXPECT_EQ(printable("a\tb\nc\x1b[31m", "\t\n"), "a\tb\nc?[31m"); }

TEST(Printable, LettersOfOtherScriptsStayAndTheirControlsGo) {
  EXPECT_EQ(printable("Müller → 東京"), "Müller → 東京");
  EXPECT_EQ(printable("a\u0085b").find('\x85'), std::string::npos) << "next line";
  EXPECT_EQ(printable("a\u009bb").find('\x9b'), std::string::npos) << "begins a terminal's commands";
  EXPECT_NE(printable("a\u00a0b").find("\u00a0"), std::string::npos) << "the first that is none";
  EXPECT_EQ(printable(""), "");
}

}  // namespace
}  // namespace carom
