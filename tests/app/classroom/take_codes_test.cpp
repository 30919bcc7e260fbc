// Codes of pages to take home: an hour for each, and no guessing.
#include "app/classroom/take_codes.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "app/class_server/class_address.h"

namespace carom {
namespace {

using Answer = TakeCodes::Answer;
constexpr const char *kHome = "192.168.1.7", *kOther = "192.168.1.8";

TEST(TakeCodes, GiveTheirOwnPageAlone) {
  TakeCodes codes;
  codes.keep("AAAAAAAA", "Anna's", 0.0);
  codes.keep("BBBBBBBB", "Ben's", 1.0);
  EXPECT_EQ(*codes.find("AAAAAAAA", kHome, 2.0).page, "Anna's");
  EXPECT_EQ(*codes.find("BBBBBBBB", kHome, 2.0).page, "Ben's");
  for (const char* other : {"", "AAAAAAAB", "aaaaaaaa", "AAAAAAAA/", "AAAAAAA"}) {
    EXPECT_EQ(codes.find(other, kOther, 2.0).answer, Answer::unknown) << other;
    EXPECT_EQ(codes.find(other, kOther, 2.0).page, nullptr) << other;
  }
}

TEST(TakeCodes, LastAnHour) {
  TakeCodes codes;
  codes.keep("AAAAAAAA", "Anna's", 100.0);
  EXPECT_EQ(codes.find("AAAAAAAA", kHome, 100.0 + 3599.0).answer, Answer::page);
  EXPECT_EQ(codes.find("AAAAAAAA", kHome, 100.0 + 3600.0).answer, Answer::expired);
  EXPECT_EQ(codes.find("AAAAAAAA", kHome, 100.0 + 7200.0).page, nullptr);
  EXPECT_EQ(codes.find("AAAAAAAA", kHome, 100.0 + 25.0 * 3600.0).answer, Answer::unknown) << "forgotten";
}

TEST(TakeCodes, AreOfferedForAWhile) {
  TakeCodes codes;
  EXPECT_EQ(codes.offered(0.0), "");
  codes.keep("AAAAAAAA", "Anna's", 10.0);
  EXPECT_EQ(codes.offered(99.0), "AAAAAAAA");
  EXPECT_EQ(codes.offered(100.5), "");
  codes.keep("BBBBBBBB", "Ben's", 110.0);
  EXPECT_EQ(codes.offered(111.0), "BBBBBBBB");
  EXPECT_EQ(codes.offered(5000.0), "");
}

TEST(TakeCodes, AreSilentForAMinuteAfterTenGuesses) {
  TakeCodes codes;
  codes.keep("AAAAAAAA", "Anna's", 0.0);
  for (int i = 0; i < 10; ++i)
    EXPECT_EQ(codes.find("WRONG" + std::to_string(i), kOther, i).answer, Answer::unknown) << i;
  EXPECT_EQ(codes.find("AAAAAAAA", kOther, 10.0).answer, Answer::silence) << "also the right one";
  EXPECT_EQ(codes.find("AAAAAAAA", kOther, 59.0).answer, Answer::silence);
  EXPECT_EQ(codes.find("AAAAAAAA", kHome, 10.0).answer, Answer::page) << "somebody else";
  EXPECT_EQ(codes.find("AAAAAAAA", kOther, 60.5).answer, Answer::page) << "a minute after the first guess";
}

TEST(TakeCodes, KeepTheNewestPages) {
  TakeCodes codes;
  for (std::size_t i = 0; i <= TakeCodes::kMostPages; ++i)
    codes.keep("CODE" + std::to_string(i), std::to_string(i), static_cast<double>(i));
  EXPECT_EQ(codes.find("CODE0", kHome, 100.0).answer, Answer::expired);
  for (std::size_t i = 1; i <= TakeCodes::kMostPages; ++i)
    EXPECT_EQ(*codes.find("CODE" + std::to_string(i), kHome, 100.0).page, std::to_string(i));
}

TEST(TakeCodes, AreDrawnByChance) {
  std::set<std::string> drawn;
  std::set<char> letters;
  for (int i = 0; i < 1000; ++i) {
    const std::string code = anyTakeCode();
    ASSERT_EQ(code.size(), 8U);
    drawn.insert(code);
    letters.insert(code.begin(), code.end());
  }
  EXPECT_EQ(drawn.size(), 1000U);
  EXPECT_EQ(letters.size(), 24U) << "all but I and O, which look like 1 and 0";
}

}  // namespace
}  // namespace carom
