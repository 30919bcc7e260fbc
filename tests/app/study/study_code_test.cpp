// Codes of participants: every slip of one letter is noticed, whatever way a code is typed it is the same.
#include "app/study/study_code.h"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>

namespace carom {
namespace {

/// Luhn's sum by its table, another way than the one that is tested: the letters are doubled in turn, and a
/// doubled one that does not fit goes down by n − 1.
bool isRight(const std::string& code) {
  std::size_t sum = 0;
  for (std::size_t i = 0; i < code.size(); ++i) {
    std::size_t value = kCodeLetters.find(code[i]);
    if ((code.size() - i) % 2 == 0) value = 2 * value >= 32 ? 2 * value - 31 : 2 * value;
    sum += value;
  }
  return sum % 32 == 0;
}

TEST(StudyCode, EverySlipOfOneLetterIsNoticed) {
  for (const std::string& code : newCodes(50)) {
    ASSERT_EQ(code.size(), kCodeLength);
    EXPECT_EQ(codeOf(code), code);
    EXPECT_TRUE(isRight(code)) << code;
    for (std::size_t at = 0; at < code.size(); ++at) {
      for (const char letter : kCodeLetters) {
        std::string slip = code;
        slip[at] = letter;
        EXPECT_EQ(codeOf(slip).has_value(), slip == code) << code << " typed as " << slip;
      }
    }
  }
}

TEST(StudyCode, IsReadWithoutCaseAndWithLettersThatLookAlike) {
  // 10000 has the sum 1·1 (the fifth from the right, weight 2 from the fifth: 2, 1, 2, 1, 2): 2.
  const std::string code = std::string("10000") + checkLetterOf("10000");
  EXPECT_EQ(code, "10000Y");
  for (const char* typed : {"10000y", "lOOOOy", "IOoOo Y", "1000-0Y", " 10000Y "})
    EXPECT_EQ(codeOf(typed), code) << typed;
  for (const char* typed : {"", "10000", "10000YY", "1000!Y", "U0000Y", "10000Z", "10000\xc3\xbf"})
    EXPECT_FALSE(codeOf(typed)) << typed;
}

TEST(StudyCode, CodesDifferAndUseEveryLetter) {
  const std::vector<std::string> codes = newCodes(2000), others = newCodes(2000);
  EXPECT_EQ(std::set<std::string>(codes.begin(), codes.end()).size(), 2000U);
  EXPECT_NE(codes, others);
  for (std::size_t place = 0; place < kCodeLength; ++place) {
    std::map<char, int> count;
    for (const std::string& code : codes) ++count[code[place]];
    EXPECT_EQ(count.size(), 32U) << "place " << place;
    for (const auto& [letter, times] : count)  // 62.5 wanted; 7 standard deviations
      EXPECT_LT(std::abs(times - 62.5), 55.0) << letter << " in place " << place;
  }
}

TEST(StudyCode, SlipsAreNumbered) {
  EXPECT_EQ(slipsCsv({"10000Y", "00000 "}), "number,code\n1,10000Y\n2,00000 \n");
  const std::string page = slipsHtml("A < B", {"10000Y", "22222X"});
  EXPECT_NE(page.find("A &lt; B"), std::string::npos);
  EXPECT_NE(page.find("Number 2</p><b>22222X</b>"), std::string::npos);
}

}  // namespace
}  // namespace carom
