// The digits of cushion clocks and of plates as they are drawn, segment by segment, at every age of a game.
#include <gtest/gtest.h>
#include <vtk_glew.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <glm/mat4x4.hpp>
#include <string>

#include "cave/gl/gl_state_guard.h"
#include "cave/gl/image.h"
#include "cave/glowing_puck.h"
#include "cave/render/mark_buffer.h"
#include "cave/render/wall_renderer.h"
#include "cave/room/off_axis.h"
#include "cave/scene/table_model.h"
#include "engine/random_world.h"

namespace carom {
namespace {

constexpr double kDay_s = 86400.0;
constexpr double kPlace = 1.1, kPoint = 0.35 * kPlace;  // widths, where a digit is 0.6 wide and 1.2 high

/// A time and what clocks show of it, by whole numbers: `tenths` of a second that have gone by, and a part of
/// the next.
struct Shown {
  long tenths = 0;
  double part = 0.5;
  double time_s() const { return (static_cast<double>(tenths) + part) / 10.0; }
  std::string text() const {
    const long size = std::labs(tenths);
    return (tenths < 0 ? "-" : "") + std::to_string(size / 10) + "." + std::to_string(size % 10);
  }
};

/// Around every length of the number, a day before and after the start, and between.
std::vector<Shown> times() {
  std::vector<Shown> times;
  for (const long tenths :
       {0L,      9L,       50L,      99L, 100L, 999L, 9999L, 10000L, 20050L, 99999L, 863999L, 864000L,
        999999L, 1000000L, 9999999L, -1L, -9L,  -10L, -122L, -999L,  -1000L, -2643L, -9999L,  -864000L})
    times.push_back({tenths});
  test::Random random(81);
  for (int i = 0; i < 40; ++i) {
    const double size_s = std::exp(random.in(0.0, std::log(1.2 * kDay_s)));
    times.push_back({std::lround((i % 2 == 0 ? 10.0 : -10.0) * size_s), random.in(0.1, 0.9)});
  }
  return times;
}

/// What a row of so many places says, the last behind a point, where `lit` tells whether something shines so
/// far right of its left border and above its middle.
std::string reading(int places, const std::function<bool(double, double)>& lit) {
  // Top, upper right, lower right, bottom, lower left, upper left, middle of a digit.
  constexpr std::array<std::array<double, 2>, 7> kSegments{
      {{0.0, 0.6}, {0.3, 0.3}, {0.3, -0.3}, {0.0, -0.6}, {-0.3, -0.3}, {-0.3, 0.3}, {0.0, 0.0}}};
  constexpr std::array<const char*, 12> kDigits{"1111110", "0110000", "1101101", "1111001",
                                                "0110011", "1011011", "1011111", "1110000",
                                                "1111111", "1111011", "0000001", "0000000"};
  std::string text;
  for (int place = 0; place < places; ++place) {
    const bool last = place == places - 1;
    if (last) text += lit(place * kPlace + 0.5 * kPoint, -0.56) ? "." : "?";
    const double middle = (place + 0.5) * kPlace + (last ? kPoint : 0.0);
    std::string segments;
    for (const auto& [x, y] : kSegments) segments += lit(middle + x + 0.08 * y, y) ? '1' : '0';
    const auto digit = std::find(kDigits.begin(), kDigits.end(), segments);
    text += digit == kDigits.end() ? '?' : "0123456789- "[digit - kDigits.begin()];
  }
  return text;
}

int placesOf(const std::string& text) { return static_cast<int>(text.size()) - 1; }

bool isLit(const Image& image, double x, double y) {
  const auto column = static_cast<std::size_t>(std::floor(x)), row = static_cast<std::size_t>(std::floor(y));
  return image.rgb.at(3 * (row * static_cast<std::size_t>(image.size_px.x) + column)) > 120;
}

class ClockDigits : public testing::Test {
 protected:
  Graphics graphics_;
};

// A clock 4 m wide, its face 1.8 m before the eye: its light left it 1.8 m/c before it is seen.
TEST_F(ClockDigits, CushionClocksTellTheTimeAtWhichTheirLightLeftAtAnyAge) {
  constexpr double kWidth_m = 4.0, kFace_m = 2.0 - 0.05 * kWidth_m, kUnit_m = 0.9 * kWidth_m / 5.0;
  Scene scene;
  scene.bodyCount = 1;
  ClockMaker clocks;
  clocks.add({0.0, 2.0, -0.23 * kWidth_m}, {0.0, -1.0, 0.0}, kWidth_m, 0.1);
  scene.parts = clocks.parts();
  const Wall wall = test::wallTowards({0, 0, 0}, {0, 1, 0}, {800, 800});
  for (const double c_m_s : {0.05, 1.42, 300.0}) {
    graphics_.makeCurrent();
    WallRenderer renderer(graphics_, scene, c_m_s, 1);
    RenderTarget picture(wall.pixels);
    for (const Shown& shown : times()) {
      const EyeView eye{{shown.time_s() + kFace_m / c_m_s, Vec3(0.0)}, Vec3(0.0)};
      BodyView view;
      viewBody(restingWorldLine(c_m_s), eye.observation, Lorentz(c_m_s), view);
      renderer.look(Lorentz(c_m_s), eye, {&view, 1});
      renderer.draw(wall, {0, 0, 0}, picture);
      const Image image = readBack(picture);
      const int places = placesOf(shown.text());
      const double across = places * kPlace + kPoint, scale = std::min(1.0, 4.8 / across);
      const double left = 2.5 - 0.1 - across * scale;
      const auto lit = [&](double x, double y) {
        const double pixels = kUnit_m / kFace_m * wall.pixels.x / 4.0;
        return isLit(image, 0.5 * wall.pixels.x + (left + x * scale) * pixels,
                     0.5 * wall.pixels.y + y * scale * pixels);
      };
      ASSERT_EQ(reading(places, lit), shown.text()) << shown.time_s() << " s, light at " << c_m_s << " m/s";
      for (double x = -2.45; x < left - 0.1; x += 0.05)  // nothing stands before it
        for (double y = -0.6; y < 0.7; y += 0.1)
          ASSERT_FALSE(lit((x - left) / scale, y / scale)) << shown.text();
    }
  }
}

TEST_F(ClockDigits, PlatesSayTheSame) {
  const glm::ivec2 pixels(700, 100);
  graphics_.makeCurrent();
  RenderTarget picture(pixels);
  MarkDrawer drawer;
  for (const Shown& shown : times()) {
    const PlateText text = tenthsOf(shown.time_s());
    ASSERT_EQ(text.places, placesOf(shown.text()));
    const double across = placesAcross(text, PlateShape::box), margin = 0.12 * kPlace;
    MarkBuffer batch;
    batch.addPlate(std::array{glm::dvec3(-1, -1, 0), glm::dvec3(1, -1, 0)},
                   std::array{glm::dvec3(-1, 1, 0), glm::dvec3(1, 1, 0)}, text, PlateShape::box,
                   glm::vec4(1.0F));
    graphics_.makeCurrent();
    {
      const GlStateGuard state(picture.framebuffer(), pixels);
      drawer.upload(batch);
      drawer.draw(glm::mat4(1.0F));
    }
    const Image image = readBack(picture);
    const auto lit = [&](double x, double y) {
      return isLit(image, (x + margin) / (across * kPlace) * pixels.x, (y / 1.8 + 0.5) * pixels.y);
    };
    ASSERT_EQ(reading(text.places, lit), shown.text()) << shown.time_s() << " s";
  }
}

}  // namespace
}  // namespace carom
