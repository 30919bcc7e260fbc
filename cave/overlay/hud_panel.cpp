#include "cave/overlay/hud_panel.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

#include "cave/hud/panel_place.h"
#include "cave/room/off_axis.h"

namespace carom {
namespace {

constexpr double kLine = 1.5;         // from line to line of the panel, in that height
constexpr double kText = 2.0;         // where its text begins, behind the marks of the legend
constexpr double kSmallest_px = 9.0;  // smaller letters are illegible
constexpr PanelPicture::Rgba kGround{12, 14, 18, 175};  // dark; half of the picture shows through
constexpr PanelPicture::Rgba kButton{32, 66, 112, 235}, kOn{62, 84, 96, 235};
constexpr glm::vec3 kWhite(235.0F), kUrgent(255.0F, 200.0F, 70.0F);  // letters

/// Returns the indent of a line, which is that of an answer behind its number.
int beginOf_px(const HudLine& line, int height_px) { return line.setIn ? 8 * height_px / 5 : 0; }

/// Returns the text's ink, in smaller letters if it would be wider than this.
GlyphBitmap inkWithin(const std::string& text, int height_px, int most_px) {
  GlyphBitmap written = ink(text, height_px);
  if (written.size_px.x <= most_px || most_px <= 0) return written;
  return ink(text, std::max(std::min(leastLetter_px(), height_px), height_px * most_px / written.size_px.x));
}

}  // namespace

void HudPanel::set(const std::vector<HudLine>& lines) {
  if (lines.size() != lines_.size()) written_ = false;
  lines_.resize(lines.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (lines[i] == lines_[i].line) continue;
    lines_[i].line = lines[i];
    lines_[i].ink = {};
    lines_[i].chips.clear();
    written_ = false;
  }
}

void HudPanel::follow(const SeenFrame& seen) {
  if (!text_.follow(seen)) return;
  if (text_.isBand() != band_) written_ = false;
  band_ = text_.isBand();
  set(text_.lines());
}

int HudPanel::endOf_px(const Written& written, int height_px) {
  return beginOf_px(written.line, height_px) + written.ink.size_px.x;
}

/// Renders the letters of the lines that have changed, or of all in another height.
void HudPanel::inkLines(int height_px) {
  for (Written& written : lines_) {
    if (height_px != height_px_ || written.ink.size_px.x == 0)
      written.ink = ink(written.line.text, height_px);
  }
  height_px_ = height_px;
}

void HudPanel::writePanel(const glm::ivec2& picture_px, const Wall& wall) {
  const double capital_px = wall.textSize * PanelPlace::kCapital_m * picture_px.y / sizeOf_m(wall).y;
  int height_px =
      static_cast<int>(std::ceil(std::max(kSmallest_px, capital_px / PanelPlace::kCapitalOfLetters)));
  inkLines(height_px);
  int widest_px = 0;
  for (const Written& written : lines_) widest_px = std::max(widest_px, endOf_px(written, height_px));
  // A small wall gets small letters.
  const double wide = widest_px + 2.0 * kText * height_px;
  const double high = (kLine * static_cast<double>(lines_.size()) + 1.0) * height_px;
  const double share = std::min(PanelPlace::kMostOfWidth * picture_px.x / wide,
                                PanelPlace::kMostOfHeight * picture_px.y / high);
  if (share < 1.0) inkLines(std::max(leastLetter_px(), static_cast<int>(share * height_px)));
}

/// Renders the letters of the band. Lines are as long as they should be; what is longer all the same gets
/// smaller letters.
void HudPanel::writeBand() {
  const int height_px = layout_.height_px, margin_px = static_cast<int>(kBandMargin * height_px);
  inkLines(height_px);
  for (Written& written : lines_) {
    const int most_px = layout_.size_px.x - 2 * margin_px - beginOf_px(written.line, height_px);
    if (written.ink.size_px.x > most_px) written.ink = inkWithin(written.line.text, height_px, most_px);
    written.chips.resize(written.line.chips.size());
  }
  for (const BandLayout::Button& button : layout_.buttons) {
    if (button.isRow) continue;
    Written& written = lines_[button.line];
    written.chips[button.chip] =
        inkWithin(written.line.chips[button.chip].text, height_px, button.part.size_px.x - height_px / 2);
  }
}

void HudPanel::write(const glm::ivec2& picture_px, const Wall& wall) {
  if (picture_px_ != picture_px) height_px_ = 0;
  picture_px_ = picture_px;
  buttons_.clear();
  if (!band_) return writePanel(picture_px, wall);
  layOut(wall, picture_px, text_.lines(), layout_);
  addBand(wall, text_.lines(), buttons_);
  writeBand();
}

/// Paints the background, the marks and the letters.
void HudPanel::paintPanel() {
  const int height_px = height_px_, line_px = static_cast<int>(kLine * height_px),
            mark_px = 3 * height_px / 4;
  int widest_px = 0;
  for (const Written& written : lines_) widest_px = std::max(widest_px, endOf_px(written, height_px));
  widest_px += height_px - widest_px % height_px;  // so that the width does not change with every digit
  const glm::ivec2 size_px{widest_px + 3 * height_px, line_px * static_cast<int>(lines_.size()) + height_px};
  panel_.begin(size_px, kGround);
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const HudLine& line = lines_[i].line;
    const int text_px = static_cast<int>(kText * height_px) + beginOf_px(line, height_px);
    const int foot_px = size_px.y - height_px / 2 - static_cast<int>(i + 1) * line_px;
    panel_.write({text_px, foot_px}, lines_[i].ink, line.urgent ? kUrgent : kWhite);
    if (!line.mark) continue;
    const glm::vec3 mark = 255.0F * *line.mark;
    panel_.fill({2 * height_px / 3, foot_px + height_px / 4}, glm::ivec2(mark_px),
                {static_cast<std::uint8_t>(mark.x), static_cast<std::uint8_t>(mark.y),
                 static_cast<std::uint8_t>(mark.z), 255});
  }
  panel_.upload();
}

