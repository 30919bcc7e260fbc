// Translations as their makers meet them: templates, and what carom check says of files that are wrong.
#include "app/file_tools/texts.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "app/program.h"

namespace carom {
namespace {

using test::ProgramResult;
using test::runCarom;
using test::TemporaryFolder;

const std::string kHead =
    "msgid \"\"\nmsgstr \"\"\n\"Language: de\\n\"\n\"Content-Type: text/plain; charset=UTF-8\\n\"\n"
    "\"Plural-Forms: nplurals=2; plural=(n != 1);\\n\"\n\n";
const std::string kReading = "msgctxt \"lesson.kReading\"\nmsgid \"{}: {:.2f} s\"\nmsgstr ";
const std::string kFrames =
    "msgctxt \"console.kFrames\"\nmsgid \"{} frame since the session began\"\nmsgid_plural \"{} frames since "
    "the "
    "session began\"\nmsgstr[0] \"{} Bild seit Beginn\"\nmsgstr[1] ";
const std::string kBestShot = "msgctxt \"tile.kBestShot\"\nmsgid \"Best shot\"\nmsgstr ";

TEST(Texts, TheTemplatesAreTheSameBytesEachTime) {
  const TemporaryFolder folder;
  for (const char* name : {"one", "two"})
    EXPECT_EQ(runCarom(folder, {"texts", "--pot", (folder / name).string()}).status, 0);
  for (const char* name : {"carom.pot", "scenarios.pot"}) {
    const std::string text = test::contentOf(folder / "one" / name);
    EXPECT_GT(text.size(), 40'000U);
    EXPECT_EQ(text, test::contentOf(folder / "two" / name));
  }
  const std::string games = test::contentOf(folder / "one/scenarios.pot");
  EXPECT_NE(games.find("\n#: angles.toml:"), std::string::npos);
  EXPECT_NE(games.find("\nmsgctxt \"angles.toml name slow\"\nmsgid \"slow\"\nmsgstr \"\"\n"),
            std::string::npos);
}

TEST(Texts, AScenarioOfOnesOwnHasItsTemplate) {
  const TemporaryFolder folder;
  const std::string mine = folder.file("mine.toml", "title = \"My game\"\nlight_speed_m_s = 1\n").string();
  EXPECT_EQ(runCarom(folder, {"texts", "--pot", (folder / ".").string(), "--scenario", mine}).status, 0);
  const std::string text = test::contentOf(folder / "mine.pot");
  EXPECT_NE(text.find("msgctxt \"mine.toml title\"\nmsgid \"My game\"\nmsgstr \"\"\n"), std::string::npos);
}

TEST(Texts, WhatCannotBeDoneIsOneSentence) {
  const TemporaryFolder folder;
  struct Case {
    std::vector<std::string> arguments;
    const char* said;
  };
  for (const Case& one :
       {Case{{"texts", "--update", "../fr"}, "error: there is no language '../fr', expected one of en"},
        Case{{"texts", "--pot", "/dev/null/x"}, "cannot be written"},
        Case{{"texts"}, "error: --pot DIR or --update CODE is required"},
        Case{{"texts", "--pot", "x", "--update", "fr"}, "--help for what is expected"}}) {
    const ProgramResult result = runCarom(folder, one.arguments);
    EXPECT_NE(result.status, 0);
    EXPECT_NE(result.err.find(one.said), std::string::npos) << result.err;
  }
}

TEST(Texts, CheckTellsWhatIsWrongWithATranslation) {
  const TemporaryFolder folder;
  std::string windows = "\xEF\xBB\xBF";
  for (const char c : kHead + kBestShot + "\"Bester Stoß\"\n")
    windows += c == '\n' ? "\r\n" : std::string(1, c);
  std::string million = kHead;
  for (int i = 0; i < 1'000'000; ++i) million += "msgid \"\"\nmsgstr\"\"\n";
  struct Case {
    const char* what;
    std::string content;
    int status;
    const char* said;
  };
  for (const Case& one : {
           Case{"cut in the middle", kHead + kBestShot + "\"Bester St", 1, ":9:8: the string has no end"},
           Case{"CR LF and a byte order mark", windows, 0, "de: 1 of "},
           Case{"Latin-1", kHead + kBestShot + "\"Bester Sto\xDF\"\n", 1,
                ":9:19: the byte 0xDF is not UTF-8"},
           Case{"a million entries", million, 1, ": the file is too large, 18 MiB, expected at most 16 MiB"},
           Case{"20 001 entries", kHead + million.substr(kHead.size(), 20'001 * 18), 1,
                "more than 20000 entries"},
           Case{"another format", kHead + kReading + "\"{}: {:s} s\"\n", 1,
                ":9:8: text 'lesson.kReading' has the values {0} {1:s}, expected {0} {1:.2f} as in English"},
           Case{"a value too far", kHead + kReading + "\"{9}: {1:.2f} s\"\n", 1,
                ":9:8: text 'lesson.kReading' has the values"},
           Case{"double braces", kHead + kReading + "\"{{}}: {:.2f} s\"\n", 1,
                ":9:8: text 'lesson.kReading' has '{{'"},
           Case{"an open brace", kHead + kReading + "\"{}: {:.2f s\"\n", 1, "has a '{' without its '}'"},
           Case{"no header", kBestShot + "\"Bester Stoß\"\n", 1, ":1:1: there is no header"},
           Case{"a foreign Plural-Forms",
                "msgid \"\"\nmsgstr \"\"\n\"Language: de\\n\"\n\"Plural-Forms: nplurals=3; plural=0;\\n\"\n",
                1, ":2:8: Plural-Forms is 'nplurals=3; plural=0;', expected nplurals=2"},
           Case{"an empty msgstr[1]", kHead + kFrames + "\"\"\n", 1,
                ":11:11: text 'console.kFrames' has an empty msgstr[1]"},
           Case{"a right-to-left mark", kHead + kBestShot + "\"Bester\xE2\x80\x8F Stoß\"\n", 1,
                ":9:8: text 'tile.kBestShot' has a mark of direction, U+200F: right-to-left text is not "
                "drawn yet"},
           Case{"a letter of no font", kHead + kBestShot + "\"Bester \xF0\x9F\x82\xA1\xF3\xB0\x80\x80\"\n", 0,
                "has letters that no font has, drawn as a box: "},
           Case{"another version", kHead + "msgctxt \"tile.kOfBefore\"\nmsgid \"a\"\nmsgstr \"b\"\n", 0,
                ":7:9: text 'tile.kOfBefore' is not in this version: its translation is not used"},
           Case{"a nul byte", kHead + kBestShot + std::string("\"Be\0ster\"\n", 10), 1,
                ":9:11: the control sign U+0000"},
           Case{"another key",
                kHead + "msgctxt \"lesson.kLeave\"\nmsgid \"Leave  F7\"\nmsgstr \"Verlassen  F8\"\n", 1,
                ":9:8: text 'lesson.kLeave' names the keys F8, expected F7 as in English"},
           Case{"a name twice", kHead + kBestShot + "\"Bester Stoß\"\n\n" + kBestShot + "\"Bester Stoß\"\n",
                1, ":11:9: text 'tile.kBestShot' stands twice, the first time on line 7"},
       }) {
    const ProgramResult result = runCarom(folder, {"check", folder.file("de.po", one.content).string()});
    EXPECT_EQ(result.status, one.status) << one.what << "\n" << result.err;
    EXPECT_NE((result.err + result.out).find(one.said), std::string::npos) << one.what << "\n"
                                                                           << result.err << result.out;
    EXPECT_LE(std::count(result.err.begin(), result.err.end(), '\n'), 101) << one.what;
  }
}

TEST(Texts, CheckTellsAScenariosOwnTranslation) {
  const TemporaryFolder folder;
  folder.file("mine.toml", "title = \"My game\"\nlight_speed_m_s = 1\n");
  const std::string po =
      folder.file("mine.de.po", kHead + "msgctxt \"title\"\nmsgid \"My game\"\nmsgstr \"Mein Spiel\"\n")
          .string();
  const ProgramResult result = runCarom(folder, {"check", po});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(result.err, "");
  EXPECT_EQ(result.out, "de: 1 of 1 texts are translated\n");
}

}  // namespace
}  // namespace carom
