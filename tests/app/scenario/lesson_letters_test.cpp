// Every letter of the shipped lessons can be written on a wall, and large enough.
#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "app/rig/rig.h"
#include "app/scenario/scenario.h"
#include "cave/gl/glyph_bitmap.h"
#include "cave/hud/panel_place.h"
#include "cave/hud/sentences.h"
#include "cave/overlay/band_layout.h"
#include "places.h"

namespace carom {
namespace {

/// Letters beyond ASCII.
std::set<std::string> lettersOf(const std::string& text) {
  std::set<std::string> letters;
  for (std::size_t i = 0; i < text.size();) {
    std::size_t end = i + 1;
    while (end < text.size() && (text[end] & 0xC0) == 0x80) ++end;
    if (end > i + 1) letters.insert(text.substr(i, end - i));
    i = end;
  }
  return letters;
}

TEST(LessonLetters, FitIntoTheBandOfEveryShippedRig) {
  std::vector<Wall> fronts;
  for (const auto& entry : std::filesystem::directory_iterator(CAROM_CONFIG_DIR "/rigs"))
    fronts.push_back(frontWall(roomGeometryOf(readRig(entry.path()))).value());
  ASSERT_GE(fronts.size(), 4U);
  for (const auto& entry : std::filesystem::directory_iterator(CAROM_CONFIG_DIR "/scenarios")) {
    const Scenario scenario = readScenario(entry.path());
    if (!scenario.lesson) continue;
    for (const Wall& front : fronts) {
      EXPECT_TRUE(bandHolds(scenario.lesson->words, scenario.lesson->plan, front))
          << entry.path() << " on a wall of " << front.pixels.x << " x " << front.pixels.y << " pixels";
    }
  }
}

/// Expects that the band's buttons lie within it, none on another, and that the last one is the way out.
void expectApart(const Wall& front, const std::vector<HudLine>& lines, const std::string& where) {
  BandLayout layout;
  layOut(front, front.pixels, lines, layout);
  ASSERT_FALSE(layout.buttons.empty()) << where;
  EXPECT_EQ(layout.buttons.back().action, actionOf(Choice::play)) << where;
  for (std::size_t i = 0; i < layout.buttons.size(); ++i) {
    const BandPart& a = layout.buttons[i].part;
    EXPECT_TRUE(a.from_px.x >= 0 && a.from_px.y >= 0 && a.from_px.x + a.size_px.x <= layout.size_px.x &&
                a.from_px.y + a.size_px.y <= layout.size_px.y)
        << where << " " << i;
    for (std::size_t j = 0; j < i; ++j) {
      const BandPart& b = layout.buttons[j].part;
      EXPECT_TRUE(a.from_px.x >= b.from_px.x + b.size_px.x || b.from_px.x >= a.from_px.x + a.size_px.x ||
                  a.from_px.y >= b.from_px.y + b.size_px.y || b.from_px.y >= a.from_px.y + a.size_px.y)
          << where << ": " << i << " covers " << j;
    }
  }
}

// As wide as they are written, lines fit beside the band's margins, so that their letters need not shrink.
TEST(LessonLetters, LinesAreNoWiderThanTheBand) {
  constexpr int kHeight_px = 30;
  constexpr double kCapital = 0.72;  // of the nominal height
  for (const char* name : {"/rigs/play.toml", "/rigs/desk.toml"}) {
    const Wall front = frontWall(roomGeometryOf(readRig(std::string(CAROM_CONFIG_DIR) + name))).value();
    const double wide_px = kCapital * kHeight_px / PanelPlace::kBandCapital * front.pixels.x / front.pixels.y;
    for (const auto& entry : std::filesystem::directory_iterator(CAROM_CONFIG_DIR "/scenarios")) {
      const Scenario scenario = readScenario(entry.path());
      if (!scenario.lesson) continue;
      std::vector<std::pair<LessonPhase, double>> moments{{LessonPhase::asks, 0.0},
                                                          {LessonPhase::shows, 0.0}};
      double explained_s = 0.0;
      for (const std::string_view sentence : sentencesOf(scenario.lesson->words.number)) {
        moments.emplace_back(LessonPhase::explains, explained_s);
        explained_s += standsFor_s(sentence);
      }
      for (const auto& [phase, since_s] : moments) {
        FrameRecord record;
        record.lesson = {phase, 1};
        std::vector<HudLine> lines;
        describe(record, scenario.lesson->words, scenario.lesson->plan, {}, bandRoom(front), lines, true,
                 since_s);
        for (const HudLine& line : lines) {
          const double indent_px = line.setIn ? 1.6 * kHeight_px : 0.0;
          EXPECT_LE(ink(line.text, kHeight_px).size_px.x + indent_px + 2.5 * kHeight_px, wide_px)
              << entry.path() << name << ": " << line.text;
          for (const HudChip& chip : line.chips)
            EXPECT_LE(ink(chip.text, kHeight_px).size_px.x + 0.5 * kHeight_px, kHeight_px * widthOf(chip))
                << entry.path() << name << ": " << chip.text;
        }
        expectApart(front, lines, entry.path().stem().string() + name);
      }
    }
  }
}

TEST(LessonLetters, HaveInkOfTheirOwn) {
  constexpr int kHeight_px = 30;
  const GlyphBitmap missing = ink("\u0FFF", kHeight_px);  // no letter: what the font shows for what it lacks
  std::set<std::string> letters;
  for (const auto& entry : std::filesystem::directory_iterator(CAROM_CONFIG_DIR "/scenarios")) {
    const Scenario scenario = readScenario(entry.path());
    if (!scenario.lesson) continue;
    const LessonWords& words = scenario.lesson->words;
    std::string all = words.question + words.todo + words.notice + words.number;
    for (const std::string& answer : words.answers) all += answer;
    letters.merge(lettersOf(all));
  }
  EXPECT_TRUE(letters.contains("γ"));
  for (const std::string& letter : letters) {
    const GlyphBitmap written = ink(letter, kHeight_px);
    EXPECT_FALSE(written.alpha.empty()) << letter;
    EXPECT_FALSE(written.size_px == missing.size_px && written.alpha == missing.alpha) << letter;
  }
}

}  // namespace
}  // namespace carom
