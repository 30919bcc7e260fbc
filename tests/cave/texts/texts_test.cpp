#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <regex>
#include <set>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "cave/texts/format.h"
#include "cave/texts/language.h"
#include "cave/texts/saying.h"
#include "cave/texts/texts.h"

namespace carom::texts {
namespace {

/// A language in which some texts have words.
Language french() {
  Language made("fr");
  made.put(message::kStroke.index(), {"Votre coup va à {3} {0} en {1:.1f} s, et revient en {2:.1f} s"});
  made.put(message::kRightOfCentre.index(), {"{:.0f} mm à droite de"});
  made.put(console::kPucksAndLight.index(), {"{} palet, {:.4g} m/s", "{} palets, {:.4g} m/s"});
  made.put(legend::kMe.index(), {"vous"});
  made.putOther("red", "rouge");
  made.putOther("left", "gauche");
  return made;
}

TEST(Catalogue, ATextStandsAtItsNumber) {
  ASSERT_GT(catalogue().size(), 600U);
  std::set<std::string> names;
  for (std::size_t i = 0; i < catalogue().size(); ++i) {
    EXPECT_EQ(catalogue()[i].text.index(), i);
    EXPECT_TRUE(names.insert(catalogue()[i].name).second) << catalogue()[i].name;
  }
  // The constants are numbered by another macro than the table.
  for (const auto& [name, text] : {std::pair{"tile.kBestShot", tile::kBestShot},
                                   {"message.kDeviceLost 3", message::kDeviceLost[2]},
                                   {"message.kStroke", message::kStroke},
                                   {"latency.kWallColumns 3", latency::kWallColumns[2]},
                                   {"console.kPucksAndLight", console::kPucksAndLight},
                                   {"page.liveHeld", page::liveHeld}}) {
    EXPECT_EQ(textNamed(name), text) << name;
    EXPECT_STREQ(catalogue()[text.index()].text.english(), text.english());
    EXPECT_EQ(catalogue()[text.index()].name, name);
  }
  EXPECT_FALSE(textNamed("message.kNone"));
  EXPECT_FALSE(Text());
}

TEST(Catalogue, EnglishIsWhatStandsThere) {
  EXPECT_STREQ(message::kNoFlight.words(), "This game has no round trip.");
  EXPECT_EQ(languageCode(), "en");
  EXPECT_EQ(other("red"), "red");
  EXPECT_EQ(format(console::kPucksAndLight, 1, 1.42), "1 puck, light at 1.42 m/s");
  EXPECT_EQ(format(console::kPucksAndLight, std::size_t{2}, 1.42), "2 pucks, light at 1.42 m/s");
}

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

TEST(Languages, NumbersHaveTheSignsOfTheirLanguage) {
  const auto written = [](const char* code, auto value, const char* how) {
    const Language made(code);
    const InLanguage use(&made);
    return fmt::vformat(how, fmt::make_format_args(localized(value)));
  };
  EXPECT_EQ(written("fr", 1234.5, "{:.1f}"), "1234,5") << "four digits stay together";
  EXPECT_EQ(written("fr", 12345.5, "{:.1f}"), "12\u202F345,5");
  EXPECT_EQ(written("de", -1234567, "{}"), "-1\u202F234\u202F567");
  EXPECT_EQ(written("ja", 12345.5, "{:.1f}"), "12345.5");
  EXPECT_EQ(written("de", 0.5, "{:7.2f}"), "   0,50");
  EXPECT_EQ(written("fr", 1.5e10, "{:.3g}"), "1,5e+10");
  EXPECT_EQ(written("fr", std::nan(""), "{:.1f}"), "nan");
}

TEST(Languages, NumbersAreTheSameButForTheirSigns) {
  std::mt19937_64 random(44);
  std::uniform_real_distribution<double> size(-9.0, 12.0);
  const Language made("fr");
  for (int i = 0; i < 2000; ++i) {
    const double value = std::pow(10.0, size(random)) * (i % 2 ? 1.0 : -1.0);
    for (const char* const how : {"{:.2f}", "{:g}", "{:.0f}", "{:9.3f}"}) {
      const InLanguage use(&made);
      std::string text = fmt::vformat(how, fmt::make_format_args(localized(value)));
      std::string plain;
      for (std::size_t at = 0; at < text.size(); ++at) {
        if (text.compare(at, 3, "\u202F") == 0) {
          at += 2;
        } else {
          plain += text[at] == ',' ? '.' : text[at];
        }
      }
      EXPECT_EQ(plain, fmt::format(fmt::runtime(how), value)) << "seed 44, " << value << " as " << how;
    }
  }
}

TEST(Sayings, AreInEnglishWhatFormatWrites) {
  const Saying saying = say(message::kStroke, "red", 1.25, 2.0, say(message::kRightOfCentre, 12.0));
  EXPECT_EQ(saying.english(),
            format(message::kStroke, "red", 1.25, 2.0, format(message::kRightOfCentre, 12.0)));
  EXPECT_EQ(saying.line(), R"([["message.kStroke","red",1.25,2.0,[["message.kRightOfCentre",12.0]]]])");
  EXPECT_EQ(say(message::kCarom, 3).english(), format(message::kCarom, 3));
  EXPECT_TRUE(Saying().empty());
  EXPECT_EQ(Saying().english(), "");
}

TEST(Sayings, AreTurnedByWhoReadsThem) {
  const Saying saying = say(message::kStroke, "red", 1.25, 2.0, say(message::kRightOfCentre, 12.0)) +
                        Saying(" – ") + Saying(legend::kMe);
  const Saying read = Saying::read(saying.line());
  EXPECT_EQ(read, saying);
  const Language made = french();
  const InLanguage use(&made);
  EXPECT_EQ(read.words(), "Votre coup va à 12 mm à droite de rouge en 1,2 s, et revient en 2,0 s – vous");
  EXPECT_EQ(read.english(), saying.english());
}

TEST(Sayings, FromOutsideDoNoHarm) {
  for (const char* const line :
       {"", "x", "[", "[]", "{}", "[1]", "[[]]", "[[1,2]]", "[[\"message.kStroke\"]]",
        "[[\"message.kStroke\",\"a\",\"b\",\"c\",\"d\"]]", "[[\"no.such\",1]]",
        "[[\"message.kCarom\",1e999]]", "[[\"message.kCarom\",null]]",
        "[[\"message.kCarom\",[[\"message.kCarom\",[[\"message.kCarom\",[[\"message.kCarom\",[["
        "\"message.kCarom\",[[\"message.kCarom\",1]]]]]]]]]]]]"}) {
    const Saying read = Saying::read(line);
    EXPECT_LT(read.words().size(), 1000U) << line;
  }
  std::mt19937 random(45);
  const std::string whole =
      say(message::kStroke, "red", 1.25, 2.0, say(message::kRightOfCentre, 12.0)).line();
  for (int i = 0; i < 20000; ++i) {
    std::string line = whole;
    for (int changes = 0; changes < 3; ++changes)
      line[random() % line.size()] = static_cast<char>(random() % 256);
    EXPECT_LT(Saying::read(line).words().size(), 1000U) << "seed 45, " << line;
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
