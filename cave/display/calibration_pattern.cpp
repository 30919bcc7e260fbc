#include "cave/display/calibration_pattern.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "cave/gl/glyph_bitmap.h"
#include "cave/room/off_axis.h"
#include "cave/room/wall_eyes.h"
#include "cave/texts/texts.h"

namespace carom {
namespace {

using Layout = CalibrationPatternLayout;
using Colour = std::array<std::uint8_t, 3>;
constexpr Colour kBlack{0, 0, 0}, kWhite{255, 255, 255};
constexpr Colour kFine{56, 56, 56}, kStrong{150, 150, 150};
constexpr Colour kCircleColour{255, 220, 0}, kLeftColour{255, 0, 0}, kRightColour{0, 255, 255};

/// A picture to draw on. Rows count from the bottom.
class Canvas {
 public:
  explicit Canvas(const glm::ivec2& size_px) {
    image_.size_px = size_px;
    image_.rgb.resize(3 * static_cast<std::size_t>(size_px.x) * static_cast<std::size_t>(size_px.y));
  }

  const glm::ivec2& size_px() const { return image_.size_px; }
  Image take() { return std::move(image_); }

  /// Fills from `from` up to, but not including, `to`; parts outside the picture are left out.
  void fill(glm::ivec2 from, glm::ivec2 to, const Colour& colour) {
    from = glm::max(from, glm::ivec2(0));
    to = glm::min(to, image_.size_px);
    for (int y = from.y; y < to.y; ++y) {
      for (int x = from.x; x < to.x; ++x) dot(x, y, colour);
    }
  }

  void dot(int x, int y, const Colour& colour) { std::copy(colour.begin(), colour.end(), at(x, y)); }

  /// Blends white in, with an opacity of `alpha`/255.
  void whiten(const glm::ivec2& place, int alpha) {
    if (place.x < 0 || place.y < 0 || place.x >= image_.size_px.x || place.y >= image_.size_px.y) return;
    std::uint8_t* rgb = at(place.x, place.y);
    for (int i = 0; i < 3; ++i) rgb[i] = static_cast<std::uint8_t>(rgb[i] + (255 - rgb[i]) * alpha / 255);
  }

 private:
  std::uint8_t* at(int x, int y) {
    return &image_.rgb[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image_.size_px.x) +
                            static_cast<std::size_t>(x))];
  }

  Image image_;
};

/// Draws lines at intervals of `step_m` across the whole picture, each on the pixel in which it lies.
void drawLines(Canvas& canvas, const glm::dvec2& pxPerM, double step_m, const Colour& colour) {
  const glm::ivec2 size = canvas.size_px();
  const auto count = [&](int axis) { return static_cast<int>(size[axis] / pxPerM[axis] / step_m); };
  const auto pixel = [&](int axis, int line) { return static_cast<int>(line * step_m * pxPerM[axis]); };
  for (int line = 0; line <= count(0); ++line)
    canvas.fill({pixel(0, line), 0}, {pixel(0, line) + 1, size.y}, colour);
  for (int line = 0; line <= count(1); ++line)
    canvas.fill({0, pixel(1, line)}, {size.x, pixel(1, line) + 1}, colour);
}

bool showsFineLines(const glm::dvec2& pxPerM) {
  return std::min(pxPerM.x, pxPerM.y) * Layout::kFineLine_m >= Layout::kFinest_px;
}

void drawGrid(Canvas& canvas, const glm::dvec2& pxPerM) {
  if (showsFineLines(pxPerM)) drawLines(canvas, pxPerM, Layout::kFineLine_m, kFine);
  drawLines(canvas, pxPerM, Layout::kLine_m, kStrong);
}

/// Draws a circle that is round in metres: every pixel whose centre is less than a pixel from the line.
void drawCircle(Canvas& canvas, const glm::dvec2& size_m, const glm::dvec2& pxPerM) {
  const double radius_m = Layout::kCircle * std::min(size_m.x, size_m.y);
  const double halfLine_m = 1.0 / std::min(pxPerM.x, pxPerM.y);
  for (int y = 0; y < canvas.size_px().y; ++y) {
    for (int x = 0; x < canvas.size_px().x; ++x) {
      const glm::dvec2 place_m = glm::dvec2(x + 0.5, y + 0.5) / pxPerM - 0.5 * size_m;
      if (std::abs(glm::length(place_m) - radius_m) < halfLine_m) canvas.dot(x, y, kCircleColour);
    }
  }
}

void drawFrame(Canvas& canvas) {
  const glm::ivec2 size = canvas.size_px();
  canvas.fill({0, 0}, {size.x, 1}, kWhite);
  canvas.fill({0, size.y - 1}, size, kWhite);
  canvas.fill({0, 0}, {1, size.y}, kWhite);
  canvas.fill({size.x - 1, 0}, size, kWhite);
}

