// Studies: what they may say, and the faults of those that are wrong.
#include "app/study/study.h"

#include <gtest/gtest.h>

#include <string>

#include <fmt/format.h>

#include "app/study/study_texts.h"
#include "app/toml/input_file.h"
#include "places.h"

namespace carom {
namespace {

using test::faultsOf;
using test::item;
using test::TemporaryFolder;
using test::wholeBank;

std::string studyText(const std::string& more = "", const std::string& arms = "") {
  return "title = \"T\"\nseed = 1\nparticipants = 24\nlessons = [\"light-clock\", \"twins\"]\n" + more +
         (arms.empty() ? "[[arm]]\nname = \"a\"\nrig = \"desk\"\n[[arm]]\nname = \"b\"\nrig = \"desk\"\n"
                         "head = \"still\"\nswitches_off = [\"aberration\"]\nviews_off = [\"paths\"]\n"
                       : arms);
}

std::string faultsOfStudy(const std::string& text) {
  const TemporaryFolder folder;
  const auto file = folder.file("study.toml", text);
  return faultsOf(folder, [&] { readStudy(file); });
}

TEST(Study, TheShippedOnesAreWithoutFault) {
  for (const char* name : {"walking-or-standing", "before-and-after"}) {
    const Study study = readStudy(std::string(CAROM_CONFIG_DIR "/studies/") + name + ".toml");
    EXPECT_TRUE(study.odd.empty()) << study.odd[0].text;
    EXPECT_TRUE(study.bank.odd.empty()) << study.bank.odd[0].text;
    EXPECT_EQ(study.bank.items.size(), 54U);
    EXPECT_EQ(study.lessons.size(), 4U);
    EXPECT_FALSE(study.primary.empty());
    EXPECT_TRUE(study.keepUntil.has_value());
  }
  const Study two = readStudy(CAROM_CONFIG_DIR "/studies/walking-or-standing.toml");
  ASSERT_EQ(two.arms.size(), 2U);
  EXPECT_FALSE(two.arms[0].isStill);
  EXPECT_TRUE(two.arms[1].isStill);
  EXPECT_EQ(*two.keepUntil, std::chrono::year(2031) / 12 / 31);
}

TEST(Study, ReadsEveryKeyAndRestoresItFromItsText) {
  const TemporaryFolder folder;
  folder.file("own.toml", wholeBank());
  folder.file("consent.md", "# Consent\n");
  const std::string text = studyText(
      "orders = \"fixed\"\nforms = \"fixed\"\nitems = \"own.toml\"\nprimary = \"p\"\ngender = true\n"
      "reasons = true\nopen = true\nkeep_until = 2030-02-28\nconsent = \"consent.md\"\n");
  const Study read = readStudy(folder.file("study.toml", text));
  const Study kept = keptStudy(text, wholeBank());
  for (const Study* study : {&read, &kept}) {
    EXPECT_EQ(study->title, "T");
    EXPECT_EQ(study->seed, 1U);
    EXPECT_EQ(study->participants, 24U);
    EXPECT_TRUE(study->hasFixedOrder && study->hasFixedForms && study->asksGender && study->asksReasons &&
                study->isOpen);
    EXPECT_EQ(study->primary, "p");
    EXPECT_EQ(*study->keepUntil, std::chrono::year(2030) / 2 / 28);
    EXPECT_EQ(study->bank.items.size(), 3U);
    EXPECT_EQ(study->lessons[1].name, "twins");
    ASSERT_EQ(study->arms.size(), 2U);
    EXPECT_EQ(study->arms[1].switchesOff, std::vector<std::string>{"aberration"});
    EXPECT_EQ(study->arms[1].viewsOff, std::vector<std::string>{"paths"});
    EXPECT_EQ(study->sha256, read.sha256);
    EXPECT_EQ(orderRows(*study), 1U);
  }
  EXPECT_EQ(read.lessons[0].scenario.filename(), "light-clock.toml");
  EXPECT_EQ(read.arms[0].rig.filename(), "desk.toml");
}

TEST(Study, TheHashIsThatOfTheStandard) {
  // FIPS 180-4, examples: "abc", and a message of two blocks.
  EXPECT_EQ(sha256Of("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256Of("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
}

TEST(Study, SaysWhatIsWrongAndWhere) {
  EXPECT_EQ(faultsOfStudy(studyText()), "");
  EXPECT_SAYS(faultsOfStudy(studyText("sede = 2\n")), "study.toml:5:1: unknown key 'sede'");
  EXPECT_SAYS(faultsOfStudy(studyText("", "[[arm]]\nname = \"a\"\n")), "study.toml:5:1: rig is missing here");
  EXPECT_SAYS(
      faultsOfStudy(studyText("", "[[arm]]\nname = \"a\"\nrig = \"deks\"\n")),
      "study.toml:7:7: rig: there is no 'deks', expected a file beside the study or one of the folder "
      "rigs, such as 'desk'?");
  EXPECT_SAYS(faultsOfStudy(studyText("", "arm = []\n")), "expected one [[arm]] at least");
  EXPECT_SAYS(faultsOfStudy(studyText("",
                                      "[[arm]]\nname = \"a\"\nrig = \"desk\"\n[[arm]]\nname = \"a\"\n"
                                      "rig = \"desk\"\n")),
              "study.toml:9:8: two arms are 'a'");
  EXPECT_SAYS(faultsOfStudy(studyText("",
                                      "[[arm]]\nname = \"a\"\nrig = \"desk\"\nswitches_off = "
                                      "[\"gravity\"]\n")),
              "study.toml:8:17: 'gravity' is none that there is");
  EXPECT_SAYS(faultsOfStudy(studyText("", "[[arm]]\nname = \"a\"\nrig = \"desk\"\nhead = \"lost\"\n")),
              "head is 'lost', expected 'tracked' or 'still'");
  EXPECT_SAYS(faultsOfStudy(studyText("keep_until = \"2031-12-31\"\n")), "expected a date without quotes");
  EXPECT_SAYS(faultsOfStudy(studyText("consent = \"gone.md\"\n")), "consent: there is no 'gone.md'");
  EXPECT_SAYS(faultsOfStudy(studyText("items = \"/etc/passwd\"\n")), "outside");
  EXPECT_SAYS(faultsOfStudy("title = \"T\"\nseed = 1\nparticipants = 24\nlessons = [\"twinz\", \"table\", "
                            "\"twins\", \"twins\"]\n[[arm]]\nname = \"a\"\nrig = \"desk\"\n"),
              "study.toml:4:12: lessons: there is no 'twinz', expected a file beside the study or one of the "
              "folder scenarios, such as 'twins'?\nstudy.toml:4:21: 'table' is a game without a lesson, "
              "expected a lesson\nstudy.toml:4:39: the lesson 'twins' stands here twice");
  EXPECT_SAYS(faultsOfStudy(studyText("seed = -1\n")), "study.toml");
  EXPECT_SAYS(faultsOfStudy("title = \"T\"\nseed = 1.5\nparticipants = 0\nlessons = []\n[[arm]]\nname = "
                            "\"a\"\nrig = \"desk\"\n"),
              "participants is 0, expected a whole number from 1");
}

TEST(Study, ABankThatCannotBeUsedIsSaidAtItsKey) {
  const TemporaryFolder folder;
  folder.file("own.toml", item("i", "k", "A") + item("i", "k", "B"));
  const auto file = folder.file("study.toml", studyText("items = \"own.toml\"\n"));
  EXPECT_SAYS(
      faultsOf(folder, [&] { readStudy(file); }),
      "study.toml:5:9: this item bank cannot be used: own.toml:1:1: form C has no item of the concept "
      "k");
}

TEST(Study, TellsOfTooFewPeopleForTheRows) {
  const TemporaryFolder folder;
  const std::string text =
      "title = \"T\"\nseed = 1\nparticipants = 19\nlessons = [\"light-clock\", \"twins\", \"solid\", "
      "\"two-cushions\", \"seen-at-once\"]\n[[arm]]\nname = \"a\"\nrig = \"desk\"\n[[arm]]\nname = \"b\"\n"
      "rig = \"desk\"\n";
  const Study study = readStudy(folder.file("study.toml", text));
  EXPECT_EQ(orderRows(study), 10U);
  ASSERT_EQ(study.odd.size(), 3U);
  EXPECT_SAYS(study.odd[0].text, "the arm 'b' has the same settings as the arm 'a'");
  EXPECT_SAYS(study.odd[1].text,
              "9 people in an arm: the report will describe and have no p-values, expected at");
  EXPECT_SAYS(study.odd[2].text, "too few participants for the rows: 9 in an arm, expected at least 10");
}

TEST(Study, TellsOfAPrimaryOutcomeWithoutATestAndOfArmsThatAreTheSame) {
  const TemporaryFolder folder;
  const auto oddOf = [&](const std::string& more, const std::string& arms = "") {
    std::string all;
    for (const Finding& odd : readStudy(folder.file("study.toml", studyText(more, arms))).odd)
      all += fmt::format("{}:{}\n", odd.at.line, odd.text);
    return all;
  };
  const std::string one = "[[arm]]\nname = \"a\"\nrig = \"desk\"\n",
                    two = one + "[[arm]]\nname = \"b\"\nrig = \"desk\"\n";
  EXPECT_EQ(oddOf("primary = \"gain between arms\"\n"), "");
  EXPECT_EQ(oddOf("primary = \"gain\"\n", one), "");
  EXPECT_EQ(oddOf(""), "");
  EXPECT_SAYS(
      oddOf("primary = \"gain\"\n"),
      "5:primary is 'gain', which the report has no test for, expected 'gain between arms', for two arms");
  EXPECT_SAYS(oddOf("primary = \"gain between arms\"\n", one), "expected 'gain', for one arm");
  EXPECT_SAYS(oddOf("primary = \"joy\"\n"), "primary is 'joy', which the report has no test for");
  EXPECT_EQ(oddOf("", two),
            "8:the arm 'b' has the same settings as the arm 'a', expected a difference between them\n");
  EXPECT_EQ(oddOf("", two + "head = \"still\"\n"), "");
}

TEST(Study, TellsWhatOfTheTemplateIsLeftInTheConsentPage) {
  const auto found = leftOfTemplate(
      "# Taking part\n\n*A template for your ethics board: do.*\nAsk [name] or [see](http://x), [who]\n");
  ASSERT_EQ(found.size(), 3U);
  EXPECT_EQ(found[0].at.line, 3);
  EXPECT_EQ(found[0].at.column, 2);
  EXPECT_SAYS(found[1].text, "[name] stands in brackets");
  EXPECT_EQ(found[1].at.line, 4);
  EXPECT_EQ(found[1].at.column, 5);
  EXPECT_SAYS(found[2].text, "[who]");
  EXPECT_TRUE(leftOfTemplate("# Taking part\nAsk Ada.\n").empty());
  for (const char* name : {"consent-en.md", "consent-de.md"})
    EXPECT_GE(
        leftOfTemplate(readText(std::string(CAROM_CONFIG_DIR "/studies/") + name, InputKind::toml)).size(),
        5U)
        << name;
}

TEST(Study, KnowsWhetherItsItemsAreTheShippedOnes) {
  const TemporaryFolder folder;
  folder.file("own.toml", wholeBank());
  EXPECT_TRUE(readStudy(folder.file("study.toml", studyText())).hasShippedBank);
  EXPECT_FALSE(readStudy(folder.file("study.toml", studyText("items = \"own.toml\"\n"))).hasShippedBank);
}

}  // namespace
}  // namespace carom
