// Where the lines and buttons of a lesson's band lie: one below the other, and each button in its line.
#include "cave/overlay/band_layout.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace carom {
namespace {

constexpr glm::ivec2 kPicture_px(1920, 1200);

Wall front() {
  Wall wall;
  wall.lowerLeft_m = {-1.6, 0.2, -2.0};
  wall.lowerRight_m = {1.6, 0.2, -2.0};
  wall.upperLeft_m = {-1.6, 2.2, -2.0};
  wall.pixels = kPicture_px;
  return wall;
}

HudLine lineOf(const std::string& text) {
  HudLine line;
  line.text = text;
  return line;
}

/// An answer, in a line or two.
HudLine answer(std::uint8_t number, const std::string& text, bool goesOn = false) {
  HudLine line = lineOf(text);
  line.row = {WallAction::Kind::choose, number};
  line.setIn = goesOn;
  return line;
}

BandLayout layoutOf(const std::vector<HudLine>& lines) {
  BandLayout layout;
  layOut(front(), kPicture_px, lines, layout);
  return layout;
}

TEST(BandLayout, LinesLieOneBelowTheOther) {
  const BandLayout layout =
      layoutOf({lineOf("Question"), answer(1, "One"), answer(2, "Two"), lineOf("Choose an answer.")});
  ASSERT_EQ(layout.lines.size(), 4U);
  EXPECT_EQ(layout.size_px.x, kPicture_px.x);
  EXPECT_LT(layout.size_px.y, kPicture_px.y);
  int top_px = layout.size_px.y;
  for (const BandPart& line : layout.lines) {
    EXPECT_EQ(line.size_px.x, kPicture_px.x);
    EXPECT_GE(line.size_px.y, layout.height_px) << "letters fit";
    EXPECT_LE(line.from_px.y + line.size_px.y, top_px);
    top_px = line.from_px.y;
  }
  EXPECT_GE(top_px, 0);
}

// An answer of two lines is one button, as high as both.
TEST(BandLayout, AnAnswerIsAButtonWithTheLinesThatContinueIt) {
  const BandLayout layout =
      layoutOf({lineOf("Question"), answer(1, "One"), answer(2, "Two is"), answer(2, "longer", true)});
  ASSERT_EQ(layout.buttons.size(), 2U);
  for (const BandLayout::Button& button : layout.buttons) EXPECT_TRUE(button.isRow);
  const BandPart &one = layout.buttons[0].part, &two = layout.buttons[1].part;
  EXPECT_EQ(layout.buttons[1].line, 2U);
  EXPECT_LE(two.from_px.y + two.size_px.y, one.from_px.y) << "they do not touch";
  EXPECT_EQ(two.size_px.y, one.size_px.y + layout.lines[3].size_px.y);
  EXPECT_GE(two.from_px.y, layout.lines[3].from_px.y);
  EXPECT_GT(one.from_px.x, 0);
  EXPECT_EQ(one.from_px.x + one.size_px.x, kPicture_px.x - one.from_px.x) << "in the middle";
}

TEST(BandLayout, ChipsStandBesideEachOtherInTheirLine) {
  HudLine line = lineOf("Choose an answer.");
  line.chips = {{{WallAction::Kind::goOn, 0}, "Skip  Enter"},
                {{WallAction::Kind::choose, 3}, "Again"},
                {{WallAction::Kind::again, 0}, "Leave  F7"}};
  line.chips[2].atRight = true;
  const BandLayout layout = layoutOf({lineOf("Question"), line});
  ASSERT_EQ(layout.buttons.size(), 3U);
  const BandPart& row = layout.lines[1];
  int right_px = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const BandLayout::Button& button = layout.buttons[i];
    EXPECT_EQ(button.chip, i);
    EXPECT_EQ(button.line, 1U);
    EXPECT_FALSE(button.isRow);
    EXPECT_EQ(button.action, line.chips[i].action);
    EXPECT_GT(button.part.from_px.x, right_px) << i;
    right_px = button.part.from_px.x + button.part.size_px.x;
    EXPECT_GE(button.part.from_px.y, row.from_px.y);
    EXPECT_LE(button.part.from_px.y + button.part.size_px.y, row.from_px.y + row.size_px.y);
  }
  EXPECT_EQ(right_px, kPicture_px.x - static_cast<int>(kBandMargin * layout.height_px));
}

}  // namespace
}  // namespace carom