/// Fills a box given by two corners, as fractions of the picture's size.
void fillShare(Canvas& canvas, const glm::dvec2& from, const glm::dvec2& to, const Colour& colour) {
  const glm::dvec2 size(canvas.size_px());
  canvas.fill(glm::ivec2(from * size), glm::ivec2(to * size), colour);
}

void drawColourBars(Canvas& canvas) {
  constexpr std::array<Colour, 8> kBars{
      {kWhite, {255, 255, 0}, {0, 255, 255}, {0, 255, 0}, {255, 0, 255}, {255, 0, 0}, {0, 0, 255}, kBlack}};
  for (std::size_t i = 0; i < kBars.size(); ++i) {
    const double left = 0.26 + 0.06 * static_cast<double>(i);
    fillShare(canvas, {left, 0.14}, {left + 0.06, 0.22}, kBars[i]);
  }
}

void drawEyeBar(Canvas& canvas, Eye eye) {
  if (eye == Eye::middle) return;
  const double left = eye == Eye::left ? Layout::kEyeBar : 1.0 - Layout::kEyeBar - Layout::kEyeBarWidth;
  fillShare(canvas, {left, Layout::kEyeBarRows.x}, {left + Layout::kEyeBarWidth, Layout::kEyeBarRows.y},
            eye == Eye::left ? kLeftColour : kRightColour);
}

/// Writes white text on black, smaller if it would be wider than `widest` of the picture's width. `anchor`, a
/// fraction of the picture's size, is where the text's left (0), middle (0.5) or right (1) end lies, at half
/// its height.
void write(Canvas& canvas, const std::string& text, double height_px, const glm::dvec2& anchor, double end,
           double widest = 0.7) {
  constexpr double kSmallest_px = 6.0;
  const double most_px = widest * canvas.size_px().x;
  height_px = std::max(height_px, kSmallest_px);
  GlyphBitmap made = ink(text, static_cast<int>(height_px));
  if (made.size_px.x > most_px) {
    made = ink(text, static_cast<int>(std::max(height_px * most_px / made.size_px.x, kSmallest_px)));
  }
  const glm::dvec2 size(made.size_px);
  const glm::ivec2 from = glm::dvec2(canvas.size_px()) * anchor - size * glm::dvec2(end, 0.5);
  const int margin = static_cast<int>(height_px / 8.0) + 1;
  canvas.fill(from - margin, from + made.size_px + margin, kBlack);
  for (int y = 0; y < made.size_px.y; ++y) {
    for (int x = 0; x < made.size_px.x; ++x)
      canvas.whiten(from + glm::ivec2(x, y), made.alpha[static_cast<std::size_t>(y * made.size_px.x + x)]);
  }
}

std::string words(const glm::dvec3& corner_m) {
  return fmt::format(texts::pattern::kCorner, corner_m.x, corner_m.y, corner_m.z);
}

void writeCorners(Canvas& canvas, const Wall& wall, double unit_px) {
  const glm::dvec3 upperRight_m = wall.lowerRight_m + wall.upperLeft_m - wall.lowerLeft_m;
  write(canvas, words(wall.lowerLeft_m), 0.03 * unit_px, {0.02, 0.035}, 0.0, 0.46);
  write(canvas, words(wall.lowerRight_m), 0.03 * unit_px, {0.98, 0.035}, 1.0, 0.46);
  write(canvas, words(wall.upperLeft_m), 0.03 * unit_px, {0.02, 0.965}, 0.0, 0.46);
  write(canvas, words(upperRight_m), 0.03 * unit_px, {0.98, 0.965}, 1.0, 0.46);
}

}  // namespace

Image calibrationPattern(const Wall& wall, Eye eye) {
  Canvas canvas(wall.pixels);
  const glm::dvec2 size_m = sizeOf_m(wall);
  const glm::dvec2 pxPerM = glm::dvec2(wall.pixels) / size_m;
  drawGrid(canvas, pxPerM);
  drawColourBars(canvas);
  drawEyeBar(canvas, eye);
  drawFrame(canvas);
  const double unit_px = std::min(wall.pixels.x, wall.pixels.y);
  write(canvas, wall.name, 0.1 * unit_px, {0.5, 0.74}, 0.5);
  write(canvas, nameOf(eye), 0.2 * unit_px, {0.5, 0.56}, 0.5);
  write(canvas, fmt::format(texts::pattern::kWall, wall.node, wall.pixels.x, wall.pixels.y), 0.04 * unit_px,
        {0.5, 0.4}, 0.5);
  write(canvas,
        showsFineLines(pxPerM) ? fmt::format(texts::pattern::kFineLines, size_m.x, size_m.y)
                               : fmt::format(texts::pattern::kCoarseLines, size_m.x, size_m.y),
        0.04 * unit_px, {0.5, 0.32}, 0.5);
  writeCorners(canvas, wall, unit_px);
  drawCircle(canvas, size_m, pxPerM);
  return canvas.take();
}

}  // namespace carom
