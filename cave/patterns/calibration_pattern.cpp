#include "cave/patterns/calibration_pattern.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "cave/patterns/pattern_canvas.h"
#include "cave/room/off_axis.h"
#include "cave/room/wall_eyes.h"
#include "cave/texts/format.h"
#include "cave/texts/texts.h"

namespace carom {
namespace {

using Layout = CalibrationPatternLayout;
using Colour = PatternCanvas::Colour;
constexpr Colour kFine{56, 56, 56}, kStrong{150, 150, 150};
constexpr Colour kCircleColour{255, 220, 0};

/// Draws lines at intervals of `step_m` across the whole picture, each on the pixel in which it lies.
void drawLines(PatternCanvas& canvas, const glm::dvec2& pxPerM, double step_m, const Colour& colour) {
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

void drawGrid(PatternCanvas& canvas, const glm::dvec2& pxPerM) {
  if (showsFineLines(pxPerM)) drawLines(canvas, pxPerM, Layout::kFineLine_m, kFine);
  drawLines(canvas, pxPerM, Layout::kLine_m, kStrong);
}

/// Draws a circle that is round in metres: every pixel whose centre is less than a pixel from the line.
void drawCircle(PatternCanvas& canvas, const glm::dvec2& size_m, const glm::dvec2& pxPerM) {
  const double radius_m = Layout::kCircle * std::min(size_m.x, size_m.y);
  const double halfLine_m = 1.0 / std::min(pxPerM.x, pxPerM.y);
  for (int y = 0; y < canvas.size_px().y; ++y) {
    for (int x = 0; x < canvas.size_px().x; ++x) {
      const glm::dvec2 place_m = glm::dvec2(x + 0.5, y + 0.5) / pxPerM - 0.5 * size_m;
      if (std::abs(glm::length(place_m) - radius_m) < halfLine_m) canvas.dot(x, y, kCircleColour);
    }
  }
}

void drawColourBars(PatternCanvas& canvas) {
  constexpr std::array<Colour, 8> kBars{{PatternCanvas::kWhite,
                                         {255, 255, 0},
                                         {0, 255, 255},
                                         {0, 255, 0},
                                         {255, 0, 255},
                                         {255, 0, 0},
                                         {0, 0, 255},
                                         PatternCanvas::kBlack}};
  for (std::size_t i = 0; i < kBars.size(); ++i) {
    const double left = 0.26 + 0.06 * static_cast<double>(i);
    canvas.fillShare({left, 0.14}, {left + 0.06, 0.22}, kBars[i]);
  }
}

void writeCorners(PatternCanvas& canvas, const Wall& wall, double unit_px) {
  const glm::dvec3 upperRight_m = wall.lowerRight_m + wall.upperLeft_m - wall.lowerLeft_m;
  canvas.write(cornerWords(wall.lowerLeft_m), 0.03 * unit_px, {0.02, 0.035}, 0.0, 0.46);
  canvas.write(cornerWords(wall.lowerRight_m), 0.03 * unit_px, {0.98, 0.035}, 1.0, 0.46);
  canvas.write(cornerWords(wall.upperLeft_m), 0.03 * unit_px, {0.02, 0.965}, 0.0, 0.46);
  canvas.write(cornerWords(upperRight_m), 0.03 * unit_px, {0.98, 0.965}, 1.0, 0.46);
}

}  // namespace

Image calibrationPattern(const Wall& wall, Eye eye) {
  PatternCanvas canvas(wall.pixels);
  const glm::dvec2 size_m = sizeOf_m(wall);
  const glm::dvec2 pxPerM = glm::dvec2(wall.pixels) / size_m;
  drawGrid(canvas, pxPerM);
  drawColourBars(canvas);
  canvas.eyeBar(eye);
  canvas.frame();
  const double unit_px = std::min(wall.pixels.x, wall.pixels.y);
  canvas.write(wall.name, 0.1 * unit_px, {0.5, 0.74}, 0.5);
  canvas.write(nameOf(eye), 0.2 * unit_px, {0.5, 0.56}, 0.5);
  canvas.write(texts::format(texts::pattern::kWall, wall.node, wall.pixels.x, wall.pixels.y), 0.04 * unit_px,
               {0.5, 0.4}, 0.5);
  canvas.write(showsFineLines(pxPerM) ? texts::format(texts::pattern::kFineLines, size_m.x, size_m.y)
                                      : texts::format(texts::pattern::kCoarseLines, size_m.x, size_m.y),
               0.04 * unit_px, {0.5, 0.32}, 0.5);
  writeCorners(canvas, wall, unit_px);
  drawCircle(canvas, size_m, pxPerM);
  return canvas.take();
}

}  // namespace carom
