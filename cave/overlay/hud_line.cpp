#include "cave/overlay/hud_line.h"

#include <algorithm>
#include <string_view>

#include "cave/overlay/panel_place.h"

namespace carom {
namespace {

constexpr double kLetterWidth = 0.54, kAfterText = 0.6;  // of running text, in the nominal height

double lettersOf(std::string_view text) {
  return static_cast<double>(std::count_if(text.begin(), text.end(), [](char byte) {
    return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U;
  }));
}

}  // namespace

std::size_t bandLetters(const Wall& wall) {
  const double letter_px = kLetterWidth * PanelPlace::bandLetter(wall) * wall.pixels.y;
  const double width_px = (1.0 - 2.0 * PanelPlace::kMargin) * wall.pixels.x;
  return std::max<std::size_t>(kLineLetters, static_cast<std::size_t>(width_px / letter_px));
}

double widthOf(const HudChip& chip) { return kLetterWidth * lettersOf(chip.text) + 2.0 * kChipPadding; }

double afterText(const HudLine& line) {
  return line.text.empty() ? 0.0 : kLetterWidth * lettersOf(line.text) + kAfterText;
}

bool chipFits(const HudLine& line, const HudChip& chip, std::size_t letters) {
  double width = afterText(line) + widthOf(chip);
  for (const HudChip& before : line.chips) width += widthOf(before) + kChipGap;
  return width <= kLetterWidth * static_cast<double>(letters);
}

}  // namespace carom
