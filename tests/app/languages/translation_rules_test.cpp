// Each rule of a translation, with a file that breaks it.
#include "app/languages/translation_rules.h"

#include <gtest/gtest.h>

#include <string>

#include "app/languages/judged_text.h"
#include "app/temporary_folder.h"
#include "engine/text/code_points.h"

namespace carom {
namespace {

using test::headOf;
using test::rulesOf;
using test::said;
using test::saidOf;
using test::TemporaryFolder;

TEST(TranslationRules, AGoodTranslationHasNoFinding) {
  const SourceText stroke{.context = "message.kStroke",
                          .english = "{} strikes {:.2f} J, F5: back",
                          .plural = {},
                          .note = {},
                          .reference = {}};
  const SourceText pucks{
      .context = "message.kPucks", .english = "{} puck", .plural = "{} pucks", .note = {}, .reference = {}};
  const std::string text = headOf("de") +
                           "msgctxt \"message.kStroke\"\nmsgid \"{} strikes {:.2f} J, F5: back\"\n"
                           "msgstr \"Mit {1:.2f} J stößt {0}, zurück mit F5\"\n\n"
                           "msgctxt \"message.kPucks\"\nmsgid \"{} puck\"\nmsgid_plural \"{} pucks\"\n"
                           "msgstr[0] \"{} Scheibe\"\nmsgstr[1] \"{} Scheiben\"\n";
  const JudgedTranslation judged = judge(parsePo("a.po", text), rulesOf({stroke, pucks}));
  EXPECT_EQ(said(text, rulesOf({stroke, pucks})), "");
  EXPECT_EQ(judged.code, "de");
  ASSERT_EQ(judged.translated.size(), 2U);
  EXPECT_EQ(judged.translated[1].source, 1U);
  EXPECT_EQ(judged.translated[1].forms, (std::vector<std::string>{"{} Scheibe", "{} Scheiben"}));
}

TEST(TranslationRules, ValuesAreThoseOfTheEnglish) {
  const auto values = [](const std::string& has, const std::string& expected) {
    return "E 9: text 'a.b' has the values " + has + ", expected " + expected + " as in English\n";
  };
  EXPECT_EQ(saidOf("light {:.2f} m/s of {}", "Licht {:s} m/s von {}"), values("{0:s} {1}", "{0:.2f} {1}"));
  EXPECT_EQ(saidOf("light {:.2f} m/s of {}", "Licht {} m/s von {:.2f}"),
            values("{0} {1:.2f}", "{0:.2f} {1}"));
  EXPECT_EQ(saidOf("light {:.2f} m/s of {}", "{1}: Licht {0:.2f} m/s"), "");
  EXPECT_EQ(saidOf("light {}", "Licht"), values("none", "{0}"));
  EXPECT_EQ(saidOf("light {}", "Licht {} {}"), values("{0} {1}", "{0}"));
  EXPECT_EQ(saidOf("light {}", "Licht {9}"), values("{9}", "{0}"));
  EXPECT_EQ(saidOf("light", "Licht {}"), values("{0}", "none"));
  EXPECT_NE(saidOf("light {}", "Licht {{}}").find("E 9: text 'a.b' has '{{'"), std::string::npos);
  EXPECT_NE(saidOf("light {}", "Licht {} {").find("has a '{' without its '}'"), std::string::npos);
  EXPECT_NE(saidOf("light {}", "Licht {} }").find("has a '}' without its '{'"), std::string::npos);
  EXPECT_NE(saidOf("light {} {}", "Licht {0} {}").find("with and without numbers"), std::string::npos);
  EXPECT_EQ(saidOf("%.2f m/s", "%.2f m/s"), "");
  EXPECT_NE(saidOf("%.2f m/s", "%n m/s").find("has the values \"%n\", expected \"%.2f\""), std::string::npos);
  EXPECT_NE(saidOf("{:.0f} % right", "{:.0f} %s richtig").find("has the values \"%s\""), std::string::npos);
}

TEST(TranslationRules, KeysAreThoseOfTheEnglish) {
  EXPECT_EQ(saidOf("Skip  Enter", "Weiter  Eingabe"), "");
  EXPECT_EQ(saidOf("Keys   H", "Tasten   H"), "");
  EXPECT_EQ(saidOf("Leave  F7", "Verlassen  F8"),
            "E 9: text 'a.b' names the keys F8, expected F7 as in English\n");
  EXPECT_EQ(saidOf("drive: W A S D", "fahren: W A S"),
            "E 9: text 'a.b' names the keys A S W, expected A D S W as in English\n");
  EXPECT_EQ(saidOf("Leave", "Verlassen  F7"),
            "E 9: text 'a.b' names the keys F7, expected none as in English\n");
  EXPECT_EQ(saidOf("A puck at rest", "Eine Scheibe ruht"), "");
  EXPECT_EQ(saidOf("What am I to do?", "Was tun?"), "");
  EXPECT_EQ(saidOf("H lists the keys", "Die Tasten"),
            "E 9: text 'a.b' names the keys none, expected H as in English\n");
}

TEST(TranslationRules, SignsThatShowNothingOrAreNotDrawnYetAreErrors) {
  EXPECT_NE(saidOf("light", "Li\ncht").find("E 9: text 'a.b' has the control sign U+000A"),
            std::string::npos);
  EXPECT_NE(saidOf("light",
                   "Li\xE2\x80\x8F"
                   "cht")
                .find("has a mark of direction, U+200F"),
            std::string::npos);
  EXPECT_NE(saidOf("light", "ضوء").find("right-to-left text is not drawn yet"), std::string::npos);
  EXPECT_NE(saidOf("light", "אור").find("right-to-left text is not drawn yet"), std::string::npos);
}

TEST(TranslationRules, LettersWithoutFontAreNamed) {
  TranslationRules rules = rulesOf({});
  rules.lettersWithoutFont = [](std::string_view text) {
    std::u32string missing;
    for (const char32_t sign : codePointsOf(text)) {
      if (sign == U'ꙮ') missing += sign;
    }
    return missing;
  };
  EXPECT_EQ(saidOf("light", "Licꙮht", rules),
            "W 9: text 'a.b' has letters that no font has, drawn as a box: 'ꙮ' (U+A66E)\n");
  EXPECT_EQ(saidOf("light", "Licht", rules), "");
}

TEST(TranslationRules, SpacesAtTheEndsAreThoseOfTheEnglish) {
  EXPECT_EQ(saidOf("Question:  ", "Frage:  "), "");
  EXPECT_NE(saidOf("Question:  ", "Frage: "), "");
  EXPECT_EQ(saidOf("Question:  ", " Frage:"),
            "W 9: text 'a.b' begins with 1 spaces and ends with 0, expected 0 and 2 as in English\n");
}

TEST(TranslationRules, WordsThatAreNotTranslatedAreNamed) {
  EXPECT_EQ(saidOf("{:.2f} c, F7, ct (m), γ, PIN, --capture, {}teacher",
                   "{:.2f} c, F7, ct (m), γ, PIN, --capture, {}teacher"),
            "");
  EXPECT_EQ(saidOf("Position {}", "Position {}"),
            "W 9: text 'a.b' is the same as in English, expected a translation, or the line \"Position = "
            "Position\" in glossary.txt\n");
  const TemporaryFolder folder;
  TranslationRules rules = rulesOf({});
  rules.glossary = Glossary::read(folder.file("glossary.txt", "position = position\n"));
  EXPECT_EQ(saidOf("Position {}", "Position {}", rules), "");
  EXPECT_NE(saidOf("Position here {}", "Position here {}", rules), "");
}

TEST(TranslationRules, PluralsHaveTheLanguagesForms) {
  const TranslationRules rules =
      rulesOf({{.context = "a.b", .english = "{} puck", .plural = "{} pucks", .note = {}, .reference = {}}});
  const std::string entry =
      "msgctxt \"a.b\"\nmsgid \"{} puck\"\nmsgid_plural \"{} pucks\"\nmsgstr[0] \"{} Scheibe\"\n";
  EXPECT_EQ(said(headOf("de") + entry, rules), "E 10: text 'a.b' has 1 forms of plural, expected 2\n");
  EXPECT_EQ(said(headOf("de") + entry + "msgstr[1] \"\"\n", rules),
            "E 11: text 'a.b' has an empty msgstr[1], expected words\n");
  EXPECT_EQ(said(headOf("de") + entry + "msgstr[1] \"Scheiben\"\n", rules),
            "E 11: text 'a.b' has the values none, expected {0} as in English\n");
  EXPECT_EQ(said(headOf("de") + entry + "msgstr[1] \"{} Scheiben\"\nmsgstr[2] \"{} Scheiben\"\n", rules),
            "E 12: text 'a.b' has 3 forms of plural, expected 2\n");
  TranslationRules japanese = rules;
  japanese.code = "ja";
  EXPECT_EQ(said(headOf("ja", "nplurals=1; plural=0;") + entry, japanese), "");
  EXPECT_NE(said(headOf("ja", "nplurals=1; plural=0;") + entry + "msgstr[1] \"{} x\"\n", japanese), "");
}

TEST(TranslationRules, TheHeaderIsOfThisLanguage) {
  const TranslationRules rules = rulesOf({});
  const std::string stroke = "msgid \"a\"\nmsgstr \"b\"\n";
  EXPECT_EQ(said(headOf("de"), rules), "");
  EXPECT_EQ(said(headOf("de_AT"), rules), "");
  EXPECT_EQ(said("# nothing\n", rules),
            "E 1: there is no header, expected an entry with an empty msgid first, which names Language, "
            "charset and "
            "Plural-Forms\n");
  EXPECT_EQ(said(headOf("fr"), rules),
            "E 2: Language is 'fr', expected 'de' here\nW 2: Plural-Forms has 'plural=n!=1', which is not "
            "used, expected plural=n>1: forms of plural come from a table of the program\n");
  EXPECT_EQ(said(headOf(""), rules), "E 2: the header names no Language, expected its code, such as fr\n");
  EXPECT_EQ(said(headOf("../x"), rules), "E 2: Language is '../x', expected a code such as fr\n");
  EXPECT_EQ(said(headOf("de", "nplurals=2; plural=n != 1;", "ISO-8859-1"), rules),
            "E 2: the charset is 'ISO-8859-1', expected UTF-8\n");
  EXPECT_EQ(said(headOf("de", "nplurals=3; plural=(n==1 ? 0 : 2);"), rules),
            "E 2: Plural-Forms is 'nplurals=3; plural=(n==1 ? 0 : 2);', expected nplurals=2: forms of plural "
            "come from a "
            "table of the program, not from the file\n");
  EXPECT_EQ(said(headOf("de", "nplurals=2; plural=(n > 1);"), rules),
            "W 2: Plural-Forms has 'plural=n>1', which is not used, expected plural=n!=1: forms of plural "
            "come from a table "
            "of the program\n");
}

TEST(TranslationRules, EntriesAreOfTextsOfToday) {
  const TranslationRules rules =
      rulesOf({{.context = "a.b", .english = "light", .plural = {}, .note = {}, .reference = {}},
               {.context = "a.c", .english = "puck", .plural = {}, .note = {}, .reference = {}}});
  const std::string light = "msgctxt \"a.b\"\nmsgid \"light\"\nmsgstr \"Licht\"\n\n";
  const std::string puck = "msgctxt \"a.c\"\nmsgid \"puck\"\nmsgstr \"Scheibe\"\n";
  EXPECT_EQ(said(headOf("de") + light + puck, rules), "");
  EXPECT_EQ(said(headOf("de") + light + puck + "\n" + light, rules),
            "E 15: text 'a.b' stands twice, the first time on line 7, expected it once\n");
  EXPECT_EQ(said(headOf("de") + light, rules), "W 10: text 'a.c' is missing: English is shown\n");
  EXPECT_EQ(said(headOf("de") + light + "msgctxt \"a.c\"\nmsgid \"puck\"\nmsgstr \"\"\n", rules),
            "W 13: text 'a.c' is not translated: English is shown\n");
  EXPECT_EQ(said(headOf("de") + light + "#, fuzzy\n" + puck, rules),
            "W 14: text 'a.c' is fuzzy: English is shown until somebody has looked at it\n");
  EXPECT_EQ(said(headOf("de") + light + "msgctxt \"a.c\"\nmsgid \"disc\"\nmsgstr \"Scheibe\"\n", rules),
            "W 12: text 'a.c' is stale, its English is another now: English is shown. carom texts --update "
            "brings it in\n");
  EXPECT_EQ(said(headOf("de") + light + puck + "\nmsgctxt \"z\"\nmsgid \"q\"\nmsgstr \"q\"\n", rules),
            "W 15: text 'z' is not in this version: its translation is not used\n");
  EXPECT_EQ(said(headOf("de") + light + puck + "\nmsgid \"q\"\nmsgstr \"q\"\n", rules),
            "E 15: the text has no msgctxt, expected its name\n");
  const std::string wrong = "msgctxt \"a.c\"\nmsgid \"puck\"\nmsgstr \"Scheibe {}\"\n";
  EXPECT_EQ(judge(parsePo("a.po", headOf("de") + light + wrong), rules).translated.size(), 1U);
  const auto translated =
      judge(parsePo("a.po", headOf("de") + light + "#, fuzzy\n" + puck), rules).translated;
  ASSERT_EQ(translated.size(), 1U);
  EXPECT_EQ(translated[0].forms, std::vector<std::string>{"Licht"});
}

TEST(TranslationRules, GamesNeedNoValuesAndOneWordForOneEnglish) {
  const TranslationRules rules = rulesOf({{.context = "a.toml title",
                                           .english = "A {",
                                           .plural = {},
                                           .note = {},
                                           .reference = {},
                                           .hasValues = false},
                                          {.context = "b.toml title",
                                           .english = "A {",
                                           .plural = {},
                                           .note = {},
                                           .reference = {},
                                           .hasValues = false}});
  const std::string text = headOf("de") +
                           "msgctxt \"a.toml title\"\nmsgid \"A {\"\nmsgstr \"A {\"\n\nmsgctxt \"b.toml "
                           "title\"\nmsgid \"A {\"\nmsgstr ";
  EXPECT_EQ(said(text + "\"A {\"\n", rules), "");
  EXPECT_EQ(said(text + "\"Das A {\"\n", rules),
            "W 13: text 'b.toml title' is translated in another way than the same English in line 9, which "
            "is shown in both places\n");
}

TEST(TranslationRules, CodesOfLanguages) {
  for (const char* code : {"fr", "haw", "pt_BR"}) EXPECT_TRUE(isLanguageCode(code)) << code;
  for (const char* code : {"", "f", "FR", "../x", "fr/", "frfr", "pt_br", "pt_", "fr_FRA", "fr.UTF-8"})
    EXPECT_FALSE(isLanguageCode(code)) << code;
}

}  // namespace
}  // namespace carom
