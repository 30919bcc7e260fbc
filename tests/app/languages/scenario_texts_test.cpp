// The texts of scenarios that visitors read: their names and places.
#include "app/languages/scenario_texts.h"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

#include "app/languages/po_text.h"
#include "app/temporary_folder.h"
#include "cave/texts/numbered_name.h"

namespace carom {
namespace {

using test::kMine;
using test::TemporaryFolder;

TEST(ScenarioTexts, EachTextThatIsReadHasItsNameAndPlace) {
  const TemporaryFolder folder;
  std::string all;
  for (const SourceText& text : scenarioTexts(folder.file("mine.toml", kMine)))
    all += text.context + " = " + text.english + " (" + text.reference + ")\n";
  EXPECT_EQ(all,
            "mine.toml title = My game (mine.toml:1)\n"
            "mine.toml name left = left (mine.toml:5)\n"
            "mine.toml name a lamp = a lamp (mine.toml:14)\n"
            "mine.toml caption 1 text = Look (mine.toml:17)\n"
            "mine.toml caption 1 hand_text = Point (mine.toml:18)\n"
            "mine.toml lesson question = Which? (mine.toml:21)\n"
            "mine.toml lesson answer 1 = This (mine.toml:22)\n"
            "mine.toml lesson answer 2 = That (mine.toml:22)\n"
            "mine.toml lesson todo = Do (mine.toml:23)\n"
            "mine.toml lesson notice = See (mine.toml:24)\n"
            "mine.toml lesson number = So (mine.toml:25)\n"
            "mine.toml lesson observer 1 name = at rest (mine.toml:28)\n"
            "mine.toml lesson stopwatch 1 name = Seen (mine.toml:31)\n"
            "mine.toml task 1 name = First (mine.toml:34)\n"
            "mine.toml task 1 text = Hit it (mine.toml:35)\n");
  EXPECT_EQ(texts::nameWithoutNumber("left 12"), "left");
  EXPECT_EQ(texts::nameWithoutNumber("struck fast"), "struck fast");
  EXPECT_EQ(texts::nameWithoutNumber("17"), "");
}

TEST(ScenarioTexts, NoTwoShippedTextsHaveOneName) {
  const std::vector<SourceText> all = shippedScenarioTexts();
  std::set<std::string> names;
  for (const SourceText& text : all) EXPECT_TRUE(names.insert(text.context).second) << text.context;
  EXPECT_GT(all.size(), 400U);
  EXPECT_TRUE(names.contains("welcome.toml caption 2 text"));
  EXPECT_TRUE(names.contains("angles.toml name slow"));
}

}  // namespace
}  // namespace carom
