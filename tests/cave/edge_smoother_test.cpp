// Edges smoothed in the finished picture (cave/render/edge_smoother.h) against the same picture with 16 × 16
// samples a pixel.
#include "cave/render/edge_smoother.h"

#include <gtest/gtest.h>
#include <vtk_glew.h>

#include <cmath>
#include <functional>
#include <memory>
#include <vector>

#include "cave/gl/graphics.h"
#include "cave/gl/image.h"
#include "engine/random_world.h"

namespace carom {
namespace {

constexpr int kWide_px = 101, kHigh_px = 67;  // no whole number of tiles

struct Pixel {
  std::uint8_t grey = 0;
  std::uint8_t tone = 0;
};
using Painting = std::function<Pixel(double x, double y)>;  // in pixels from the lower left

std::vector<std::uint8_t> pixelsOf(const Painting& painting, const glm::ivec2& size_px) {
  std::vector<std::uint8_t> rgba;
  for (int y = 0; y < size_px.y; ++y) {
    for (int x = 0; x < size_px.x; ++x) {
      const Pixel pixel = painting(x + 0.5, y + 0.5);
      rgba.insert(rgba.end(), {pixel.grey, pixel.grey, pixel.grey, pixel.tone});
    }
  }
  return rgba;
}

/// Returns the grey of a pixel with many samples.
double sampled(const Painting& painting, int x, int y) {
  constexpr int kSamples = 16;
  double sum = 0.0;
  for (int i = 0; i < kSamples * kSamples; ++i)
    sum += painting(x + (i % kSamples + 0.5) / kSamples, y + (i / kSamples + 0.5) / kSamples).grey;
  return sum / (kSamples * kSamples);
}

class EdgeSmootherTest : public testing::Test {
 protected:
  void SetUp() override { graphics_.makeCurrent(); }

  /// Returns a picture of these pixels.
  static std::unique_ptr<RenderTarget> pictureOf(const std::vector<std::uint8_t>& rgba,
                                                 const glm::ivec2& size_px) {
    auto picture = std::make_unique<RenderTarget>(size_px);
    glBindTexture(GL_TEXTURE_2D, picture->texture());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, size_px.x, size_px.y, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
    glBindTexture(GL_TEXTURE_2D, 0);
    return picture;
  }

  /// Returns the greys of a painting, smoothed: rows from the bottom up.
  static std::vector<int> smoothed(const Painting& painting,
                                   const glm::ivec2& size_px = {kWide_px, kHigh_px}) {
    const auto rgba = pixelsOf(painting, size_px);
    const auto drawn = pictureOf(rgba, size_px), picture = pictureOf(rgba, size_px);
    glViewport(0, 0, size_px.x, size_px.y);
    EdgeSmoother().smooth(drawn->texture(), size_px, *picture, 0);
    return greysOf(*picture);
  }

  static std::vector<int> greysOf(const RenderTarget& picture) {
    const Image image = readBack(picture);
    std::vector<int> greys;
    for (std::size_t i = 0; i < image.rgb.size(); i += 3) greys.push_back(image.rgb[i]);
    return greys;
  }

  Graphics graphics_;
};

/// Grey 40 below a straight edge through (x, y) with this slope, 220 above it; tones as different.
Painting edgeThrough(double x, double y, double angle_rad) {
  const double nx = -std::sin(angle_rad), ny = std::cos(angle_rad);
  return [=](double px, double py) {
    const bool above = (px - x) * nx + (py - y) * ny > 0.0;
    return above ? Pixel{220, 200} : Pixel{40, 50};
  };
}

TEST_F(EdgeSmootherTest, StraightEdgesAreTwiceAsNearToManySamples) {
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

TEST_F(EdgeSmootherTest, WhatHasOneToneStaysAsItIs) {
  // Letters, digits, tiles: what is painted on one surface, with the hardest contrasts.
  const auto written = [](double x, double y) {
    const bool ink = (static_cast<int>(x) * 7 + static_cast<int>(y) * 3) % 5 < 2;
    return Pixel{static_cast<std::uint8_t>(ink ? 255 : 0), 128};
  };
  const auto rgba = pixelsOf(written, {kWide_px, kHigh_px});
  const std::vector<int> greys = smoothed(written);
  for (std::size_t i = 0; i < greys.size(); ++i) ASSERT_EQ(greys[i], rgba[4 * i]) << "pixel " << i;
}

TEST_F(EdgeSmootherTest, EveryTileIsReached) {
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

TEST_F(EdgeSmootherTest, NothingComesFromBeyondAWallsBorder) {
  // Two walls beside each other in one picture, drawn into a texture that holds something else beyond them.
  static constexpr glm::ivec2 kWall_px(40, 30), kBuffer_px(90, 50);
  test::Random random(7);
  for (int i = 0; i < 20; ++i) {
    const Painting edge = edgeThrough(random.in(30.0, 50.0), random.in(0.0, 40.0), random.in(0.0, 6.283));
    const auto within = [&edge](Pixel beyond) -> Painting {
      return [edge, beyond](double x, double y) {
        return x < kWall_px.x && y < kWall_px.y ? edge(x, y) : beyond;
      };
    };
    std::vector<int> expected;
    for (const Pixel beyond : {Pixel{40, 50}, Pixel{255, 255}, Pixel{0, 0}}) {
      const auto drawn = pictureOf(pixelsOf(within(beyond), kBuffer_px), kBuffer_px);
      const auto picture = pictureOf(
          pixelsOf([&](double x, double y) { return edge(x - kWall_px.x, y); }, {2 * kWall_px.x, kWall_px.y}),
          {2 * kWall_px.x, kWall_px.y});
      const std::vector<int> before = greysOf(*picture);
      glViewport(0, 0, kWall_px.x, kWall_px.y);
      EdgeSmoother().smooth(drawn->texture(), kWall_px, *picture, kWall_px.x);
      const std::vector<int> greys = greysOf(*picture);
      for (std::size_t at = 0; at < greys.size(); ++at) {
        if (static_cast<int>(at) % (2 * kWall_px.x) >= kWall_px.x) continue;
        ASSERT_EQ(greys[at], before[at]) << "the other wall, pixel " << at;
      }
      if (expected.empty()) expected = greys;
      ASSERT_EQ(greys, expected) << "edge " << i << ", beyond the wall " << int(beyond.grey);
    }
  }
}

TEST_F(EdgeSmootherTest, APictureSmallerThanATileStays) {
  const auto painting = edgeThrough(3.0, 3.0, 0.3);
  const auto rgba = pixelsOf(painting, {7, 40});
  const std::vector<int> greys = smoothed(painting, {7, 40});
  for (std::size_t i = 0; i < greys.size(); ++i) EXPECT_EQ(greys[i], rgba[4 * i]) << "pixel " << i;
}

}  // namespace
}  // namespace carom
