// The words that a glossary asks for.
#include "app/languages/glossary.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "app/languages/judged_text.h"
#include "app/temporary_folder.h"
#include "app/toml/input_file.h"

namespace carom {
namespace {

using test::rulesOf;
using test::saidOf;
using test::TemporaryFolder;

TEST(TranslationRules, TheGlossarysWordIsAsked) {
  const TemporaryFolder folder;
  TranslationRules rules = rulesOf({});
  rules.glossary = Glossary::read(folder.file(
      "glossary.txt",
      "# terms\nframe = Bezugssystem | Bild\nrest frame = Ruhesystem | Ruhe, ruhend\npuck = Scheibe\r\n\n"));
  EXPECT_EQ(saidOf("The pucks move", "Die Scheiben fahren", rules), "");
  EXPECT_EQ(saidOf("The pucks move", "Die Steine fahren", rules),
            "W 9: text 'a.b' has none of the words of 'puck = Scheibe', which the glossary asks for\n");
  EXPECT_EQ(saidOf("in its rest frame", "im Ruhesystem", rules), "");
  EXPECT_EQ(saidOf("in its rest frame", "für das ruhende System", rules), "");
  EXPECT_EQ(saidOf("In 30 Frames", "in 30 BILDERN", rules), "");
  EXPECT_EQ(saidOf("framed", "gerahmt", rules), "");
  EXPECT_EQ(saidOf("it rests frame by frame", "Bild", rules), "");
  EXPECT_NE(saidOf("in their rest frames", "Bild", rules), "");
  EXPECT_EQ(saidOf("at rest {} frame", "in Ruhe {} Bild", rules), "");
  EXPECT_NE(saidOf("its rest: frame", "Rest: x", rules).find("'frame = Bezugssystem'"), std::string::npos);
  EXPECT_THROW(Glossary::read(folder.file("bad.txt", "frame\n")), InputErrors);
  EXPECT_THROW(Glossary::read(folder.file("bad.txt", "= Bild\n")), InputErrors);
  EXPECT_TRUE(Glossary::beside(folder / "none/a.po").terms().empty());
}

// The longest term counts, where it stands; a term of one word elsewhere in the text counts for itself.
TEST(Glossary, TheLongestTermIsAskedFor) {
  const TemporaryFolder folder;
  const Glossary glossary = Glossary::read(
      folder.file("glossary.txt", "frame = Bild\nown rest frame = A\nrest frame = Ruhesystem | Ruhe\n"));
  std::vector<std::string> lines;
  for (const GlossaryTerm& term : glossary.terms()) lines.push_back(term.line);
  EXPECT_EQ(lines,
            (std::vector<std::string>{"own rest frame = A", "rest frame = Ruhesystem", "frame = Bild"}));
  const auto missing = [&](const std::string& english, const std::string& german) {
    std::vector<std::string> terms;
    for (const GlossaryTerm* term : glossary.missingIn(english, german)) terms.push_back(term->line);
    return terms;
  };
  using Lines = std::vector<std::string>;
  EXPECT_EQ(missing("a rest frame", "x"), Lines{"rest frame = Ruhesystem"});
  EXPECT_EQ(missing("a rest frame", "in RUHE"), Lines{});
  EXPECT_EQ(missing("a frame, a rest frame", "x"), (Lines{"rest frame = Ruhesystem", "frame = Bild"}));
  EXPECT_EQ(missing("a frame, a rest frame", "Ruhebild"), Lines{});
}

TEST(Glossary, AWordIsSharedWhereTheLineSaysSo) {
  const TemporaryFolder folder;
  const Glossary glossary =
      Glossary::read(folder.file("glossary.txt", "# puck = puck\nposition = position\nframe = Bild\n"));
  EXPECT_TRUE(glossary.isShared("position"));
  EXPECT_TRUE(glossary.isShared("Position"));
  EXPECT_FALSE(glossary.isShared("frame"));
  EXPECT_FALSE(glossary.isShared("puck")) << "it stands in a comment";
  EXPECT_EQ(Glossary::beside(folder / "de.po").terms().size(), 2u);
}

}  // namespace
}  // namespace carom
