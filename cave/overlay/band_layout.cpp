#include "cave/overlay/band_layout.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <glm/common.hpp>

#include "cave/hud/panel_place.h"
#include "cave/room/off_axis.h"

namespace carom {
namespace {

// In the nominal height of the letters.
constexpr double kTextPitch = 1.25, kRowPitch = 1.35, kChipPitch = 1.4;  // from line to line
constexpr double kClear = 0.06;                                          // above and below a button

double pitchOf(const HudLine& line) {
  if (!line.chips.empty()) return kChipPitch;
  return line.isRow() && !line.setIn ? kRowPitch : kTextPitch;
}

/// Returns the height of a band, in the height of its letters.
double heightOf(std::span<const HudLine> lines) {
  return std::accumulate(lines.begin(), lines.end(), 1.0,
                         [](double sum, const HudLine& line) { return sum + pitchOf(line); });
}

void addChips(const HudLine& line, std::size_t number, BandLayout& layout) {
  const auto px = [&](double letters) { return static_cast<int>(letters * layout.height_px); };
  const BandPart& whole = layout.lines[number];
  const double most = static_cast<double>(layout.size_px.x) / layout.height_px - 2.0 * kBandMargin;
  double left = kBandMargin + afterText(line);
  int right_px = layout.size_px.x - px(kBandMargin);
  for (std::size_t i = 0; i < line.chips.size(); ++i) {
    const HudChip& chip = line.chips[i];
    const double width = std::min(widthOf(chip), most);  // a longer one gets smaller letters
    const int width_px = px(width);
    const int from_px = chip.atRight ? right_px - width_px : px(left);
    if (chip.atRight) {
      right_px = from_px - px(kChipGap);
    } else {
      left += width + kChipGap;
    }
    layout.buttons.push_back(
        {chip.action,
         {{from_px, whole.from_px.y + px(kClear)}, {width_px, whole.size_px.y - 2 * px(kClear)}},
         number,
         i});
  }
}

}  // namespace

void layOut(const Wall& wall, const glm::ivec2& picture_px, std::span<const HudLine> lines,
            BandLayout& layout) {
  layout.lines.clear();
  layout.buttons.clear();
  const double letters_px = PanelPlace::bandLetter(wall) * picture_px.y;
  const double most_px = PanelPlace::mostOfBand(wall) * picture_px.y / heightOf(lines);
  const double least_px = std::min<double>(leastLetter_px(), std::ceil(letters_px));
  layout.height_px = std::max(1, static_cast<int>(std::clamp(most_px, least_px, std::ceil(letters_px))));
  layout.size_px = {picture_px.x, static_cast<int>(heightOf(lines) * layout.height_px)};
  int top_px = layout.size_px.y - layout.height_px / 2;
  const int margin_px = static_cast<int>(0.5 * kBandMargin * layout.height_px);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const HudLine& line = lines[i];
    const int high_px = static_cast<int>(pitchOf(line) * layout.height_px);
    top_px -= high_px;
    layout.lines.push_back({{0, top_px}, {picture_px.x, high_px}});
    addChips(line, i, layout);
    if (!line.isRow()) continue;
    const bool goesOn = line.setIn && !layout.buttons.empty() && layout.buttons.back().action == line.row;
    if (goesOn) {
      BandPart& part = layout.buttons.back().part;
      part = {{part.from_px.x, part.from_px.y - high_px}, {part.size_px.x, part.size_px.y + high_px}};
    } else {
      const int clear_px = static_cast<int>(kClear * layout.height_px);
      layout.buttons.push_back(
          {line.row,
           {{margin_px, top_px + clear_px}, {picture_px.x - 2 * margin_px, high_px - 2 * clear_px}},
           i,
           0,
           true});
    }
  }
}

glm::ivec2 bandCorner_px(const Wall& wall, const glm::dvec2& pxPerM, int high_px) {
  const auto wall_px = static_cast<int>(sizeOf_m(wall).y * pxPerM.y);
  const auto eyes_px = static_cast<int>((PanelPlace::kEyes_m - PanelPlace::foot_m(wall)) * pxPerM.y);
  return {0, std::clamp(eyes_px, 0, std::max(0, wall_px - high_px))};
}

void addBand(const Wall& wall, std::span<const HudLine> lines, std::vector<WallButton>& buttons) {
  if (lines.empty()) return;
  BandLayout layout;
  layOut(wall, wall.pixels, lines, layout);
  const glm::dvec2 pxPerM = glm::dvec2(wall.pixels) / sizeOf_m(wall);
  const glm::ivec2 corner_px = bandCorner_px(wall, pxPerM, layout.size_px.y);
  const auto add = [&](const WallAction& action, const BandPart& part) {
    buttons.push_back(
        {action, {glm::dvec2(corner_px + part.from_px) / pxPerM, glm::dvec2(part.size_px) / pxPerM}});
  };
  for (const BandLayout::Button& button : layout.buttons) add(button.action, button.part);
  add({}, {{0, 0}, layout.size_px});
}

bool bandHolds(const LessonWords& words, const LessonPlan& plan, const Wall& wall) {
  std::vector<HudLine> lines;
  for (const LessonPhase phase : {LessonPhase::asks, LessonPhase::shows, LessonPhase::explains}) {
    for (std::uint8_t answer = 0; answer <= words.answers.size(); ++answer) {
      FrameRecord record;
      record.lesson = {phase, answer};
      describe(record, words, plan, {}, bandRoom(wall), lines);
      if (heightOf(lines) * PanelPlace::bandLetter(wall) > PanelPlace::mostOfBand(wall)) return false;
    }
  }
  return true;
}

}  // namespace carom
