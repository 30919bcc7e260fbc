// The window's picture of a curved screen, made of the pictures of flat walls: these are painted by a formula
// of the direction from the eye, and the window is compared with the same formula at the place of each pixel
// on the true surface.
#include "cave/projection/screen_picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <random>
#include <vector>

#include <glm/geometric.hpp>

#include "cave/gl/graphics.h"
#include "cave/pictures/image.h"
#include "cave/screen/true_screens.h"

namespace carom {
namespace {

using namespace test;

/// The light that comes to the eye from a direction.
using Painted = std::function<double(const glm::dvec3& along)>;

/// sRGB, IEC 61966-2-1.
std::uint8_t codeOf(double light) {
  const double code = light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1.0 / 2.4) - 0.055;
  return static_cast<std::uint8_t>(std::lround(255.0 * code));
}

double lightOf(std::uint8_t code) {
  const double c = code / 255.0;
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

/// Returns the mean of the light over a texel, from so many samples each way.
double meanLight(const Painted& painted, const glm::dvec3& corner_m, const glm::dvec3& across_m,
                 const glm::dvec3& upwards_m, const glm::dvec3& eye_m) {
  constexpr int kSamples = 4;
  double sum = 0.0;
  for (int y = 0; y < kSamples; ++y) {
    for (int x = 0; x < kSamples; ++x)
      sum += painted(corner_m + (x + 0.5) / kSamples * across_m + (y + 0.5) / kSamples * upwards_m - eye_m);
  }
  return sum / (kSamples * kSamples);
}

std::unique_ptr<RenderTarget> pictureOf(const Wall& wall, const Painted& painted, const glm::dvec3& eye_m) {
  auto picture = std::make_unique<RenderTarget>(wall.pixels);
  const glm::dvec3 across_m = (wall.lowerRight_m - wall.lowerLeft_m) / static_cast<double>(wall.pixels.x);
  const glm::dvec3 upwards_m = (wall.upperLeft_m - wall.lowerLeft_m) / static_cast<double>(wall.pixels.y);
  std::vector<std::uint8_t> rgb;
  for (int y = 0; y < wall.pixels.y; ++y) {
    for (int x = 0; x < wall.pixels.x; ++x) {
      const glm::dvec3 corner_m =
          wall.lowerLeft_m + static_cast<double>(x) * across_m + static_cast<double>(y) * upwards_m;
      rgb.insert(rgb.end(), 3, codeOf(meanLight(painted, corner_m, across_m, upwards_m, eye_m)));
    }
  }
  picture->fill(rgb);
  return picture;
}

Image windowOf(const TrueScreen& screen, const CurvedScreen& made, const Painted& painted,
               const glm::dvec3& eye_m) {
  std::vector<std::unique_ptr<RenderTarget>> pieces;
  for (const FlatPiece& piece : made.pieces) pieces.push_back(pictureOf(piece.wall, painted, eye_m));
  RenderTarget window(screen.window_px);
  ScreenPicture(made).draw(eye_m, pieces, window);
  return readBack(window);
}

double lightAt(const Image& image, int x, int y) {
  return lightOf(image.rgb[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.size_px.x) +
                                static_cast<std::size_t>(x))]);
}

/// A screen of four flat boards, folded like a fan by 90 mm, which four cells show exactly: places that are
/// finished at their corners and mixed between them would slide by pixels.
TrueScreen fan() {
  const auto place_m = [](const glm::dvec2& place) {
    const double folds = 4.0 * place.x, fold = std::abs(std::remainder(folds, 2.0));  // 0, 1, 0, 1, 0
    return glm::dvec3(4.8 * place.x - 2.4, 0.1 + 2.5 * place.y, -2.0 - 0.09 * fold);
  };
  const TrueScreen fan{
      "fan of boards", {1200, 500}, {}, {0.0, 1.7, 0.0}, 0.1, {}, [](const glm::dvec2&) {
                         return true; },
      place_m};
  return ofCells(fan, 4, 1);
}

class ScreenPictures : public testing::Test {
 protected:
  void SetUp() override { graphics_.makeCurrent(); }
  Graphics graphics_;
};

