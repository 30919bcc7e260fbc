// How keys are named by the layout of a keyboard. The names of a real one are in
// tests/app/sessions/french_keyboard.sh.
#include "app/input/keyboard_layout.h"

#include <gtest/gtest.h>

#include <clocale>

#include "app/input/keys.h"
#include "cave/texts/key_names.h"
#include "cave/texts/texts.h"

namespace carom {
namespace {

/// A French keyboard for as long as it lives.
class FrenchKeys {
 public:
  FrenchKeys() : before_(keyNamesInUse()) {
    for (const auto& [us, printed] : {std::pair{'W', "Z"},
                                      {'A', "Q"},
                                      {'Q', "A"},
                                      {'Z', "W"},
                                      {'[', "^"},
                                      {']', "$"},
                                      {'M', ","},
                                      {',', ";"},
                                      {'.', ":"}})
      texts::keyNames.set(us, printed);
  }
  ~FrenchKeys() { useKeyNames(before_); }
  FrenchKeys(const FrenchKeys&) = delete;
  FrenchKeys& operator=(const FrenchKeys&) = delete;

 private:
  std::string before_;
};

std::string keysFor(const std::vector<KeyLine>& lines, const std::string& does) {
  for (const KeyLine& line : lines) {
    if (line.does == does) return line.keys;
  }
  return "none";
}

TEST(KeyboardLayout, KeysHaveCapitalsWhereThereAreAny) {
  for (const auto& [printed, onKey] : {std::pair{"a", "A"},
                                       {"é", "É"},
                                       {"ø", "Ø"},
                                       {"ž", "Ž"},
                                       {"ÿ", "Ÿ"},
                                       {"ß", "ß"},
                                       {"^", "^"},
                                       {"$", "$"},
                                       {"я", "Я"},
                                       {"ô", "Ô"},
                                       {"", ""}})
    EXPECT_EQ(asOnKey(printed), onKey);
  EXPECT_EQ(asOnKey("a\xff"), "A") << "no UTF-8";
  EXPECT_STREQ(std::setlocale(LC_ALL, nullptr), "C") << "the process keeps its locale";
}

TEST(KeyboardLayout, WordsOfOneSignAreKeys) {
  const FrenchKeys french;
  for (const auto& [us, named] : {std::pair{"W A S D", "Z Q S D"},
                                  {"[ ]", "^ $"},
                                  {"Escape Q", "Escape A"},
                                  {"1 to 4", "1 to 4"},
                                  {"F9", "F9"},
                                  {"← →", "← →"},
                                  {"", ""}})
    EXPECT_EQ(texts::inLayout(us), named);
  EXPECT_EQ(texts::withKeyInLayout("Who was first  W"), "Who was first  Z");
  EXPECT_EQ(texts::withKeyInLayout("A word or Q"), "A word or Q") << "no key stands behind two spaces";
  EXPECT_EQ(texts::withKeyInLayout("Leave  F7"), "Leave  F7");
}

TEST(KeyboardLayout, TheListOfKeysFollowsIt) {
  KeyList list(KeysOf::session);
  EXPECT_EQ(keysFor(list.in(0), texts::keys::kSteer.english()), "W A S D");
  EXPECT_EQ(keysFor(list.in(0), texts::keys::kLight.english()), "[ ]");
  EXPECT_EQ(keysFor(list.in(0), texts::keys::kStrain.english()), "Z");
  EXPECT_EQ(keysFor(list.in(0), texts::keys::kNextLanguage.english()), "F9");
  {
    const FrenchKeys french;
    EXPECT_EQ(keysFor(list.in(0), texts::keys::kSteer.english()), "Z Q S D");
    EXPECT_EQ(keysFor(list.in(0), texts::keys::kLight.english()), "^ $");
    EXPECT_EQ(keysFor(list.in(0), texts::keys::kStrain.english()), "W");
    EXPECT_EQ(keysFor(list.in(0), texts::keys::kSpeeds.english()), ";");
    EXPECT_EQ(keysFor(list.in(0), texts::keys::kRetardation.english()), "1") << "digits stay";
  }
  EXPECT_EQ(keysFor(list.in(0), texts::keys::kSteer.english()), "W A S D");
}

TEST(KeyboardLayout, AnotherNodeHasTheSameNames) {
  std::string names;
  {
    const FrenchKeys french;
    names = keyNamesInUse();
  }
  EXPECT_EQ(texts::keyNames.of('W'), "W");
  const std::string us = keyNamesInUse();
  useKeyNames(names);
  EXPECT_EQ(texts::keyNames.of('W'), "Z");
  EXPECT_EQ(texts::keyNames.of('['), "^");
  useKeyNames("Z\n");  // cut off
  useKeyNames(us);
  EXPECT_EQ(keyNamesInUse(), us);
}

TEST(KeyboardLayout, PlusIsOnTheKeyOfTheEqualsSignOrOnTheOneInItsPlace) {
  const std::string us = keyNamesInUse();
  const auto eyesApart = [] { return keysFor(keyMap(KeysOf::session), texts::keys::kEyesApart.english()); };
  EXPECT_EQ(eyesApart(), "+ -");
  texts::keyNames.set('-', ")");
  useKeyNames(keyNamesInUse());
  EXPECT_EQ(eyesApart(), "+ )") << "French: = with Shift";
  texts::keyNames.set('=', "´");
  texts::keyNames.set('-', "ß");
  useKeyNames(keyNamesInUse());
  EXPECT_EQ(eyesApart(), "´ ß") << "German: + is elsewhere";
  useKeyNames(us);
  EXPECT_EQ(eyesApart(), "+ -");
}

TEST(KeyNames, ANameThatIsTooLongOrEmptyLeavesTheUsOne) {
  texts::KeyNames names;
  names.set('W', "a word of a key");
  EXPECT_EQ(names.of('W'), "W");
  EXPECT_EQ(names.changes(), 0U);
  names.set('W', "Z");
  EXPECT_EQ(names.of('W'), "Z");
  EXPECT_EQ(names.changes(), 1U);
  names.set('W', "");
  EXPECT_EQ(names.of('W'), "W");
}

}  // namespace
}  // namespace carom
