#include "cave/patterns/pattern_canvas.h"

#include <algorithm>

#include <fmt/format.h>
#include <glm/common.hpp>

#include "cave/gl/glyph_bitmap.h"
#include "cave/texts/format.h"
#include "cave/texts/texts.h"

namespace carom {

using Layout = CalibrationPatternLayout;

std::string cornerWords(const glm::dvec3& corner_m) {
  return texts::format(texts::pattern::kCorner, corner_m.x, corner_m.y, corner_m.z);
}

PatternCanvas::PatternCanvas(const glm::ivec2& size_px) {
  image_.size_px = size_px;
  image_.rgb.resize(3 * static_cast<std::size_t>(size_px.x) * static_cast<std::size_t>(size_px.y));
}

std::uint8_t* PatternCanvas::at(int x, int y) {
  return &image_.rgb[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image_.size_px.x) +
                          static_cast<std::size_t>(x))];
}

void PatternCanvas::fill(glm::ivec2 from, glm::ivec2 to, const Colour& colour) {
  from = glm::max(from, glm::ivec2(0));
  to = glm::min(to, image_.size_px);
  for (int y = from.y; y < to.y; ++y) {
    for (int x = from.x; x < to.x; ++x) dot(x, y, colour);
  }
}

void PatternCanvas::fillShare(const glm::dvec2& from, const glm::dvec2& to, const Colour& colour) {
  const glm::dvec2 size(image_.size_px);
  fill(glm::ivec2(from * size), glm::ivec2(to * size), colour);
}

void PatternCanvas::dot(int x, int y, const Colour& colour) {
  std::copy(colour.begin(), colour.end(), at(x, y));
}

void PatternCanvas::whiten(const glm::ivec2& place, int alpha) {
  if (place.x < 0 || place.y < 0 || place.x >= image_.size_px.x || place.y >= image_.size_px.y) return;
  std::uint8_t* rgb = at(place.x, place.y);
  for (int i = 0; i < 3; ++i) rgb[i] = static_cast<std::uint8_t>(rgb[i] + (255 - rgb[i]) * alpha / 255);
}

void PatternCanvas::frame() {
  const glm::ivec2 size = image_.size_px;
  fill({0, 0}, {size.x, 1}, kWhite);
  fill({0, size.y - 1}, size, kWhite);
  fill({0, 0}, {1, size.y}, kWhite);
  fill({size.x - 1, 0}, size, kWhite);
}

void PatternCanvas::eyeBar(Eye eye) {
  constexpr Colour kLeftColour{255, 0, 0}, kRightColour{0, 255, 255};
  if (eye == Eye::middle) return;
  const double left = eye == Eye::left ? Layout::kEyeBar : 1.0 - Layout::kEyeBar - Layout::kEyeBarWidth;
  fillShare({left, Layout::kEyeBarRows.x}, {left + Layout::kEyeBarWidth, Layout::kEyeBarRows.y},
            eye == Eye::left ? kLeftColour : kRightColour);
}

void PatternCanvas::write(const std::string& text, double height_px, const glm::dvec2& anchor, double end,
                          double widest) {
  constexpr double kSmallest_px = 6.0;
  const double most_px = widest * image_.size_px.x;
  height_px = std::max(height_px, kSmallest_px);
  GlyphBitmap made = ink(text, static_cast<int>(height_px));
  if (made.size_px.x > most_px) {
    made = ink(text, static_cast<int>(std::max(height_px * most_px / made.size_px.x, kSmallest_px)));
  }
  const glm::dvec2 size(made.size_px);
  const glm::ivec2 from = glm::dvec2(image_.size_px) * anchor - size * glm::dvec2(end, 0.5);
  const int margin = static_cast<int>(height_px / 8.0) + 1;
  fill(from - margin, from + made.size_px + margin, kBlack);
  for (int y = 0; y < made.size_px.y; ++y) {
    for (int x = 0; x < made.size_px.x; ++x)
      whiten(from + glm::ivec2(x, y), made.alpha[static_cast<std::size_t>(y * made.size_px.x + x)]);
  }
}

}  // namespace carom
