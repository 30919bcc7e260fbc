// Languages from their files, and what can be translated in a scenario.
#include "app/languages/language_files.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "app/languages/po_template.h"
#include "app/languages/scenario_texts.h"
#include "app/temporary_folder.h"
#include "cave/texts/numbered_name.h"

namespace carom {
namespace {

using test::TemporaryFolder;

std::string headOf(const std::string& language) {
  return "msgid \"\"\nmsgstr \"\"\n\"Language: " + language +
         "\\n\"\n\"Content-Type: text/plain; charset=UTF-8\\n\"\n\n";
}

std::string entry(const std::string& name, const std::string& english, const std::string& words) {
  return "msgctxt " + quotedPo(name) + "\nmsgid " + quotedPo(english) + "\nmsgstr " + quotedPo(words) +
         "\n\n";
}

/// A text of the catalogue without values, keys or plural.
const texts::Entry& plainText() {
  for (const texts::Entry& one : texts::catalogue()) {
    if (std::string_view(one.name) == "tile.kBestShot") return one;
  }
  throw std::logic_error("there is no tile.kBestShot");
}

/// Returns what a language that is refused says.
std::string refusalOf(const std::string& given, const LetterFonts& fonts = {}) {
  try {
    loadLanguage(given, fonts);
  } catch (const std::exception& error) {
    return error.what();
  }
  return "taken";
}

const std::string kMine =
    "title = \"My game\"\nlight_speed_m_s = 1.4\n\n[[puck]]\nname = \"left 1\"\n\n[[puck]]\nname = \"left "
    "2\"\n\n"
    "[[puck]]\nname = \"B\"\n\n[[flash]]\nname = \"a lamp\"\n\n[[caption]]\ntext = \"Look\"\nhand_text = "
    "\"Point\"\n\n"
    "[lesson]\nquestion = \"Which?\"\nanswers = [\"This\", \"That\"]\ntodo = \"Do\"\nnotice = "
    "\"See\"\nnumber = \"So\"\n\n"
    "[[lesson.observer]]\nname = \"at rest\"\n\n[[lesson.stopwatch]]\nname = \"Seen\"\n\n"
    "[[task]]\nname = \"First\"\ntext = \"Hit it\"\n";

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

TEST(PoTemplate, TheSameTextsGiveTheSameBytesWithAllNames) {
  const std::vector<SourceText> sources = sourceTexts(texts::catalogue());
  const std::string text = textOf(templateOf(sources));
  EXPECT_EQ(text, textOf(templateOf(sourceTexts(texts::catalogue()))));
  const PoFile read = parsePo("carom.pot", text);
  ASSERT_EQ(read.entries.size(), sources.size());
  for (std::size_t i = 0; i < sources.size(); ++i) {
    EXPECT_EQ(read.entries[i].context.value().words, sources[i].context);
    EXPECT_EQ(read.entries[i].id.words, sources[i].english);
    EXPECT_FALSE(read.entries[i].isTranslated());
  }
}

SourceText source(const std::string& name, const std::string& english, const std::string& plural = {}) {
  return {.context = name, .english = english, .plural = plural, .note = "Seen.", .reference = {}};
}

TEST(PoTemplate, AnUpdateKeepsTranslationsAndMarksWhatHasChanged) {
  const PoFile old =
      parsePo("a.po", headOf("fr") + "# Of the translator.\n#. Old note.\n" + entry("a", "same", "pareil") +
                          entry("b", "before", "avant") + entry("c 1", "moves", "bouge") +
                          entry("d", "goes", "part") + entry("e", "untranslated before", "") +
                          "#~ msgctxt \"f\"\n#~ msgid \"back\"\n#~ msgstr \"retour\"\n");
  const UpdatedPo now =
      updated(old, std::vector{source("a", "same"), source("b", "after"), source("c 1", "new"),
                               source("c 2", "moves"), source("e", "untranslated"), source("f", "back"),
                               source("g", "one", "many")});
  EXPECT_EQ(
      textOf(now.file),
      headOf("fr") +
          "# Of the translator.\n#. Seen.\nmsgctxt \"a\"\nmsgid \"same\"\nmsgstr \"pareil\"\n\n"
          "#. Seen.\n#, fuzzy\n#| msgid \"before\"\nmsgctxt \"b\"\nmsgid \"after\"\nmsgstr \"avant\"\n\n"
          "#. Seen.\nmsgctxt \"c 1\"\nmsgid \"new\"\nmsgstr \"\"\n\n"
          "#. Seen.\nmsgctxt \"c 2\"\nmsgid \"moves\"\nmsgstr \"bouge\"\n\n"
          "#. Seen.\nmsgctxt \"e\"\nmsgid \"untranslated\"\nmsgstr \"\"\n\n"
          "#. Seen.\nmsgctxt \"f\"\nmsgid \"back\"\nmsgstr \"retour\"\n\n"
          "#. Seen.\nmsgctxt \"g\"\nmsgid \"one\"\nmsgid_plural \"many\"\nmsgstr[0] \"\"\nmsgstr[1] \"\"\n\n"
          "#~ msgctxt \"d\"\n#~ msgid \"goes\"\n#~ msgstr \"part\"\n");
  EXPECT_EQ(now.added, 2U);
  EXPECT_EQ(now.changed, 1U);
  EXPECT_EQ(now.gone, 1U);
}

TEST(LanguageFiles, WhatIsNoLanguageIsOneSentence) {
  for (const char* given : {"../fr", "xx", "", "/etc", "fr/../fr", "FR", "fr\n"}) {
    const std::string said = refusalOf(given);
    EXPECT_TRUE(said.starts_with("there is no language '")) << said;
    EXPECT_NE(said.find("expected one of en, "), std::string::npos) << said;
    EXPECT_EQ(said.find('\n'), std::string::npos) << said;
  }
  EXPECT_EQ(loadLanguage("en", {}), nullptr);
  EXPECT_EQ(loadLanguage("pseudo", {})->code(), "pseudo");
  EXPECT_NE(refusalOf("none.po").find("none.po:1:1: there is no such file, expected a PO file"),
            std::string::npos);
}

TEST(LanguageFiles, APoFileIsReadWithItsOther) {
  const TemporaryFolder folder;
  const auto file =
      folder.file("carom.po", headOf("it") + entry(plainText().name, plainText().text.english(), "Tiro"));
  folder.file("scenarios.po", headOf("it") + entry("angles.toml name slow", "slow", "lento"));
  const auto language = loadLanguage(file.string(), {});
  EXPECT_EQ(language->code(), "it");
  EXPECT_EQ(language->other("slow"), "lento");
  EXPECT_EQ(loadLanguage((folder / "scenarios.po").string(), {})->other("slow"), "lento");
}

TEST(LanguageFiles, AnErrorInAnyFileIsAnErrorOfTheLanguage) {
  const TemporaryFolder folder;
  const auto file =
      folder.file("carom.po", headOf("it") + entry(plainText().name, plainText().text.english(), "Tiro {}"));
  EXPECT_TRUE(
      refusalOf(file.string()).starts_with(file.string() + ":8:8: text 'tile.kBestShot' has the values {0}"))
      << refusalOf(file.string());
  folder.file("carom.po", headOf("it"));
  folder.file("scenarios.po", headOf("fr") + "msgid \"a");
  EXPECT_NE(refusalOf(file.string()).find("scenarios.po:6:7: the string has no end"), std::string::npos);
}

TEST(LanguageFiles, ALanguageWithoutAFontNamesThePackage) {
  const TemporaryFolder folder;
  const auto file = folder.file(
      "carom.po", headOf("ja") + entry(plainText().name, plainText().text.english(), "最高の一打"));
  LetterFonts fonts{[](std::string_view) { return std::u32string(U"最高の一打"); },
                    [] { return std::string("fonts-ipafont-gothic"); }};
  EXPECT_EQ(refusalOf(file.string(), fonts),
            "language 'ja': no font here has 5 of its 5 letters, expected the package fonts-ipafont-gothic "
            "(apt-get install "
            "fonts-ipafont-gothic)");
  fonts.missingPackage = [] { return std::string(); };
  EXPECT_EQ(refusalOf(file.string(), fonts), "taken");  // boxes: no package would help
}

TEST(LanguageFiles, AScenarioOfOnesOwnHasItsWordsBesideIt) {
  const TemporaryFolder folder;
  const auto mine = folder.file("mine.toml", kMine);
  texts::Language french("fr");
  EXPECT_FALSE(addWordsBeside(mine, french));
  folder.file("mine.fr.po", headOf("fr") + entry("title", "My game", "Mon jeu") +
                                entry("mine.toml name left", "left", "gauche") +
                                entry("mine.toml lesson todo", "old", "vieux"));
  EXPECT_TRUE(addWordsBeside(mine, french));
  EXPECT_EQ(french.other("My game"), "Mon jeu");
  EXPECT_EQ(french.other("left"), "gauche");
  EXPECT_EQ(french.other("Do"), "Do");
  const ReadTranslation read = readTranslation(folder / "mine.fr.po", {});
  EXPECT_EQ(read.rules.sources.size(), 15U);
  EXPECT_EQ(read.judged.translated.size(), 2U);
  folder.file("mine.fr.po", headOf("de"));
  EXPECT_THROW(addWordsBeside(mine, french), InputErrors);
}

TEST(LanguageFiles, EveryShippedLanguageIsWhole) {
  for (const LanguageProgress& progress : progressOfLanguages()) {
    EXPECT_EQ(progress.fault, "") << progress.code;
    EXPECT_EQ(progress.texts.translated, progress.texts.all) << progress.code;
    EXPECT_EQ(progress.games.translated, progress.games.all) << progress.code;
    for (const char* file : {"carom.po", "scenarios.po"}) {
      for (const Finding& finding :
           readTranslation(folderOfLanguage(progress.code) / file, {}).judged.findings)
        ADD_FAILURE() << progress.code << '/' << file << ':' << finding.at.line << ": " << finding.text;
    }
  }
}

}  // namespace
}  // namespace carom
