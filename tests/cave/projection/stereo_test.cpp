// Stereo packing by pixels: a red left and a cyan right picture, with a mark that tells up from down.
#include "cave/projection/stereo.h"
#include "cave/room/wall_eyes.h"

#include <gtest/gtest.h>
#include <vtk_glew.h>

#include <array>
#include <functional>
#include <memory>

#include "cave/display/window.h"
#include "cave/pictures/image.h"

namespace carom {
namespace {

using Rgb = std::array<int, 3>;
constexpr int kSide_px = 64;
constexpr Rgb kLeft{200, 40, 10};
constexpr Rgb kRight{10, 90, 220};
constexpr Rgb kTop{255, 255, 255};  // the upper eighth of both

class Stereo : public testing::Test {
 protected:
  void SetUp() override {
    graphics_.makeCurrent();
    left_ = std::make_unique<RenderTarget>(glm::ivec2(kSide_px));
    right_ = std::make_unique<RenderTarget>(glm::ivec2(kSide_px));
    window_ = std::make_unique<RenderTarget>(glm::ivec2(kSide_px));
    paint(*left_, kLeft);
    paint(*right_, kRight);
  }

  void TearDown() override {
    graphics_.makeCurrent();
    left_.reset();
    right_.reset();
    window_.reset();
  }

  static void paint(const RenderTarget& picture, const Rgb& colour) {
    std::vector<std::uint8_t> pixels;
    for (int row = 0; row < kSide_px; ++row) {
      const Rgb& c = row >= kSide_px * 7 / 8 ? kTop : colour;
      for (int i = 0; i < kSide_px; ++i)
        pixels.insert(pixels.end(), {std::uint8_t(c[0]), std::uint8_t(c[1]), std::uint8_t(c[2]), 255});
    }
    glBindTexture(GL_TEXTURE_2D, picture.texture());
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, kSide_px, kSide_px, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  }

  /// What the packed pane holds; at(x, y) counts from the upper left, as windows do.
  std::function<Rgb(int, int)> packed(StereoMode mode, glm::ivec2 position = {0, 0},
                                      glm::ivec2 size = {kSide_px, kSide_px}) {
    StereoPacker packer;
    glBindFramebuffer(GL_FRAMEBUFFER, window_->framebuffer());
    glClearColor(0, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    packer.draw({left_.get(), right_.get(), mode, position, size}, {kSide_px, kSide_px});
    const Image image = readBack(*window_);
    return [image](int x, int y) {
      const std::size_t at =
          3 * (static_cast<std::size_t>(kSide_px - 1 - y) * kSide_px + static_cast<std::size_t>(x));
      return Rgb{image.rgb[at], image.rgb[at + 1], image.rgb[at + 2]};
    };
  }

  Graphics graphics_;
  std::unique_ptr<RenderTarget> left_, right_, window_;
};

TEST_F(Stereo, MonoLeftAndRightShowTheOnePictureTheyHave) {
  for (const StereoMode mode : {StereoMode::mono, StereoMode::left, StereoMode::right}) {
    const auto at = packed(mode);
    EXPECT_EQ(at(5, 2), kTop);
    EXPECT_EQ(at(5, 30), kLeft);
    EXPECT_EQ(at(60, 60), kLeft);
  }
}

TEST_F(Stereo, SideBySideHasTheLeftEyeOnTheLeft) {
  const auto at = packed(StereoMode::sideBySide);
  EXPECT_EQ(at(31, 30), kLeft);
  EXPECT_EQ(at(32, 30), kRight);
  EXPECT_EQ(at(10, 2), kTop);
  EXPECT_EQ(at(50, 2), kTop);
}

TEST_F(Stereo, TopBottomHasTheLeftEyeOnTop) {
  const auto at = packed(StereoMode::topBottom);
  EXPECT_EQ(at(30, 1), kTop);
  EXPECT_EQ(at(30, 28), kLeft);
  EXPECT_EQ(at(30, 33), kTop);
  EXPECT_EQ(at(30, 62), kRight);
}

TEST_F(Stereo, AnaglyphTakesRedFromTheLeftEyeAndTheRestFromTheRight) {
  const Rgb colour = packed(StereoMode::anaglyph)(30, 30);
  EXPECT_NEAR(colour[0], 0.2126 * kLeft[0] + 0.7152 * kLeft[1] + 0.0722 * kLeft[2], 1.0);
  EXPECT_EQ(colour[1], kRight[1]);
  EXPECT_EQ(colour[2], kRight[2]);
}

TEST_F(Stereo, GreyAnaglyphKeepsBothEyesBrightness) {
  const Rgb colour = packed(StereoMode::anaglyphGrey)(30, 30);
  const auto brightness = [](const Rgb& c) { return 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2]; };
  EXPECT_NEAR(colour[0], brightness(kLeft), 1.0);
  EXPECT_NEAR(colour[1], brightness(kRight), 1.0);
  EXPECT_NEAR(colour[2], brightness(kRight), 1.0);
}

TEST_F(Stereo, InterlacedAlternatesRowsOfTheWindow) {
  const auto at = packed(StereoMode::interlaced, {8, 9}, {40, 40});
  for (int y = 20; y < 40; ++y) EXPECT_EQ(at(20, y), y % 2 == 0 ? kLeft : kRight) << "row " << y;
}

TEST_F(Stereo, CheckerboardAlternatesPixelsOfTheWindow) {
  const auto at = packed(StereoMode::checkerboard, {3, 4}, {50, 50});
  for (int y = 20; y < 30; ++y) {
    for (int x = 10; x < 20; ++x) EXPECT_EQ(at(x, y), (x + y) % 2 == 0 ? kLeft : kRight) << x << ", " << y;
  }
}

TEST_F(Stereo, APaneKeepsToItsPlaceInTheWindow) {
  const auto at = packed(StereoMode::mono, {16, 8}, {32, 24});
  const Rgb black{0, 0, 0};
  EXPECT_EQ(at(15, 20), black);
  EXPECT_EQ(at(48, 20), black);
  EXPECT_EQ(at(20, 7), black);
  EXPECT_EQ(at(20, 32), black);
  EXPECT_EQ(at(16, 8), kTop);
  EXPECT_EQ(at(47, 31), kLeft);
}

TEST(StereoModes, KnowTheEyesTheyNeed) {
  EXPECT_EQ(eyesOf(StereoMode::mono), std::vector{Eye::middle});
  EXPECT_EQ(eyesOf(StereoMode::left), std::vector{Eye::left});
  EXPECT_EQ(eyesOf(StereoMode::right), std::vector{Eye::right});
  EXPECT_EQ(eyesOf(StereoMode::quadBuffer), (std::vector{Eye::left, Eye::right}));
}

}  // namespace
}  // namespace carom
