// Words from outside: what stays, what is left out, what stands in the place of bytes that are no text.
#include "engine/text/plain_words.h"

#include <gtest/gtest.h>

#include <random>

namespace carom {
namespace {

constexpr std::size_t kMany = 1000;

TEST(PlainWords, KeepLettersOfAllWritings) {
  EXPECT_EQ(plainWords("<script>alert(1)</script>", kMany), "<script>alert(1)</script>")
      << "pages show it as text";
  EXPECT_EQ(plainWords("γ = 1.25, weiß, 光, 🙂", kMany), "γ = 1.25, weiß, 光, 🙂");
  EXPECT_EQ(plainWords("", kMany), "");
}

TEST(PlainWords, LeaveOutWhatShowsNothingOrTurnsTheDirection) {
  EXPECT_EQ(plainWords("a\u202eb\u200fc\u2066d\u061ce", kMany), "abcde") << "marks of direction";
  EXPECT_EQ(plainWords(std::string("a\0b\x1b[31m\x7f\u0085", 11), kMany), "ab[31m") << "controls";
  EXPECT_EQ(plainWords("a\u00adb\u200bc\u2028d\ufeffe", kMany), "abcde") << "signs without width";
}

TEST(PlainWords, StandOnOneLine) {
  EXPECT_EQ(plainWords("one\r\ntwo\tthree\nfour", kMany), "one two three four");
}

TEST(PlainWords, AreCutBySignsNotByBytes) {
  EXPECT_EQ(plainWords("äbc", 2), "äb");
  EXPECT_EQ(plainWords("光🙂x", 2), "光🙂");
  EXPECT_EQ(plainWords("\u202e\u202ea", 1), "a") << "what is left out does not count";
  EXPECT_EQ(plainWords("a", 0), "");
}

TEST(PlainWords, HaveAQuestionMarkForEachByteThatIsNoUtf8) {
  EXPECT_EQ(plainWords("a\xff"
                       "b",
                       kMany),
            "a?b");
  EXPECT_EQ(plainWords("\xc3", kMany), "?") << "cut";
  EXPECT_EQ(plainWords("\xe2\x80"
                       "a",
                       kMany),
            "??a")
      << "cut";
  EXPECT_EQ(plainWords("\xc0\x8a", kMany), "??") << "a line feed in too many bytes";
  EXPECT_EQ(plainWords("\xe0\x80\x8a", kMany), "???") << "a line feed in too many bytes";
  EXPECT_EQ(plainWords("\xed\xa0\x80", kMany), "???") << "half of a pair";
  EXPECT_EQ(plainWords("\xf4\x90\x80\x80", kMany), "????") << "above the last sign";
}

TEST(PlainWords, OfAnyBytesStayAsTheyAre) {
  for (unsigned seed = 1; seed <= 2000; ++seed) {
    std::mt19937 random(seed);
    std::string bytes;
    for (unsigned i = 0; i < 40; ++i)
      bytes += static_cast<char>(random() % 3 == 0 ? 0x80 + random() % 128 : random() % 256);
    const std::string words = plainWords(bytes, 30);
    EXPECT_EQ(plainWords(words, 30), words) << "seed " << seed;
  }
}

}  // namespace
}  // namespace carom
