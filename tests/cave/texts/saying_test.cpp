// Words for people before a language is chosen.
#include "cave/texts/saying.h"

#include <gtest/gtest.h>

#include <random>
#include <string>

#include "cave/texts/format.h"
#include "cave/texts/some_french.h"
#include "cave/texts/texts.h"

namespace carom::texts {
namespace {

using test::french;

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

}  // namespace
}  // namespace carom::texts
