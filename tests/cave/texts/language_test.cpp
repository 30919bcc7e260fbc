// The words of a language, and its forms for counts.
#include "cave/texts/language.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <regex>
#include <string>

#include "cave/texts/format.h"
#include "cave/texts/some_french.h"
#include "cave/texts/texts.h"

namespace carom::texts {
namespace {

using test::french;

TEST(Languages, WordsChangeWithTheOneInUseOnThisThread) {
  const Language made = french();
  {
    const InLanguage use(&made);
    EXPECT_STREQ(legend::kMe, "vous");
    EXPECT_STREQ(legend::kFrozen, "frozen view: walk around it") << "no words: English";
    EXPECT_EQ(languageCode(), "fr");
    {
      const InLanguage english(nullptr);
      EXPECT_STREQ(legend::kMe, "you");
    }
    EXPECT_EQ(other("red"), "rouge");
    EXPECT_EQ(other("left 12"), "gauche 12");
    EXPECT_EQ(other("right 12"), "right 12");
    EXPECT_EQ(other("12"), "12");
    EXPECT_EQ(other("1.2 c"), "1,2 c");
    EXPECT_EQ(format(message::kStroke, "red", 1.25, 10.0, ""),
              "Votre coup va à  red en 1,2 s, et revient en 10,0 s");
  }
  EXPECT_STREQ(legend::kMe, "you");
}

TEST(Languages, ACountChoosesItsForm) {
  const Language made = french();
  const InLanguage use(&made);
  EXPECT_EQ(format(console::kPucksAndLight, 0, 1.42), "0 palet, 1,42 m/s");
  EXPECT_EQ(format(console::kPucksAndLight, 1, 1.42), "1 palet, 1,42 m/s");
  EXPECT_EQ(format(console::kPucksAndLight, 2, 1.42), "2 palets, 1,42 m/s");
  EXPECT_EQ(pluralForm("en", 0), 1U);
  EXPECT_EQ(pluralForm("fr", 1.5), 0U);
  EXPECT_EQ(pluralForm("de", 1.5), 1U);
  EXPECT_EQ(pluralForm("ja", 7), 0U);
  EXPECT_EQ(pluralForms("ja"), 1U);
}

// Another node has every word of a language by one line.
TEST(Languages, GoThroughALineUnchanged) {
  for (const Language& made : {french(), Language::pseudo(), Language("ja")}) {
    const std::string line = made.packed();
    EXPECT_EQ(line.find('\n'), std::string::npos);
    const Language read = Language::unpacked(line);
    EXPECT_EQ(read.code(), made.code());
    EXPECT_STREQ(read.digits().point, made.digits().point);
    for (const Entry& entry : catalogue()) {
      ASSERT_STREQ(read.words(entry.text), made.words(entry.text)) << entry.name;
      for (const double count : {0.0, 1.0, 2.0})
        ASSERT_STREQ(read.wordsFor(entry.text, count), made.wordsFor(entry.text, count)) << entry.name;
    }
    for (const char* const name : {"red", "left 12", "no such name", "1.2 c"})
      EXPECT_EQ(read.other(name), made.other(name)) << name;
  }
}

/// Returns the number of letters of UTF-8 outside of places for values.
std::size_t lettersOf(const std::string& text) {
  const std::string words = std::regex_replace(text, std::regex("\\{[^}]*\\}"), "");
  return static_cast<std::size_t>(std::ranges::count_if(
      words, [](char letter) { return (static_cast<unsigned char>(letter) & 0xC0U) != 0x80U; }));
}

TEST(Pseudo, WordsAreLongerAndInBracketsAndKeysAndValuesStay) {
  const Language made = Language::pseudo();
  const InLanguage use(&made);
  for (const Entry& entry : catalogue()) {
    const std::string english = entry.text.english(), words = entry.text.words();
    if (words == english) continue;
    EXPECT_NE(words.find('['), std::string::npos) << words;
    EXPECT_EQ(words.find_last_not_of(' '), words.rfind(']')) << words;
    EXPECT_GE(static_cast<double>(lettersOf(words)), 1.4 * static_cast<double>(lettersOf(english)) - 2.0)
        << words;
    EXPECT_EQ(std::ranges::count(words, '{'), std::ranges::count(english, '{')) << words;
  }
  EXPECT_STREQ(lesson::kLeave, "[Léåvé  F7--]");
  EXPECT_STREQ(cue::kSpeed, "{:.2f} c");
  EXPECT_EQ(other("red"), "[réd]");
}

}  // namespace
}  // namespace carom::texts
