#include "cave/hud/hud_line.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "cave/hud/panel_place.h"
#include "cave/texts/language.h"

namespace carom {
namespace {

constexpr double kLetterWidth = 0.54, kAfterText = 0.6;  // of running text, in the nominal height
constexpr double kWidestLetter = 0.56;                   // on the average of a line
constexpr double kLeastClear = 0.1,
                 kLeastSides = 0.5;  // beside letters that are wider than that of running text
constexpr double kSmaller = 0.95;    // by so much the letters of a chip may shrink
constexpr std::size_t kIndentColumns = 3;

double runningWidthOf(std::string_view text) { return kLetterWidth * static_cast<double>(columnsOf(text)); }

}  // namespace

bool isEnglish() { return texts::language() == nullptr; }

int leastLetter_px() { return isEnglish() ? 1 : kLeastLetter_px; }

LineRoom legendRoom() { return isEnglish() ? kLegendRoom : kPanelRoom; }

LineRoom bandRoom(const Wall& wall) {
  const double letter_px = PanelPlace::bandLetter(wall) * wall.pixels.y;
  const double wide_px = (1.0 - 2.0 * PanelPlace::kMargin) * wall.pixels.x;
  const std::size_t columns =
      std::max(kPanelRoom.columns, static_cast<std::size_t>(wide_px / (kLetterWidth * letter_px)));
  const double height_px = std::ceil(letter_px);
  const double between_px = wall.pixels.x - 2.0 * std::floor(kBandMargin * height_px);
  // On a narrow wall letters get smaller.
  return {columns, std::max(between_px / height_px, kWidestLetter * static_cast<double>(columns))};
}

LineRoom behindIndent(const LineRoom& room) {
  return {room.columns - std::min(kIndentColumns, room.columns - 1), room.width_em - kIndent};
}

double widthOf(const HudChip& chip) {
  return std::max(runningWidthOf(chip.text) + 2.0 * kChipPadding,
                  kSmaller * widthOf_em(chip.text) + kLeastSides);
}

double afterText(const HudLine& line) {
  if (line.text.empty()) return 0.0;
  return std::max(runningWidthOf(line.text) + kAfterText, widthOf_em(line.text) + kLeastClear);
}

bool chipFits(const HudLine& line, const HudChip& chip, const LineRoom& room) {
  double width = afterText(line) + widthOf(chip);
  for (const HudChip& before : line.chips) width += widthOf(before) + kChipGap;
  return width <= kLetterWidth * static_cast<double>(room.columns);
}

}  // namespace carom
