// Edges smoothed in the finished picture (cave/render/edge_pixels.h) against the same picture with 16 × 16
// samples a pixel, and on their way from what was drawn into a wall's picture (cave/render/edge_smoother.h).
#include "cave/render/edge_smoother.h"

#include <gtest/gtest.h>
#include <vtk_glew.h>

#include <cmath>
#include <functional>
#include <span>
#include <vector>

#include "cave/gl/graphics.h"
#include "cave/pictures/image.h"
#include "engine/random_world.h"

namespace carom {
namespace {

constexpr int kWide_px = 101, kHigh_px = 67;  // no whole number of tiles

struct Pixel {
  std::uint8_t grey = 0;
  std::uint8_t tone = 0;
};
using Painting = std::function<Pixel(double x, double y)>;  // in pixels from the lower left

/// Writes a painting: rows from the bottom up.
void paintInto(std::span<std::uint32_t> pixels, const Painting& painting, const glm::ivec2& size_px) {
  auto to = pixels.begin();
  for (int y = 0; y < size_px.y; ++y) {
    for (int x = 0; x < size_px.x; ++x) {
      const Pixel pixel = painting(x + 0.5, y + 0.5);
      *to++ = pixel.grey * 0x010101U | static_cast<std::uint32_t>(pixel.tone) << 24U;
    }
  }
}

/// Returns the grey of a pixel with many samples.
double sampled(const Painting& painting, int x, int y) {
  constexpr int kSamples = 16;
  double sum = 0.0;
  for (int i = 0; i < kSamples * kSamples; ++i)
    sum += painting(x + (i % kSamples + 0.5) / kSamples, y + (i / kSamples + 0.5) / kSamples).grey;
  return sum / (kSamples * kSamples);
}

/// Returns the greys of a painting, smoothed: rows from the bottom up.
std::vector<int> smoothed(const Painting& painting, const glm::ivec2& size_px = {kWide_px, kHigh_px}) {
  EdgePixels edges(EdgePixels::Tones::inAlpha);
  paintInto(edges.begin(size_px), painting, size_px);
  std::vector<int> greys;
  for (const std::uint32_t pixel : edges.smooth()) greys.push_back(static_cast<int>(pixel & 255U));
  return greys;
}

/// Grey 40 below a straight edge through (x, y) with this slope, 220 above it; tones as different.
Painting edgeThrough(double x, double y, double angle_rad) {
  const double nx = -std::sin(angle_rad), ny = std::cos(angle_rad);
  return [=](double px, double py) {
    const bool above = (px - x) * nx + (py - y) * ny > 0.0;
    return above ? Pixel{220, 200} : Pixel{40, 50};
  };
}

TEST(EdgeSmoother, StraightEdgesAreTwiceAsNearToManySamples) {
  test::Random random(20261122);
  double rough = 0.0, smooth = 0.0;
  for (int i = 0; i < 60; ++i) {
    const double angle_rad = random.in(0.0, 6.283);
    const Painting painting =
        edgeThrough(random.in(0.3, 0.7) * kWide_px, random.in(0.3, 0.7) * kHigh_px, angle_rad);
    const std::vector<int> greys = smoothed(painting);
    double roughHere = 0.0, smoothHere = 0.0;
    for (int y = 0; y < kHigh_px; ++y) {
      for (int x = 0; x < kWide_px; ++x) {
        const double reference = sampled(painting, x, y);
        roughHere += std::abs(painting(x + 0.5, y + 0.5).grey - reference);
        smoothHere += std::abs(greys[static_cast<std::size_t>(y * kWide_px + x)] - reference);
      }
    }
    // Along rows or columns there is nothing to smooth.
    EXPECT_LE(smoothHere, roughHere + 1.0) << "edge " << i << " at " << angle_rad << " rad";
    rough += roughHere;
    smooth += smoothHere;
  }
  EXPECT_GT(rough, 0.0);
  EXPECT_LT(smooth, 0.5 * rough);
  RecordProperty("smoothToRough", std::to_string(smooth / rough));
}

TEST(EdgeSmoother, WhatHasOneToneStaysAsItIs) {
  // Letters, digits, tiles: what is painted on one surface, with the hardest contrasts.
  const auto written = [](double x, double y) {
    const bool ink = (static_cast<int>(x) * 7 + static_cast<int>(y) * 3) % 5 < 2;
    return Pixel{static_cast<std::uint8_t>(ink ? 255 : 0), 128};
  };
  const std::vector<int> greys = smoothed(written);
  for (int i = 0; i < kWide_px * kHigh_px; ++i)
    ASSERT_EQ(greys[static_cast<std::size_t>(i)], written(i % kWide_px + 0.5, i / kWide_px + 0.5).grey) << i;
}

TEST(EdgeSmoother, EveryRowIsReached) {
  // A step in one place of the picture, and the same step moved: the same change, wherever it is.
  int expected = 0;
  for (int y = 4; y < kHigh_px - 4; ++y) {
    const auto greys = smoothed([&](double px, double py) {
      const bool above = py > y + (px > 0.5 * kWide_px ? 1.0 : 0.0);
      return above ? Pixel{220, 200} : Pixel{40, 50};
    });
    int changed = 0;
    for (const int grey : greys) changed += grey != 40 && grey != 220 ? 1 : 0;
    if (expected == 0) expected = changed;
    EXPECT_GT(changed, 8) << "row " << y;
    EXPECT_EQ(changed, expected) << "row " << y;
  }
}

TEST(EdgeSmoother, AnEdgeAlongABorderHasNothingBeyond) {
  // Whatever the size and wherever the edge runs, a pixel is its own or between its neighbours within the
  // picture.
  test::Random random(7);
  EdgePixels edges(EdgePixels::Tones::inAlpha);
  for (int i = 0; i < 200; ++i) {
    const glm::ivec2 size_px(static_cast<int>(random.in(1.0, 41.0)), static_cast<int>(random.in(1.0, 41.0)));
    const Painting painting =
        edgeThrough(random.in(0.0, size_px.x), random.in(0.0, size_px.y), random.in(0.0, 6.283));
    paintInto(edges.begin(size_px), painting, size_px);
    for (const std::uint32_t pixel : edges.smooth()) {
      ASSERT_EQ(pixel & 255U, pixel >> 8U & 255U) << "picture " << i;
      ASSERT_GE(pixel & 255U, 40U) << "picture " << i << ", " << size_px.x << " × " << size_px.y;
      ASSERT_LE(pixel & 255U, 220U) << "picture " << i << ", " << size_px.x << " × " << size_px.y;
    }
  }
}

TEST(EdgeSmoother, TonesOfLettersAndPicturesAreTheirLuminance) {
  EdgePixels edges(EdgePixels::Tones::luminance);
  const Painting painting = edgeThrough(50.0, 30.0, 0.2);
  paintInto(edges.begin({kWide_px, kHigh_px}),
            [&](double x, double y) {
              return Pixel{painting(x, y).grey, 255};
            },
            {kWide_px, kHigh_px});
  const std::vector<int> expected = smoothed(painting);
  const auto found = edges.smooth();
  for (std::size_t i = 0; i < expected.size(); ++i)
    ASSERT_EQ(static_cast<int>(found[i] & 255U), expected[i]) << "pixel " << i;
}

TEST(EdgeSmoother, PutsWhatWasDrawnIntoItsColumnsOnly) {
  // A wall of 40 columns, drawn into buffers that are larger and hold something else beyond it.
  constexpr glm::ivec2 kWall_px(40, 30), kBuffer_px(90, 50);
  Graphics graphics;
  graphics.makeCurrent();
  DrawTarget target(1);
  glClearColor(1.0F, 1.0F, 1.0F, 1.0F);
  target.begin(kBuffer_px);
  glClearColor(0.2F, 0.4F, 0.6F, 0.5F);
  target.begin(kWall_px);
  glClearColor(0.0F, 0.0F, 0.0F, 0.0F);  // as OpenGL begins
  RenderTarget picture({2 * kWall_px.x, kWall_px.y});
  EdgeSmoother().copy(target, picture, kWall_px.x);
  const Image image = readBack(picture);
  for (int i = 0; i < 2 * kWall_px.x * kWall_px.y; ++i) {
    const bool here = i % (2 * kWall_px.x) >= kWall_px.x;
    const auto* rgb = &image.rgb[static_cast<std::size_t>(3 * i)];
    ASSERT_EQ((std::vector<int>{rgb[0], rgb[1], rgb[2]}),
              (here ? std::vector{51, 102, 153} : std::vector{0, 0, 0}))
        << "pixel " << i;
  }
}

}  // namespace
}  // namespace carom
