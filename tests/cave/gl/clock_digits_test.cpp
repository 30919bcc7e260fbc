// The digits of cushion clocks and of plates as they are drawn, segment by segment, at every age of a game.
#include <gtest/gtest.h>
#include <vtk_glew.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <glm/mat4x4.hpp>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cave/gl/gl_state_guard.h"
#include "cave/gl/letter_atlas.h"
#include "cave/glowing_puck.h"
#include "cave/marks/mark_buffer.h"
#include "cave/pictures/image.h"
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

/// Which letter of ASCII is drawn in a place of a plate: the one whose ink is most alike, point by point.
char letterAt(const Image& image, int place, double placeWidth_px, double margin_px) {
  constexpr int kColumns = 12, kRows = 60;  // a line below is as thin as a twentieth
  const LetterAtlas& atlas = letterAtlas();
  double best = -1.0;
  char letter = '?';
  for (char candidate = ' '; candidate <= 'z'; ++candidate) {
    const std::string text(1, candidate);
    std::string_view rest = text;
    const int cell = takeLetter(rest);
    double apart = 0.0;
    for (int row = 0; row < kRows; ++row) {
      for (int column = 0; column < kColumns; ++column) {
        const double u = (column + 0.5) / kColumns, v = (row + 0.5) / kRows;
        const auto x = static_cast<std::size_t>((cell % kLetterColumns + u) * kLetterCell_px.x);
        const auto y = static_cast<std::size_t>((cell / kLetterColumns + v) * kLetterCell_px.y);
        const double ink = atlas.ink[y * static_cast<std::size_t>(atlas.size_px.x) + x] / 255.0;
        const bool lit = isLit(image, margin_px + (place + u) * placeWidth_px, v * image.size_px.y);
        apart += std::abs(ink - (lit ? 1.0 : 0.0));
      }
    }
    const double alike = 1.0 / (1.0 + apart);
    if (alike > best) letter = candidate;
    best = std::max(best, alike);
  }
  return letter;
}

TEST_F(ClockDigits, PlatesSayTheSame) {
  const glm::ivec2 pixels(700, 100);
  graphics_.makeCurrent();
  RenderTarget picture(pixels);
  MarkDrawer drawer;
  std::vector<std::pair<PlateText, std::string>> plates{{plateText("looks 0.39 c"), "looks 0.39 c"},
                                                        {plateText("Qgjy@ABC"), "Qgjy@ABC"}};
  for (const Shown& shown : times()) plates.emplace_back(tenthsOf(shown.time_s()), shown.text());
  for (const auto& [text, words] : plates) {
    ASSERT_EQ(text.places, static_cast<int>(words.size()));
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
    const double width_px = pixels.x / placesAcross(text, PlateShape::box);
    std::string said;
    for (int place = 0; place < text.places; ++place)
      said += letterAt(image, place, width_px, 0.12 * width_px);
    ASSERT_EQ(said, words);
  }
}

// The picture of letters stands upright: an L has its bar below, a T above, a sign of a degree is high up,
// and each letter keeps within its cell.
TEST(LetterAtlas, StandsUpright) {
  const LetterAtlas& atlas = letterAtlas();
  const auto inkOf = [&](std::string_view letter, double from, double to) {
    const int cell = takeLetter(letter);
    double sum = 0.0;
    for (int y = static_cast<int>(from * kLetterCell_px.y); y < static_cast<int>(to * kLetterCell_px.y);
         ++y) {
      for (int x = 0; x < kLetterCell_px.x; ++x) {
        const int column = cell % kLetterColumns * kLetterCell_px.x + x,
                  row = cell / kLetterColumns * kLetterCell_px.y + y;
        sum += atlas.ink[static_cast<std::size_t>(row * atlas.size_px.x + column)];
      }
    }
    return sum;
  };
  EXPECT_GT(inkOf("L", 0.0, 0.4), 1.3 * inkOf("L", 0.6, 1.0));
  EXPECT_GT(inkOf("T", 0.6, 1.0), 1.3 * inkOf("T", 0.0, 0.4));
  EXPECT_EQ(inkOf("°", 0.0, 0.45), 0.0);
  EXPECT_GT(inkOf("°", 0.45, 1.0), 0.0);
  EXPECT_EQ(inkOf(" ", 0.0, 1.0), 0.0);
  EXPECT_EQ(inkOf("白", 0.0, 1.0), inkOf("?", 0.0, 1.0));
}

// Letters of a language come behind those that there always are, which stay as they are, to the byte.
TEST(LetterAtlas, HoldsTheLettersOfALanguage) {
  const LetterAtlas before = letterAtlas();
  const auto codeOf = [](std::string_view letter) { return int{takeLetter(letter)}; };
  const int plain = codeOf("a"), question = codeOf("?");
  EXPECT_EQ(codeOf("ö"), question);
  setPlateLetters(U"öé白ö速a°");
  const LetterAtlas& atlas = letterAtlas();
  EXPECT_EQ(atlas.rows, kLetterRows) << "the row that was begun holds them";
  EXPECT_EQ(codeOf("a"), plain);
  std::set<int> codes{question};
  for (const char* letter : {"ö", "é", "白", "速"}) {
    const int code = codeOf(letter);
    EXPECT_TRUE(codes.insert(code).second) << letter;
    EXPECT_GE(code, 105) << letter;
    const int left = code % kLetterColumns * kLetterCell_px.x,
              foot = code / kLetterColumns * kLetterCell_px.y;
    int inked = 0;
    for (int y = foot; y < foot + kLetterCell_px.y; ++y) {
      for (int x = left; x < left + kLetterCell_px.x; ++x)
        inked += atlas.ink[static_cast<std::size_t>(y * atlas.size_px.x + x)] > 128 ? 1 : 0;
    }
    EXPECT_GT(inked, 400) << letter;
  }
  const std::size_t always = static_cast<std::size_t>(6 * kLetterCell_px.y * atlas.size_px.x);
  EXPECT_TRUE(std::equal(before.ink.begin(), before.ink.begin() + static_cast<std::ptrdiff_t>(always),
                         atlas.ink.begin()));
  std::u32string many;
  for (char32_t letter = U'一'; letter < U'一' + 400; ++letter) many.push_back(letter);
  setPlateLetters(many);
  EXPECT_EQ(letterAtlas().rows, kMostLetterRows);
  EXPECT_EQ(codeOf("一"), 105);
  EXPECT_EQ(codeOf("\u4F8F"), question) << "beyond the picture";
  setPlateLetters({});
  EXPECT_EQ(letterAtlas().ink, before.ink);
  EXPECT_EQ(codeOf("一"), question);
}

}  // namespace
}  // namespace carom
