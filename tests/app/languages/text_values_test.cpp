// The places of values in texts, and the keys that texts name.
#include "app/languages/text_values.h"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

namespace carom {
namespace {

TEST(TranslationRules, KeysStandAlone) {
  using Keys = std::set<std::string>;
  EXPECT_EQ(keysOf("L’observateur, l'anneau de A, A's ring, B’s", false).sure, (Keys{"A", "B"}));
  EXPECT_EQ(keysOf("Aのリングが、F12で見えます。", false).sure, (Keys{"A", "F12"}));
  EXPECT_EQ(keysOf("γβL/c, 3D, F123, km², Å, Ä, CAVE, {:.2F} J", false).sure, Keys{"J"});
  EXPECT_EQ(keysOf("Y a-t-il un palet ?", false).sure, Keys());
  EXPECT_EQ(keysOf("Y a-t-il un palet ?", false).all, Keys{"Y"});
  EXPECT_EQ(keysOf("A puck: H lists, I steer", true).sure, Keys{"H"});
  EXPECT_EQ(keysOf("F{} F5", false).sure, (Keys{"F", "F5"}));
}

TEST(TextValues, AreInTheOrderOfTheirNumbers) {
  using Values = std::vector<TextValue>;
  EXPECT_EQ(valuesOf("{} at {:.2f}").values, (Values{{"0", ""}, {"1", ".2f"}}));
  EXPECT_EQ(valuesOf("{1:.2f} of {0}").values, (Values{{"0", ""}, {"1", ".2f"}}));
  EXPECT_EQ(valuesOf("{name}").values, (Values{{"name", ""}}));
  EXPECT_TRUE(valuesOf("none").values.empty());
  EXPECT_EQ(wordsFor(valuesOf("{1:.2f} of {0}").values), "{0} {1:.2f}");
  EXPECT_EQ(wordsFor({}), "none");
}

TEST(TextValues, BracesHaveTheirPartners) {
  for (const char* whole : {"", "{}", "{0}{1}", "a {:.0f} %"}) EXPECT_EQ(valuesOf(whole).fault, "") << whole;
  EXPECT_TRUE(valuesOf("a }").fault.starts_with("a '}' without its '{'"));
  EXPECT_TRUE(valuesOf("a {").fault.starts_with("a '{' without its '}'"));
  EXPECT_TRUE(valuesOf("{ {}").fault.starts_with("a '{' without its '}'"));
  EXPECT_TRUE(valuesOf("{{}}").fault.starts_with("'{{', which no text has"));
  EXPECT_TRUE(valuesOf("{} {0}").fault.starts_with("places of values with and without numbers"));
}

TEST(TextValues, OfSlidersAreThoseOfPrintf) {
  using Values = std::vector<std::string>;
  EXPECT_EQ(printfValuesOf("%.2f m/s of %-3ld"), (Values{"%.2f", "%-3ld"}));
  EXPECT_EQ(printfValuesOf("{:.0f} % and 100 %"), Values{});
  EXPECT_EQ(printfValuesOf("%s%n"), (Values{"%s", "%n"}));
}

}  // namespace
}  // namespace carom
