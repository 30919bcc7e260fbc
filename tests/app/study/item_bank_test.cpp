// Item banks: what they may say, the faults of those that are wrong, and how items are found.
#include "app/study/item_bank.h"

#include <gtest/gtest.h>

#include <string>

#include "app/study/study_texts.h"

namespace carom {
namespace {

using test::faultsOf;
using test::item;
using test::TemporaryFolder;
using test::wholeBank;

std::string faultsOfBank(const std::string& text) {
  const TemporaryFolder folder;
  const auto file = folder.file("bank.toml", text);
  return faultsOf(folder, [&] { readItemBank(file); });
}

TEST(ItemBank, SaysWhatIsWrongAndWhere) {
  EXPECT_EQ(faultsOfBank(wholeBank()), "");
  const std::string answer = "[[item.answer]]\nid = \"a\"\ntext = \"A\"\n";
  EXPECT_SAYS(faultsOfBank(wholeBank() + item("j", "k", "A",
                                              answer + "[[item.answer]]\nid = \"b\"\ntext = "
                                                       "\"B\"\n")),
              "item j of form A has no key");
  EXPECT_SAYS(faultsOfBank(wholeBank() + item("j", "k", "A",
                                              answer + "right = true\n[[item.answer]]\nid = \"b\"\ntext = "
                                                       "\"B\"\nright = true\n")),
              "item j of form A has 2 right answers, expected one");
  EXPECT_SAYS(faultsOfBank(wholeBank() + item("j", "k", "A", answer + "right = true\n")),
              "has 1 answers, expected at least 2");
  EXPECT_SAYS(faultsOfBank(wholeBank() + item("j", "k", "A", answer + "right = true\n" + answer)),
              "has two answers 'a'");
  EXPECT_SAYS(faultsOfBank(wholeBank() + item("i", "k", "B")), "item i stands twice in form B");
  EXPECT_SAYS(faultsOfBank(wholeBank() + item("j", "other", "A") + item("j", "other", "B")),
              "form C has no item of the concept other");
  // One mistake is one line, at its own place.
  EXPECT_EQ(faultsOfBank(item("i", "k", "D") + item("i", "k", "B") + item("i", "k", "C")),
            "bank.toml:4:8: form is 'D', expected 'A' or 'B' or 'C'\n");
  EXPECT_EQ(faultsOfBank(wholeBank() +
                         item("j", "k", "A",
                              answer + "right = \"yes\"\n" + "[[item.answer]]\nid = \"b\"\ntext = \"B\"\n")),
            "bank.toml:48:9: right is a text, expected true or false\n");
  std::string without = item("j", "k", "A");
  without.erase(without.find("concept"), std::string("concept = \"k\"\n").size());
  EXPECT_EQ(faultsOfBank(wholeBank() + without), "bank.toml:40:1: concept is missing here\n");
  EXPECT_SAYS(faultsOfBank(item("a,b", "k", "A")), "id is 'a,b', expected at most 40 letters");
  EXPECT_SAYS(faultsOfBank("title = \"none\"\n"), "there is no item here");
  EXPECT_SAYS(
      faultsOfBank(
          item("i", "k", "A", answer + "right = true\n[[item.answer]]\nid = \"dont-know\"\ntext = \"?\"\n")),
      "'dont-know' is the answer that each item has");
  EXPECT_SAYS(faultsOfBank(item("i", "k", "A", answer + "right = true\nmisconception = \"m\"\n")),
              "the right answer has a misconception");
}

TEST(ItemBank, TellsOfFormsWithOtherAnswers) {
  const std::string other =
      "[[item.answer]]\nid = \"a\"\ntext = \"A\"\n[[item.answer]]\nid = \"c\"\ntext = \"C\"\nright = true\n";
  const TemporaryFolder folder;
  const ItemBank bank = readItemBank(
      folder.file("bank.toml", item("i", "k", "A") + item("i", "k", "B", other) + item("i", "k", "C")));
  ASSERT_EQ(bank.odd.size(), 2U);
  EXPECT_SAYS(bank.odd[0].text, "the answer 'a' of item i means something else in form B than in form A");
  EXPECT_SAYS(bank.odd[1].text, "item i has an answer 'c' in form B and none in form A");
}

TEST(ItemBank, ItemsAreFoundByTheirFormsIdsAndConcepts) {
  const TemporaryFolder folder;
  const std::string text = item("late", "light", "B") + item("i", "time", "B") + item("i", "time", "A") +
                           item("late", "light", "A") + item("late", "light", "C") + item("i", "time", "C");
  const ItemBank bank = readItemBank(folder.file("own.toml", text));
  EXPECT_EQ(bank.title, "own") << "without a title, the name of the file";
  EXPECT_EQ(bank.concepts(), (std::vector<std::string>{"light", "time"})) << "in the order of the file";
  const auto ofB = bank.ofForm(1);
  ASSERT_EQ(ofB.size(), 2U);
  EXPECT_EQ(ofB[0]->id + " " + ofB[1]->id, "late i");
  const Item* found = bank.find("i", 2);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->id + kForms[found->form] + found->concept_, "iCtime");
  EXPECT_EQ(bank.find("light", 0), nullptr);
  ASSERT_TRUE(found->answer("b"));
  EXPECT_EQ(found->answer("b")->misconception, "m");
  EXPECT_EQ(found->answer("c"), nullptr);
  const ItemBank kept = readItemBank("gone.toml", "title = \"Kept\"\n" + text);
  EXPECT_EQ(kept.title, "Kept");
  EXPECT_EQ(kept.items.size(), bank.items.size()) << "of the content, not of the file, which is gone";
}

}  // namespace
}  // namespace carom
