// PO files of translators, and hostile ones.
#include "app/languages/po_file.h"

#include <gtest/gtest.h>

#include <string>

#include "app/temporary_folder.h"

namespace carom {
namespace {

using test::TemporaryFolder;

const std::string kHead =
    "msgid \"\"\nmsgstr \"\"\n\"Language: fr\\n\"\n\"Content-Type: text/plain; charset=UTF-8\\n\"\n"
    "\"Plural-Forms: nplurals=2; plural=(n > 1);\\n\"\n\n";
const std::string kStroke = "msgctxt \"message.kStroke\"\nmsgid \"A stroke\"\nmsgstr \"Un coup\"\n";

PoFile parsed(const std::string& content) { return parsePo("a.po", content); }

/// Returns the faults of a content, a line each; empty if it has none.
std::string faultsOf(const std::string& content) {
  try {
    parsed(content);
  } catch (const InputErrors& errors) {
    std::string all;
    for (const InputError& fault : errors.faults()) all += std::string(fault.what()) + "\n";
    return all;
  }
  return {};
}

TEST(PoFile, EachStringHasItsWordsAndItsPlace) {
  const PoFile file =
      parsed(kHead +
             "# A note.\n#. Of the program.\n#: angles.toml:3\n#, fuzzy, c++-format\n"
             "#| msgid \"old\"\nmsgctxt \"a.b\"\nmsgid \"\"\n\"one \\\"\\\\\"\n  \"two\\n\\t\"\n"
             "msgid_plural \"many\"\nmsgstr[0] \"un\"\nmsgstr[1]   \"plusieurs\"\n");
  ASSERT_EQ(file.entries.size(), 1U);
  const PoEntry& entry = file.entries[0];
  EXPECT_EQ(entry.comments,
            (std::vector<std::string>{"# A note.", "#. Of the program.", "#: angles.toml:3"}));
  EXPECT_EQ(entry.flags, (std::vector<std::string>{"fuzzy", "c++-format"}));
  EXPECT_EQ(entry.before, std::vector<std::string>{"#| msgid \"old\""});
  EXPECT_TRUE(entry.isFuzzy());
  EXPECT_FALSE(entry.isTranslated());
  EXPECT_EQ(entry.context.value().words, "a.b");
  EXPECT_EQ(entry.id.words, "one \"\\two\n\t");
  EXPECT_EQ(entry.plural.value().words, "many");
  ASSERT_EQ(entry.forms.size(), 2U);
  EXPECT_EQ(entry.forms[1].words, "plusieurs");
  EXPECT_EQ(entry.context->at.line, 12);
  EXPECT_EQ(entry.context->at.column, 9);
  EXPECT_EQ(entry.forms[1].at.line, 18);
  EXPECT_EQ(entry.forms[1].at.column, 13);
}

TEST(PoFile, TheHeaderSaysLanguageCharsetAndPlurals) {
  const auto head = headerOf(parsed(kHead + kStroke));
  ASSERT_TRUE(head);
  EXPECT_EQ(head->language, "fr");
  EXPECT_EQ(head->charset, "UTF-8");
  EXPECT_EQ(head->pluralForms, "nplurals=2; plural=(n > 1);");
  EXPECT_FALSE(headerOf(parsed(kStroke)));
}

TEST(PoFile, ObsoleteEntriesAreKept) {
  const PoFile file =
      parsed(kHead + kStroke + "\n#~ msgctxt \"x.y\"\n#~ msgid \"gone\"\n#~ msgstr \"parti\"\n");
  ASSERT_EQ(file.entries.size(), 2U);
  EXPECT_FALSE(file.entries[0].isObsolete);
  EXPECT_TRUE(file.entries[1].isObsolete);
  EXPECT_FALSE(file.entries[1].isTranslated());
  EXPECT_EQ(file.entries[1].forms[0].words, "parti");
}

TEST(PoFile, AFileThatIsWrittenReadsTheSameAgain) {
  const std::string text = kHead + "# A note.\n#, fuzzy\n#| msgid \"Stroke\"\n" + kStroke +
                           "\nmsgctxt \"a\"\nmsgid \"{} puck\"\nmsgid_plural \"{} pucks\"\nmsgstr[0] \"\"\n"
                           "msgstr[1] \"\"\n\n#~ msgctxt \"x.y\"\n#~ msgid \"gone\"\n#~ msgstr \"parti\"\n";
  EXPECT_EQ(textOf(parsed(text)), text);
}

TEST(PoFile, ByteOrderMarkAndCarriageReturnsAreTaken) {
  std::string text = "\xEF\xBB\xBF";
  for (const char c : kHead + kStroke) text += c == '\n' ? "\r\n" : std::string(1, c);
  EXPECT_EQ(textOf(parsed(text)), kHead + kStroke);
}

TEST(PoFile, WhatIsNoPoIsNamedWithItsPlace) {
  struct Case {
    const char *content, *fault;
  };
  for (const Case& one : {
           Case{"msgid \"a\"\nmsgstr \"caf\xE9\"\n", "a.po:2:12: the byte 0xE9 is not UTF-8"},
           Case{"msgid \"a\"\nmsgstr \"\x07\"\n", "a.po:2:9: the control sign U+0007"},
           Case{"msgid \"a\"\nmsgstr \"\xC2\x85\"\n", "a.po:2:9: the control sign U+0085"},
           Case{"msgid \"a\"\nmsgstr \"b", "a.po:2:8: the string has no end"},
           Case{"msgid \"a\"\nmsgstr", "a.po:2:7: expected a string in quotation marks"},
           Case{"msgid \"a\"\n", "a.po:1:1: the entry has no msgstr"},
           Case{"msgid \"a\"\n\nmsgid \"b\"\nmsgstr \"c\"\n", "a.po:2:1: the entry has no msgstr"},
           Case{"\"a\"\n", "a.po:1:1: a string of its own"},
           Case{"msgid \"a\"\nmsgid \"b\"\nmsgstr \"\"\n", "a.po:2:1: a second msgid"},
           Case{"msgstr \"\"\n", "a.po:1:1: msgstr stands alone"},
           Case{"msgid_plural \"\"\n", "a.po:1:1: msgid_plural stands alone"},
           Case{"msgid \"a\"\nmsgctxt \"b\"\n", "a.po:2:1: msgctxt stands within an entry"},
           Case{"title = 1\n", "a.po:1:1: 'title' is no word of a PO file"},
           Case{"msgid \"a\"\nmsgstr \"\\q\"\n", "a.po:2:9: a backslash"},
           Case{"msgid \"a\"\nmsgstr \"\\\n", "a.po:2:8: the string has no end"},
           Case{"msgid \"a\"\nmsgstr \"b\" c\n", "a.po:2:11: something stands behind the string"},
           Case{"msgid \"a\"\nmsgstr[0] \"b\"\n", "a.po:2:1: 'msgstr[0]' stands here, expected msgstr"},
           Case{"msgid \"a\"\nmsgid_plural \"b\"\nmsgstr \"c\"\n",
                "a.po:3:1: 'msgstr' stands here, expected msgstr[0]"},
           Case{"msgid \"a\"\nmsgid_plural \"b\"\nmsgstr[1] \"c\"\n",
                "a.po:3:1: 'msgstr[1]' stands here, expected msgstr[0]"},
           Case{"msgid \"a\"\nmsgstr \"b\"\nmsgstr \"c\"\n",
                "a.po:3:1: 'msgstr' stands here, expected another entry"},
       }) {
    EXPECT_TRUE(faultsOf(one.content).starts_with(one.fault)) << one.content << "\n" << faultsOf(one.content);
  }
  EXPECT_EQ(faultsOf(std::string("msgid \"\0\"\n", 10)),
            "a.po:1:8: the control sign U+0000, expected text\n");
}

TEST(PoFile, AllFaultsAreToldAtMostOneOfAnEntryAndAHundredOfAFile) {
  EXPECT_EQ(faultsOf(kHead + "msgid \"a\nmsgstr \"b\n\nmsgid \"c\"\nmsgstr d\n"),
            "a.po:7:7: the string has no end, expected a quotation mark on the same line\n"
            "a.po:11:8: expected a string in quotation marks\n");
  EXPECT_EQ(faultsOf("msgid \"a\nmsgstr d\nmsgstr e\n"),
            "a.po:1:7: the string has no end, expected a quotation mark on the same line\n");
  std::string many;
  for (int i = 0; i < 1000; ++i) many += "msgid a\n\n";
  const std::string faults = faultsOf(many);
  EXPECT_EQ(std::count(faults.begin(), faults.end(), '\n'), 100);
}

TEST(PoFile, CutAnywhereItIsReadOrRefused) {
  const std::string text = kHead + "#, fuzzy\n" + kStroke + "\n#~ msgid \"gone\"\n#~ msgstr \"\xC3\xA9\"\n";
  std::size_t refused = 0;
  for (std::size_t length = 0; length < text.size(); ++length)
    refused += faultsOf(text.substr(0, length)).empty() ? 0 : 1;
  EXPECT_GT(refused, text.size() / 2);
  EXPECT_LT(refused, text.size());
}

TEST(PoFile, TooManyEntriesAreOneSentence) {
  std::string text = kHead;
  for (std::size_t i = 0; i <= kMostPoEntries; ++i) text += "msgid \"a\"\nmsgstr \"\"\n\n";
  EXPECT_EQ(faultsOf(text), "a.po:60009:1: more than 20000 entries, expected at most as many\n");
}

TEST(PoFile, AFileOfSixteenMebibytesAtMostIsRead) {
  const TemporaryFolder folder;
  const auto file = folder.file("a.po", kHead + kStroke);
  EXPECT_EQ(readPo(file).entries.size(), 1U);
  std::filesystem::resize_file(file, (16U << 20U) + 1);
  EXPECT_THROW(readPo(file), InputErrors);
  EXPECT_THROW(readPo(folder / "none.po"), InputErrors);
  EXPECT_THROW(readPo("/dev/zero"), InputErrors);
}

}  // namespace
}  // namespace carom