// The edge is where a plane through the eye cuts the surface: a straight edge of a thing far away. It crosses
// a row of the window between the pixels whose light is below and above one half.
TEST_F(ScreenPictures, AnEdgeIsSeenWhereTheTrueSurfaceHasIt) {
  std::mt19937_64 random(43);
  std::normal_distribution<double> any;
  const TrueScreen arc = cylinder(3.0, -60.0, 40.0, {1200, 500});
  for (const TrueScreen& screen :
       {arc, dome(5.0, 20.0, 180.0), measured(arc, 33, 33), ofCells(arc, 100, 20), fan()}) {
    const CurvedScreen made = curved(screen);
    double most_px = 0.0;
    int edges = 0;
    for (int round = 0; round < 6; ++round) {
      const glm::dvec3 eye_m = eyeNear(screen.middle_m, random);
      const glm::dvec3 normal = glm::normalize(glm::dvec3(1.5 * any(random), 0.4 * any(random), any(random)));
      const Painted halfWhite = [&](const glm::dvec3& along) {
        return glm::dot(along, normal) > 0.0 ? 1.0 : 0.0;
      };
      const Image window = windowOf(screen, made, halfWhite, eye_m);
      const auto height = [&](double x, double y) {  // of the surface's place over the plane
        return glm::dot(screen.placeOn_m(glm::dvec2(x + 0.5, y + 0.5) / glm::dvec2(screen.window_px)) - eye_m,
                        normal);
      };
      for (int y = 2; y < screen.window_px.y - 2; y += 3) {
        for (int x = 2; x + 3 < screen.window_px.x; ++x) {
          const double here = lightAt(window, x, y), next = lightAt(window, x + 1, y);
          if ((here > 0.5) == (next > 0.5)) continue;
          if (!screen.isScreen(glm::dvec2(x - 2, y) / glm::dvec2(screen.window_px)) ||
              !screen.isScreen(glm::dvec2(x + 3, y) / glm::dvec2(screen.window_px)))
            continue;
          const double at = x + (0.5 - here) / (next - here);
          const glm::dvec2 slope(height(at + 0.5, y) - height(at - 0.5, y),
                                 height(at, y + 0.5) - height(at, y - 0.5));
          const double off_px = std::abs(height(at, y)) / glm::length(slope);
          most_px = std::max(most_px, off_px);
          ++edges;
          ASSERT_LE(off_px, 0.75) << screen.name << ", round " << round << ", pixel " << x << " " << y;
        }
      }
    }
    EXPECT_GT(edges, 100) << screen.name;
    fmt::print("{}: {} places of edges, at most {:.3f} px off\n", screen.name, edges, most_px);
  }
}

/// Returns the columns of the window at which a piece ends and the next begins.
std::vector<int> seamsOf(const TrueScreen& screen, const CurvedScreen& made) {
  std::vector<int> seams;
  for (const FlatPiece& piece : made.pieces) {
    double left = 1.0;
    for (const ScreenTriangle& triangle : piece.mesh) {
      for (const ScreenPoint& point : triangle) left = std::min(left, point.inWindow.x);
    }
    if (left > 0.01) seams.push_back(static_cast<int>(std::lround(left * screen.window_px.x)));
  }
  return seams;
}

/// Returns by how many pixels the waves of a picture are shifted about a column, as measured in some columns
/// of it: `light` is 0.5 + 0.4 cos of the phase.
double shift_px(const Image& window, int from, int to, double period_px) {
  double cosine = 0.0, sine = 0.0;
  for (int y = window.size_px.y / 4; y < window.size_px.y * 3 / 4; ++y) {
    for (int x = from; x < to; ++x) {
      const double phase = 2.0 * std::numbers::pi * (x + 0.5) / period_px,
                   light = lightAt(window, x, y) - 0.5;
      cosine += light * std::cos(phase);
      sine += light * std::sin(phase);
    }
  }
  return std::atan2(sine, cosine) * period_px / (2.0 * std::numbers::pi);
}

