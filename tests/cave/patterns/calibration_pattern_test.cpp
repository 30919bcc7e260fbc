// Test patterns by measure: what an operator would hold a ruler to.
#include "cave/patterns/calibration_pattern.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

namespace carom {
namespace {

using Rgb = std::array<int, 3>;
constexpr Rgb kStrong{150, 150, 150}, kFine{56, 56, 56}, kYellow{255, 220, 0}, kRed{255, 0, 0},
    kCyan{0, 255, 255};

Wall wallOf(const glm::dvec2& size_m, const glm::ivec2& pixels) {
  Wall wall;
  wall.name = "front";
  wall.lowerLeft_m = {-1.5, 0.0, -1.5};
  wall.lowerRight_m = wall.lowerLeft_m + glm::dvec3(size_m.x, 0.0, 0.0);
  wall.upperLeft_m = wall.lowerLeft_m + glm::dvec3(0.0, size_m.y, 0.0);
  wall.pixels = pixels;
  return wall;
}

Rgb at(const Image& image, int x, int y) {
  const std::size_t i = 3 * static_cast<std::size_t>(y * image.size_px.x + x);
  return {image.rgb[i], image.rgb[i + 1], image.rgb[i + 2]};
}

/// Columns of a colour in a row, or rows of it in a column.
std::vector<int> placesOf(const Image& image, const Rgb& colour, int across, bool columns) {
  std::vector<int> places;
  for (int i = 0; i < (columns ? image.size_px.x : image.size_px.y); ++i) {
    if ((columns ? at(image, i, across) : at(image, across, i)) == colour) places.push_back(i);
  }
  return places;
}

TEST(CalibrationPattern, StrongLinesAreTenCentimetresApart) {
  // 3 m over 600 pixels and 2 m over 500: 20 and 25 pixels a line. Row 462 and column 555 cross nothing else.
  const Image image = calibrationPattern(wallOf({3.0, 2.0}, {600, 500}), Eye::middle);
  const std::vector<int> columns = placesOf(image, kStrong, 462, true);
  ASSERT_EQ(columns.size(), 29u);  // 30 gaps; the white frame covers the line at the edge
  for (std::size_t i = 0; i < columns.size(); ++i) EXPECT_EQ(columns[i], 20 * static_cast<int>(i + 1));
  const std::vector<int> rows = placesOf(image, kStrong, 555, false);
  ASSERT_GE(rows.size(), 17u);  // 20 gaps, less what the corners' words cover
  for (const int row : rows) EXPECT_EQ(row % 25, 0) << row;
}

TEST(CalibrationPattern, WeakLinesAreCentimetresWherePixelsAreFineEnough) {
  const Image fine =
      calibrationPattern(wallOf({1.0, 1.0}, {600, 600}), Eye::middle);  // 6 pixels a centimetre
  const std::vector<int> columns = placesOf(fine, kFine, 557, true);
  ASSERT_EQ(columns.size(), 90u);  // of 101 lines, 11 are strong
  EXPECT_EQ(columns.front(), 6);
  EXPECT_EQ(columns.back(), 594);
  const Image coarse = calibrationPattern(wallOf({3.0, 3.0}, {600, 600}), Eye::middle);  // 2 pixels
  EXPECT_TRUE(placesOf(coarse, kFine, 557, true).empty());
}

// Pixels twice as wide as high: an ellipse of pixels, a circle of metres.
TEST(CalibrationPattern, TheCircleIsRoundOnTheWall) {
  const glm::dvec2 size_m(4.0, 2.0);
  const glm::ivec2 pixels(400, 400);
  const Image image = calibrationPattern(wallOf(size_m, pixels), Eye::middle);
  const glm::dvec2 metresPerPixel = size_m / glm::dvec2(pixels);
  std::array<int, 8> octants{};
  for (int y = 0; y < pixels.y; ++y) {
    for (int x = 0; x < pixels.x; ++x) {
      if (at(image, x, y) != kYellow) continue;
      const double x_m = (x + 0.5) * metresPerPixel.x - 2.0;
      const double y_m = (y + 0.5) * metresPerPixel.y - 1.0;
      EXPECT_NEAR(std::hypot(x_m, y_m), 0.8, 0.011) << x << ", " << y;  // 0.4 × 2 m; one wide pixel, 10 mm
      octants[static_cast<std::size_t>((std::atan2(y_m, x_m) + M_PI) / (M_PI / 4.0)) % 8]++;
    }
  }
  for (const int count : octants) EXPECT_GT(count, 20);
}

TEST(CalibrationPattern, EachEyeHasABarOfItsOwn) {
  const Wall wall = wallOf({3.0, 3.0}, {600, 600});
  const Image left = calibrationPattern(wall, Eye::left), right = calibrationPattern(wall, Eye::right),
              mono = calibrationPattern(wall, Eye::middle);
  // The middles of the bars: 0.08 and 0.92 of the width.
  EXPECT_EQ(at(left, 48, 301), kRed);
  EXPECT_EQ(at(right, 551, 301), kCyan);
  EXPECT_EQ(at(left, 551, 301), at(mono, 551, 301));
  EXPECT_EQ(at(right, 48, 301), at(mono, 48, 301));
  EXPECT_NE(at(mono, 48, 301), kRed);
  EXPECT_NE(at(mono, 551, 301), kCyan);
}

int differences(const Image& a, const Image& b, const glm::ivec2& from, const glm::ivec2& to) {
  int count = 0;
  for (int y = from.y; y < to.y; ++y) {
    for (int x = from.x; x < to.x; ++x) count += at(a, x, y) != at(b, x, y);
  }
  return count;
}

// Words are there and say different things: each corner's changes with that corner, the big one with the eye.
TEST(CalibrationPattern, WordsFollowWhatTheyName) {
  const Wall wall = wallOf({3.0, 3.0}, {600, 600});
  const Image image = calibrationPattern(wall, Eye::left);
  EXPECT_GT(differences(image, calibrationPattern(wall, Eye::right), {150, 290}, {450, 380}), 500);
  Wall moved = wall;  // 4 mm up: the same grid and circle, other numbers in all corners
  for (glm::dvec3* corner : {&moved.lowerLeft_m, &moved.lowerRight_m, &moved.upperLeft_m}) corner->y += 0.004;
  const Image other = calibrationPattern(moved, Eye::left);
  for (const glm::ivec2& corner :
       {glm::ivec2(0, 0), glm::ivec2(300, 0), glm::ivec2(0, 540), glm::ivec2(300, 540)}) {
    EXPECT_GT(differences(image, other, corner, corner + glm::ivec2(300, 60)), 10)
        << corner.x << ", " << corner.y;
  }
  EXPECT_EQ(differences(image, other, {0, 60}, {600, 540}), 0);
  Wall elsewhere = wall;
  elsewhere.node = 3;
  EXPECT_GT(differences(image, calibrationPattern(elsewhere, Eye::left), {100, 200}, {500, 270}), 5);
  Wall renamed = wall;
  renamed.name = "floor";
  EXPECT_GT(differences(image, calibrationPattern(renamed, Eye::left), {100, 400}, {500, 500}), 100);
}

TEST(CalibrationPattern, TheOutermostPixelsAreWhite) {
  const Image image = calibrationPattern(wallOf({3.0, 2.0}, {300, 200}), Eye::middle);
  const Rgb white{255, 255, 255};
  for (int x = 0; x < 300; ++x) EXPECT_TRUE(at(image, x, 0) == white && at(image, x, 199) == white) << x;
  for (int y = 0; y < 200; ++y) EXPECT_TRUE(at(image, 0, y) == white && at(image, 299, y) == white) << y;
}

// Small walls of tests and thumbnails: nothing is written outside the picture.
TEST(CalibrationPattern, AnySizeCanBeDrawn) {
  for (const glm::ivec2 pixels :
       {glm::ivec2(1, 1), glm::ivec2(3, 64), glm::ivec2(64, 5), glm::ivec2(17, 19)}) {
    const Image image = calibrationPattern(wallOf({3.0, 2.0}, pixels), Eye::right);
    EXPECT_EQ(image.rgb.size(), 3 * static_cast<std::size_t>(pixels.x * pixels.y));
  }
}

}  // namespace
}  // namespace carom
