// Templates for translators, and translations with the English of today.
#include "app/languages/po_template.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <vector>

#include "app/languages/po_text.h"

namespace carom {
namespace {

using test::bareHead;
using test::entry;

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
      parsePo("a.po", bareHead("fr") + "# Of the translator.\n#. Old note.\n" + entry("a", "same", "pareil") +
                          entry("b", "before", "avant") + entry("c 1", "moves", "bouge") +
                          entry("d", "goes", "part") + entry("e", "untranslated before", "") +
                          "#~ msgctxt \"f\"\n#~ msgid \"back\"\n#~ msgstr \"retour\"\n");
  const UpdatedPo now =
      updated(old, std::vector{source("a", "same"), source("b", "after"), source("c 1", "new"),
                               source("c 2", "moves"), source("e", "untranslated"), source("f", "back"),
                               source("g", "one", "many")});
  EXPECT_EQ(
      textOf(now.file),
      bareHead("fr") +
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

}  // namespace
}  // namespace carom