// Waves across a cylinder, on both sides of each line at which two pieces meet, and of the line at which the
// windows of two screens meet.
TEST_F(ScreenPictures, APlaceIsTheSameThroughNeighbouringPiecesAndScreens) {
  std::mt19937_64 random(44);
  constexpr int kPeriod_px = 16;
  const TrueScreen left = cylinder(3.0, -50.0, 0.0, {800, 120}), right = cylinder(3.0, 0.0, 50.0, {800, 120});
  const CurvedScreen madeLeft = curved(left), madeRight = curved(right);
  double most_px = 0.0;
  int seams = 0;
  for (int round = 0; round < 6; ++round) {
    const glm::dvec3 eye_m = eyeNear(left.middle_m, random);
    const auto waves = [&](const TrueScreen& screen) -> Painted {
      return [&](const glm::dvec3& along) {
        const double x_px = screen.inWindow(eye_m, along).x * screen.window_px.x;
        return 0.5 + 0.4 * std::cos(2.0 * std::numbers::pi * x_px / kPeriod_px);
      };
    };
    const Image onLeft = windowOf(left, madeLeft, waves(left), eye_m),
                onRight = windowOf(right, madeRight, waves(right), eye_m);
    const auto compare = [&](const Image& before, int end, const Image& after, int begin) {
      const double apart_px = shift_px(after, begin, begin + kPeriod_px, kPeriod_px) -
                              shift_px(before, end - kPeriod_px, end, kPeriod_px);
      most_px = std::max(most_px, std::abs(apart_px));
      ++seams;
      EXPECT_LE(std::abs(apart_px), 0.1) << "round " << round << ", at " << begin;
    };
    for (const int seam : seamsOf(left, madeLeft)) compare(onLeft, seam, onLeft, seam);
    compare(onLeft, left.window_px.x, onRight, 0);
  }
  EXPECT_EQ(seams, 12);
  fmt::print("{} seams of pieces and screens: at most {:.3f} px apart\n", seams, most_px);
}

// Stripes of four pixels of the window, across a cylinder: their contrast against pixels that show them
// directly, each the mean over its own breadth.
TEST_F(ScreenPictures, FineStripesKeepTheirContrast) {
  const TrueScreen screen = cylinder(3.0, -60.0, 40.0, {1200, 120});
  const CurvedScreen made = curved(screen);
  constexpr double kPeriod_px = 4.0, kTurn = 2.0 * std::numbers::pi;
  for (const glm::dvec3& eye_m :
       {glm::dvec3(0.0, 1.7, 0.0), glm::dvec3(1.1, 1.5, 0.6), glm::dvec3(-0.3, 1.4, -1.3)}) {
    const Painted stripes = [&](const glm::dvec3& along) {
      const double x_px = screen.inWindow(eye_m, along).x * screen.window_px.x;
      return 0.5 + 0.4 * std::cos(kTurn * x_px / kPeriod_px);
    };
    const Image window = windowOf(screen, made, stripes, eye_m);
    const double direct = 0.4 * std::sin(kTurn / 2.0 / kPeriod_px) / (kTurn / 2.0 / kPeriod_px);
    double least = 10.0, most = 0.0;
    for (int from = 20; from + 40 < screen.window_px.x;
         from += 40) {  // the stripes' amplitude over ten of them
      double cosine = 0.0, sine = 0.0;
      for (int x = from; x < from + 40; ++x) {
        const double light = lightAt(window, x, screen.window_px.y / 2);
        cosine += light * std::cos(kTurn * (x + 0.5) / kPeriod_px) / 20.0;
        sine += light * std::sin(kTurn * (x + 0.5) / kPeriod_px) / 20.0;
      }
      const double contrast = std::hypot(cosine, sine) / direct;
      least = std::min(least, contrast);
      most = std::max(most, contrast);
    }
    EXPECT_GE(least, 0.95);
    EXPECT_LE(most, 1.05);
    fmt::print("contrast of stripes of four pixels: {:.3f} to {:.3f}\n", least, most);
  }
}

}  // namespace
}  // namespace carom
