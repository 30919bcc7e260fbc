// The words of a class on the front wall, and the size of its code.
#include "cave/overlay/class_board.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "cave/overlay/qr_code.h"

namespace carom {
namespace {

ClassView viewIn(ClassPhase phase, int round) {
  ClassView view;
  view.phase = phase;
  view.round = static_cast<std::uint8_t>(round);
  view.choices = 3;
  view.answered = 12;
  view.phones = 20;
  view.address = ShortText<120>("http://192.168.1.20:8080/");
  view.word = ShortText<120>("KIWI");
  return view;
}

TEST(ClassBoard, SaysHowToJoinAndHowManyHaveAnswered) {
  using Lines = std::vector<std::string>;
  const std::string address = "http://192.168.1.20:8080/", room = "Room KIWI", join = "Join by phone:";
  EXPECT_EQ(classLines(viewIn(ClassPhase::idle, 0)), (Lines{join, address, room, "phones: 20"}));
  EXPECT_EQ(classLines(viewIn(ClassPhase::vote, 2)), (Lines{"Vote 2:  12 of 20 answered", address, room}));
  ClassView closed = viewIn(ClassPhase::closed, 1);
  EXPECT_EQ(classLines(closed),
            (Lines{"Vote 1 is closed:  12 answered", "Too few answers to show how they were given"}));
  closed.counts[0] = {3, 4, 5, 0};
  EXPECT_EQ(classLines(closed), (Lines{"Vote 1 is closed:  12 answered"}));
  EXPECT_EQ(classLines(viewIn(ClassPhase::discuss, 1)), (Lines{"Discuss it, then vote again"}));
  EXPECT_TRUE(classLines(viewIn(ClassPhase::shown, 2)).empty())
      << "the code alone: the lesson needs the wall";
  EXPECT_TRUE(classLines(viewIn(ClassPhase::explained, 2)).empty()) << "the lesson needs the wall";
}

TEST(ClassBoard, HasACodeThatCanBeRead) {
  const QrCode code = qrCodeOf("http://192.168.1.20:8080/");
  ASSERT_GE(code.side, 21);
  ASSERT_EQ((code.side - 17) % 4, 0) << "versions of the standard";
  ASSERT_EQ(code.dark.size(), static_cast<std::size_t>(code.side * code.side));
  // Its three eyes: dark squares of seven modules, light ones of five in them, dark ones of three in these.
  for (const auto& [left, top] :
       {std::pair{0, 0}, std::pair{code.side - 7, 0}, std::pair{0, code.side - 7}}) {
    for (int row = 0; row < 7; ++row) {
      for (int column = 0; column < 7; ++column) {
        const int ring = std::max(std::abs(row - 3), std::abs(column - 3));
        EXPECT_EQ(code.isDark(left + column, top + row), ring != 2) << row << ' ' << column;
      }
    }
  }
  EXPECT_EQ(qrCodeOf("").side, 0);
  for (const int height_px : {360, 600, 720, 1080, 1600, 2160, 4320}) {
    for (const bool isSmall : {false, true}) {
      const int module_px = moduleOf_px(height_px, code.side + 2 * kQuietModules, isSmall);
      EXPECT_GE(module_px, height_px / 400.0) << height_px;
      EXPECT_GE(module_px, 2);
      EXPECT_LE(module_px * (code.side + 2 * kQuietModules), 0.3 * height_px) << height_px;
    }
  }
}

}  // namespace
}  // namespace carom