/// Paints the background, the buttons and the letters.
void HudPanel::paintBand() {
  const int height_px = layout_.height_px;
  panel_.begin(layout_.size_px, kGround);
  const auto isPointed = [&](const WallAction& action) {
    return action.kind != WallAction::Kind::none && action == pointed_;
  };
  const auto footIn = [&](const BandPart& part) { return part.from_px.y + (part.size_px.y - height_px) / 2; };
  for (const BandLayout::Button& button : layout_.buttons) {
    const HudLine& line = lines_[button.line].line;
    const bool isOn = !button.isRow && line.chips[button.chip].isOn;
    panel_.fill(button.part.from_px, button.part.size_px,
                isPointed(button.action) ? PanelPicture::kPointed
                : isOn                   ? kOn
                                         : kButton);
    if (button.isRow) continue;
    const GlyphBitmap& words = lines_[button.line].chips[button.chip];
    const int left_px = button.part.from_px.x + (button.part.size_px.x - words.size_px.x) / 2;
    const glm::vec3& colour = isPointed(button.action) ? PanelPicture::kOnPointed : isOn ? kUrgent : kWhite;
    panel_.write({left_px, footIn(button.part)}, words, colour);
  }
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const HudLine& line = lines_[i].line;
    const int text_px = static_cast<int>(kBandMargin * height_px) + beginOf_px(line, height_px);
    const glm::vec3 colour = isPointed(line.row) ? PanelPicture::kOnPointed
                             : line.urgent       ? kUrgent
                             : line.mark         ? 255.0F * *line.mark
                                                 : kWhite;
    panel_.write({text_px, footIn(layout_.lines[i])}, lines_[i].ink, colour);
  }
  panel_.upload();
}

void HudPanel::draw(const Wall& wall, const SeenFrame& seen, const RenderTarget& picture) {
  draw(wall, band_ ? pointedByHand(wall, buttons_, seen) : WallAction{}, picture);
}

void HudPanel::draw(const Wall& wall, const RenderTarget& picture) { draw(wall, WallAction{}, picture); }

void HudPanel::draw(const Wall& wall, const WallAction& pointed, const RenderTarget& picture) {
  if (lines_.empty()) return;
  const glm::dvec2 pxPerM = glm::dvec2(picture.size_px()) / sizeOf_m(wall);
  if (!written_ || picture_px_ != picture.size_px() || pointed != pointed_) {
    write(picture.size_px(), wall);
    pointed_ = pointed;
    band_ ? paintBand() : paintPanel();
    written_ = true;
  }
  const double margin_m = PanelPlace::kMargin * sizeOf_m(wall).y;
  const int high_px = panel_.size_px().y;
  const glm::ivec2 panel_px{
      static_cast<int>(margin_m * pxPerM.x),
      std::max(0, static_cast<int>(PanelPlace::top_m(wall, margin_m) * pxPerM.y) - high_px)};
  // Draws pixel on pixel, unless pixels are not square.
  panel_.draw(picture, band_ ? bandCorner_px(wall, pxPerM, high_px) : panel_px, pxPerM.x / pxPerM.y);
}

}  // namespace carom
