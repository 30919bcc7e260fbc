// Languages from their files.
#include "app/languages/language_files.h"

#include <gtest/gtest.h>

#include <string>

#include "app/languages/po_text.h"
#include "app/temporary_folder.h"

namespace carom {
namespace {

using test::bareHead;
using test::entry;
using test::kMine;
using test::TemporaryFolder;

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
      folder.file("carom.po", bareHead("it") + entry(plainText().name, plainText().text.english(), "Tiro"));
  folder.file("scenarios.po", bareHead("it") + entry("angles.toml name slow", "slow", "lento"));
  const auto language = loadLanguage(file.string(), {});
  EXPECT_EQ(language->code(), "it");
  EXPECT_EQ(language->other("slow"), "lento");
  EXPECT_EQ(loadLanguage((folder / "scenarios.po").string(), {})->other("slow"), "lento");
}

// Plates have letters of their own, which are set before anything is drawn.
TEST(LanguageFiles, LabelsOfLessonsStandOnPlates) {
  const TemporaryFolder folder;
  const auto file = folder.file(
      "scenarios.po", bareHead("de") + entry("angles.toml name slow", "slow", "träge") +
                          entry("mass-energy.toml lesson label 1 text", "hot: 2.5 M", "heiß: 2,5 M"));
  const auto language = loadLanguage(file.string(), {});
  for (const std::string& words :
       {language->plateWords(), texts::Language::unpacked(language->packed()).plateWords()}) {
    EXPECT_NE(words.find("heiß"), std::string::npos) << words;
    EXPECT_EQ(words.find("träge"), std::string::npos) << words;
  }
}

TEST(LanguageFiles, AnErrorInAnyFileIsAnErrorOfTheLanguage) {
  const TemporaryFolder folder;
  const auto file = folder.file(
      "carom.po", bareHead("it") + entry(plainText().name, plainText().text.english(), "Tiro {}"));
  EXPECT_TRUE(
      refusalOf(file.string()).starts_with(file.string() + ":8:8: text 'tile.kBestShot' has the values {0}"))
      << refusalOf(file.string());
  folder.file("carom.po", bareHead("it"));
  folder.file("scenarios.po", bareHead("fr") + "msgid \"a");
  EXPECT_NE(refusalOf(file.string()).find("scenarios.po:6:7: the string has no end"), std::string::npos);
}

TEST(LanguageFiles, ALanguageWithoutAFontNamesThePackage) {
  const TemporaryFolder folder;
  const auto file = folder.file(
      "carom.po", bareHead("ja") + entry(plainText().name, plainText().text.english(), "最高の一打"));
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
  folder.file("mine.fr.po", bareHead("fr") + entry("title", "My game", "Mon jeu") +
                                entry("mine.toml name left", "left", "gauche") +
                                entry("mine.toml lesson todo", "old", "vieux"));
  EXPECT_TRUE(addWordsBeside(mine, french));
  EXPECT_EQ(french.other("My game"), "Mon jeu");
  EXPECT_EQ(french.other("left"), "gauche");
  EXPECT_EQ(french.other("Do"), "Do");
  const ReadTranslation read = readTranslation(folder / "mine.fr.po", {});
  EXPECT_EQ(read.rules.sources.size(), 15U);
  EXPECT_EQ(read.judged.translated.size(), 2U);
  folder.file("mine.fr.po", bareHead("de"));
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
