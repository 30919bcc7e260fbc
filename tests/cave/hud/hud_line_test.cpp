// How wide the parts of the panel's lines are.
#include "cave/hud/hud_line.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "app/scenario/scenario.h"
#include "cave/hud/hud_text.h"
#include "places.h"

namespace carom {
namespace {

// Chips of the shipped lessons are as wide as the number of their letters makes them, and stand where the
// number of those before them puts them.
TEST(LineBreaks, EnglishChipsAreAsWideAsTheirNumberOfLetters) {
  constexpr double kLetter = 0.54;
  int chips = 0;
  for (const auto& entry : std::filesystem::directory_iterator(CAROM_CONFIG_DIR "/scenarios")) {
    const Scenario game = readScenario(entry.path());
    if (!game.lesson) continue;
    for (const LessonPhase phase : {LessonPhase::asks, LessonPhase::shows, LessonPhase::explains}) {
      FrameRecord record;
      record.lesson = {phase, 1};
      std::vector<HudLine> lines;
      describe(record, game.lesson->words, game.lesson->plan, {}, {60, 34.0}, lines);
      for (const HudLine& line : lines) {
        if (line.chips.empty()) continue;
        const auto letters = static_cast<double>(columnsOf(line.text));
        EXPECT_DOUBLE_EQ(afterText(line), line.text.empty() ? 0.0 : kLetter * letters + 0.6) << line.text;
        for (const HudChip& chip : line.chips) {
          EXPECT_DOUBLE_EQ(widthOf(chip), kLetter * static_cast<double>(columnsOf(chip.text)) + 1.2)
              << chip.text;
          ++chips;
        }
      }
    }
  }
  EXPECT_GT(chips, 100);
  EXPECT_GT(widthOf({{}, "光は遅い、だから過去が見える"}), 14.0) << "wider letters need more";
}

// A chip fits where the text, the chips before it and the gaps between them leave it room.
TEST(HudLine, ChipsFitUntilTheLineIsFull) {
  const LineRoom room{60, 34.0};
  for (const char* const text : {"", "Choose an answer."}) {
    HudLine line;
    line.text = text;
    const HudChip chip{{}, "Skip  Enter"};
    double width = afterText(line) + widthOf(chip);
    int chips = 0;
    for (; chipFits(line, chip, room); ++chips) {
      ASSERT_LE(width, 0.54 * 60.0 + 1e-9) << chips;
      line.chips.push_back(chip);
      width += widthOf(chip) + kChipGap;
    }
    EXPECT_GT(width, 0.54 * 60.0) << "another one would have had room";
    EXPECT_GT(chips, 0);
  }
}

TEST(HudLine, AnIndentTakesThreeLettersButLeavesOne) {
  EXPECT_EQ(behindIndent({40, 24.0}).columns, 37U);
  EXPECT_NEAR(behindIndent({40, 24.0}).width_em, 24.0 - kIndent, 1e-12);
  EXPECT_EQ(behindIndent({2, 24.0}).columns, 1U);
}

}  // namespace
}  // namespace carom
