#include "cave/record/notice.h"

#include <gtest/gtest.h>

#include <string>

#include "cave/texts/texts.h"

namespace carom {
namespace {

texts::Language french() {
  texts::Language made("fr");
  made.put(texts::message::kStroke.index(), {"Votre coup va vers {} : {:.1f} s, retour {:.1f} s{}"});
  made.put(texts::message::kRightOfCentre.index(), {", {:.0f} mm à droite"});
  made.putOther("red", "rouge");
  made.putOther("A turning puck leaves otherwise.", "Un palet qui tourne repart autrement.");
  return made;
}

TEST(Notice, IsEnglishInTheRecordAndTurnedByWhoReadsIt) {
  const Notice notice(texts::say(texts::message::kStroke, "red", 1.25, 1.5,
                                 texts::say(texts::message::kRightOfCentre, 12.0)));
  const std::string english =
      "Your stroke runs to red at the speed of light: 1.2 s there, 1.5 s back, 12 mm right of its centre";
  EXPECT_EQ(notice.words(), english);
  EXPECT_EQ(notice.english.words(), english);
  const texts::Language made = french();
  const texts::InLanguage reads(&made);
  EXPECT_EQ(notice.words(), "Votre coup va vers rouge : 1,2 s, retour 1,5 s, 12 mm à droite");
  EXPECT_EQ(Notice(texts::say(texts::message::kStroke, "red", 1.25, 1.5, "")).english.words().substr(0, 19),
            "Your stroke runs to")
      << "made under another language";
}

TEST(Notice, ATextOfAGameIsLookedUpByItsEnglish) {
  const Notice notice("A turning puck leaves otherwise.");
  EXPECT_TRUE(notice.said.words().empty());
  const texts::Language made = french();
  const texts::InLanguage reads(&made);
  EXPECT_EQ(notice.words(), "Un palet qui tourne repart autrement.");
  EXPECT_TRUE(Notice().empty());
  EXPECT_EQ(Notice().words(), "");
}

TEST(Notice, WhatIsTooLongStaysEnglish) {
  const Notice notice(texts::say(texts::message::kStroke, std::string(400, 'n'), 1.0, 1.0, ""));
  EXPECT_TRUE(notice.said.words().empty());
  EXPECT_EQ(notice.english.words().size(), notice.english.text.size() - 1) << "cut";
  const texts::Language made = french();
  const texts::InLanguage reads(&made);
  EXPECT_EQ(notice.words(), notice.english.words());
}

/// The longest messages of the program, with names of twenty letters.
TEST(Notice, TheProgramsMessagesHaveRoomForTheirValues) {
  const std::string name(20, 'x');
  const texts::Saying neither(texts::message::kNeitherFirst);
  const texts::Saying order = texts::say(texts::message::kNoOrder, neither, neither) +
                              texts::say(texts::message::kOrderOf, neither, name) +
                              texts::message::kOrderEnds;
  for (const texts::Saying& saying :
       {texts::say(texts::message::kStroke, name, 12.5, 12.5,
                   texts::say(texts::message::kRightOfCentre, 12.0)),
        texts::say(texts::message::kPickedTwo, "123", "124", 12.34, 12.34, order),
        texts::say(texts::message::kHiddenMass, 0.123456, 123.4567, 123.4567),
        texts::say(texts::message::kSawHitFirst, name) +
            texts::say(texts::message::kSawHitLater, name, 1.25, 1.25) +
            texts::say(texts::message::kSawHitLater, name, 1.25, 1.25)}) {
    EXPECT_FALSE(Notice(saying).said.words().empty()) << saying.line();
  }
}

}  // namespace
}  // namespace carom
