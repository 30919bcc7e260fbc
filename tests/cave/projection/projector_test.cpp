// What leaves a projector, by pixels: pictures with a colour of its own in every pixel are warped, blended,
// lifted, mirrored and packed.
#include "cave/projection/projector.h"

#include <gtest/gtest.h>
#include <vtkImageData.h>
#include <vtkImageWriter.h>
#include <vtkJPEGWriter.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkTIFFWriter.h>
#include <vtk_glew.h>

#include <array>
#include <cmath>
#include <fstream>
#include <functional>
#include <memory>
#include <random>
#include <stdexcept>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "app/temporary_folder.h"
#include "cave/display/window.h"
#include "cave/mesh_files/measured_bytes.h"
#include "cave/pictures/image.h"
#include "cave/projection/stereo.h"
#include "cave/room/wall_eyes.h"

namespace carom {
namespace {

using Rgb = std::array<int, 3>;
constexpr int kSize_px = 64;
constexpr Rgb kBlack{0, 0, 0};

/// sRGB, IEC 61966-2-1, worked out here on its own: the light of an 8-bit code.
double lightOf(int code) {
  const double c = code / 255.0;
  return c < 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

/// Rows from the bottom up.
using Pixels = std::vector<Rgb>;

class ProjectorPixels : public testing::Test {
 protected:
  void SetUp() override {
    graphics_.makeCurrent();
    left_ = std::make_unique<RenderTarget>(glm::ivec2(kSize_px));
    right_ = std::make_unique<RenderTarget>(glm::ivec2(kSize_px));
    window_ = std::make_unique<RenderTarget>(glm::ivec2(kSize_px));
    std::mt19937 random(11);
    for (Pixels* pixels : {&leftPixels_, &rightPixels_}) {
      for (int i = 0; i < kSize_px * kSize_px; ++i) {
        const auto value = [&] { return static_cast<int>(random() % 255); };
        pixels->push_back({value(), value(), value()});
      }
    }
    paint(*left_, leftPixels_);
    paint(*right_, rightPixels_);
  }

  void TearDown() override {
    graphics_.makeCurrent();
    left_.reset();
    right_.reset();
    window_.reset();
  }

  static void paint(const RenderTarget& picture, const Pixels& pixels) {
    std::vector<std::uint8_t> bytes;
    for (const Rgb& c : pixels) {
      bytes.insert(bytes.end(), {std::uint8_t(c[0]), std::uint8_t(c[1]), std::uint8_t(c[2]), 255});
    }
    glBindTexture(GL_TEXTURE_2D, picture.texture());
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, kSize_px, kSize_px, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
  }

  /// The window with one pane over all of it; rows from the bottom up.
  Pixels packed(const Projection* projection, StereoMode mode = StereoMode::mono) {
    StereoPacker packer(window_->framebuffer());
    glBindFramebuffer(GL_FRAMEBUFFER, window_->framebuffer());
    glClearColor(0, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    const bool both = eyesOf(mode).size() > 1;
    const glm::ivec2 size(kSize_px);
    packer.draw({left_.get(), both ? right_.get() : nullptr, mode, {0, 0}, size, projection}, size);
    const Image image = readBack(*window_);
    Pixels pixels;
    for (std::size_t i = 0; i < image.rgb.size(); i += 3) {
      pixels.push_back({image.rgb[i], image.rgb[i + 1], image.rgb[i + 2]});
    }
    return pixels;
  }

  static const Rgb& at(const Pixels& pixels, int column, int row) {
    return pixels[static_cast<std::size_t>(row * kSize_px + column)];
  }
  static void expectSame(const Pixels& pixels, const std::function<Rgb(int, int)>& expected) {
    for (int row = 0; row < kSize_px; ++row) {
      for (int column = 0; column < kSize_px; ++column) {
        ASSERT_EQ(at(pixels, column, row), expected(column, row)) << "column " << column << ", row " << row;
      }
    }
  }
  Rgb leftOr(int column, int row, const Rgb& otherwise) const {
    const bool inside = column >= 0 && row >= 0 && column < kSize_px && row < kSize_px;
    return inside ? at(leftPixels_, column, row) : otherwise;
  }

  Graphics graphics_;
  Pixels leftPixels_, rightPixels_;
  std::unique_ptr<RenderTarget> left_, right_, window_;
};

const std::vector<StereoMode> kModes{StereoMode::mono,     StereoMode::left,       StereoMode::right,
                                     StereoMode::anaglyph, StereoMode::interlaced, StereoMode::checkerboard};

Projection straight() { return {.warp = straightWarp(), .blend = {}, .blackLevel = 0.0, .flip = Flip::none}; }

/// The picture moved in the window, in picture widths and heights.
Projection moved(const glm::vec2& left, const glm::vec2& right) {
  Projection projection = straight();
  for (WarpPoint& point : projection.warp.left.points) point.inWindow += left;
  for (WarpPoint& point : projection.warp.right.points) point.inWindow += right;
  return projection;
}

TEST_F(ProjectorPixels, AStraightMeshChangesNoPixelInAnyMode) {
  const Projection projection = straight();
  for (const StereoMode mode : kModes) {
    EXPECT_EQ(packed(&projection, mode), packed(nullptr, mode)) << static_cast<int>(mode);
  }
  // Squeezed into halves, a picture is sampled twice and rounded to 8 bits in between: one step at most.
  for (const StereoMode mode : {StereoMode::sideBySide, StereoMode::topBottom}) {
    const Pixels with = packed(&projection, mode), without = packed(nullptr, mode);
    for (std::size_t i = 0; i < with.size(); ++i) {
      for (std::size_t part = 0; part < 3; ++part) {
        ASSERT_NEAR(with[i][part], without[i][part], 1)
            << "mode " << static_cast<int>(mode) << ", pixel " << i;
      }
    }
  }
}

TEST_F(ProjectorPixels, AMovedMeshMovesThePictureByWholePixels) {
  const Projection projection = moved(glm::vec2(5.0F, -7.0F) / float(kSize_px), {});
  expectSame(packed(&projection), [&](int column, int row) { return leftOr(column - 5, row + 7, kBlack); });
}

TEST_F(ProjectorPixels, EyesHaveMeshesOfTheirOwnAndKeepTheirWindowPixels) {
  const Projection projection = moved({3.0F / kSize_px, 0.0F}, {-4.0F / kSize_px, 0.0F});
  const auto right = [&](int column, int row) {
    return column + 4 < kSize_px ? at(rightPixels_, column + 4, row) : kBlack;
  };
  const auto left = [&](int column, int row) { return leftOr(column - 3, row, kBlack); };
  expectSame(packed(&projection, StereoMode::interlaced), [&](int column, int row) {
    const int fromTop = kSize_px - 1 - row;
    return fromTop % 2 == 0 ? left(column, row) : right(column, row);
  });
  expectSame(packed(&projection, StereoMode::checkerboard), [&](int column, int row) {
    const int fromTop = kSize_px - 1 - row;
    return (fromTop + column) % 2 == 0 ? left(column, row) : right(column, row);
  });
  // A right-eye wall's one picture goes by the right eye's mesh.
  expectSame(packed(&projection, StereoMode::right), [&](int column, int row) {
    return column + 4 < kSize_px ? at(leftPixels_, column + 4, row) : kBlack;
  });
}

TEST_F(ProjectorPixels, SideBySideWarpsEachHalfWithinItself) {
  Pixels flat(kSize_px * kSize_px, {200, 40, 10});
  paint(*left_, flat);
  flat.assign(flat.size(), {10, 90, 220});
  paint(*right_, flat);
  const Projection projection = moved({0.25F, 0.0F}, {-0.25F, 0.0F});
  expectSame(packed(&projection, StereoMode::sideBySide), [](int column, int) -> Rgb {
    if (column < 8) return kBlack;
    if (column < 32) return {200, 40, 10};
    return column < 56 ? Rgb{10, 90, 220} : kBlack;
  });
}

/// The projective map that takes the unit square's corners to these (Heckbert, Fundamentals of Texture
/// Mapping, 1989, section 2.2.3), from (0,0), (1,0), (1,1), (0,1).
glm::dmat3 homographyTo(const std::array<glm::dvec2, 4>& corners) {
  const auto& [p0, p1, p2, p3] = corners;
  const glm::dvec2 d1 = p1 - p2, d2 = p3 - p2, s = p0 - p1 + p2 - p3;
  const double det = d1.x * d2.y - d2.x * d1.y;
  const double g = (s.x * d2.y - d2.x * s.y) / det, h = (d1.x * s.y - s.x * d1.y) / det;
  return {glm::dvec3(p1 - p0 + g * p1, g), glm::dvec3(p3 - p0 + h * p3, h), glm::dvec3(p0, 1.0)};
}

TEST_F(ProjectorPixels, AKeystoneIsTheHomographyItSamples) {
  const glm::dmat3 windowFromPicture = homographyTo({{{0.05, 0.02}, {0.97, 0.0}, {0.8, 0.95}, {0.2, 1.0}}});
  const auto mapped = [](const glm::dmat3& map, const glm::dvec2& place) {
    const glm::dvec3 h = map * glm::dvec3(place, 1.0);
    return glm::dvec2(h) / h.z;
  };
  constexpr int kCells = 32;
  WarpMesh mesh;
  for (int j = 0; j <= kCells; ++j) {
    for (int i = 0; i <= kCells; ++i) {
      const glm::dvec2 place(double(i) / kCells, double(j) / kCells);
      mesh.points.push_back({glm::vec2(mapped(windowFromPicture, place)), glm::vec2(place)});
    }
  }
  for (unsigned j = 0; j < kCells; ++j) {
    for (unsigned i = 0; i < kCells; ++i) {
      const unsigned corner = j * (kCells + 1) + i, above = corner + kCells + 1;
      mesh.triangles.push_back({corner, corner + 1, above});
      mesh.triangles.push_back({above, corner + 1, above + 1});
    }
  }
  // Each pixel says where it is: red is its column, green its row, four steps a pixel.
  Pixels places;
  for (int row = 0; row < kSize_px; ++row) {
    for (int column = 0; column < kSize_px; ++column) places.push_back({4 * column, 4 * row, 255});
  }
  paint(*left_, places);
  Projection projection = straight();
  projection.warp = {mesh, mesh};
  const Pixels seen = packed(&projection);
  int compared = 0;
  for (int row = 0; row < kSize_px; ++row) {
    for (int column = 0; column < kSize_px; ++column) {
      const glm::dvec2 inWindow((column + 0.5) / kSize_px, (row + 0.5) / kSize_px);
      const glm::dvec2 place_px = mapped(glm::inverse(windowFromPicture), inWindow) * double(kSize_px);
      const bool inside = glm::all(glm::greaterThan(place_px, glm::dvec2(0.5))) &&
                          glm::all(glm::lessThan(place_px, glm::dvec2(kSize_px - 0.5)));
      const bool outside = glm::any(glm::lessThan(place_px, glm::dvec2(-0.5))) ||
                           glm::any(glm::greaterThan(place_px, glm::dvec2(kSize_px + 0.5)));
      const Rgb& colour = at(seen, column, row);
      if (outside) {
        EXPECT_EQ(colour, kBlack) << column << ", " << row;
      }
      if (!inside) continue;
      ++compared;
      // A quarter of a picture pixel: rounding to 8 bits is an eighth, the mesh's flat triangles the rest.
      EXPECT_NEAR(colour[0] / 4.0 + 0.5, place_px.x, 0.25) << column << ", " << row;
      EXPECT_NEAR(colour[1] / 4.0 + 0.5, place_px.y, 0.25) << column << ", " << row;
    }
  }
  EXPECT_GT(compared, kSize_px * kSize_px / 2);
}

// A pixel of the window shows what the homography of the screen's corners has there, to an eighth of a
// picture's pixel, which is the rounding of its colour to 8 bits, and as much for the interpolation between
// its pixels.
TEST_F(ProjectorPixels, ASkewedScreenIsSeenThroughItsHomography) {
  SkewedScreen screen;
  screen.inPicture = {{{0.06, 0.1}, {1.0, 0.0}, {0.0, 0.9}, {0.9, 1.0}}};
  const glm::dmat3 pictureFromWindow =
      homographyTo({{screen.inPicture[0], screen.inPicture[1], screen.inPicture[3], screen.inPicture[2]}});
  Pixels places;
  for (int row = 0; row < kSize_px; ++row) {
    for (int column = 0; column < kSize_px; ++column) places.push_back({4 * column, 4 * row, 255});
  }
  paint(*left_, places);
  Projection projection = straight();
  projection.warp = skewWarp(screen);
  projection.blend = {{kSize_px, 1}, {}};  // which stays in the window
  for (int i = 0; i < 3 * kSize_px; ++i) projection.blend.rgb.push_back(i / 3 < 60 ? 65535 : 0);
  const Pixels seen = packed(&projection);
  int compared = 0;
  for (int row = 0; row < kSize_px; ++row) {
    for (int column = 0; column < kSize_px; ++column) {
      const glm::dvec3 h =
          pictureFromWindow * glm::dvec3((column + 0.5) / kSize_px, (row + 0.5) / kSize_px, 1.0);
      const glm::dvec2 place_px = glm::dvec2(h) / h.z * double(kSize_px);
      const Rgb& colour = at(seen, column, row);
      if (column >= 60) {
        ASSERT_EQ(colour, kBlack) << column << ", " << row;
        continue;
      }
      if (glm::any(glm::lessThan(place_px, glm::dvec2(0.5))) ||
          glm::any(glm::greaterThan(place_px, glm::dvec2(kSize_px - 0.5))))
        continue;
      ++compared;
      ASSERT_NEAR(colour[0] / 4.0 + 0.5, place_px.x, 0.25) << column << ", " << row;
      ASSERT_NEAR(colour[1] / 4.0 + 0.5, place_px.y, 0.25) << column << ", " << row;
    }
  }
  EXPECT_GT(compared, kSize_px * kSize_px * 9 / 10);
}

TEST_F(ProjectorPixels, GainIsTheLightOfWhiteAndGammaItsCode) {
  Projection projection = straight();
  projection.blackLevel = 0.02;
  projection.gain = {1.0, 0.8, 0.5};
  projection.gamma = glm::dvec3(1.8, 2.2, 2.6);
  const Pixels seen = packed(&projection);
  for (int column = 0; column < kSize_px; ++column) {
    for (int part = 0; part < 3; ++part) {
      const auto colour = static_cast<std::size_t>(part);
      const double light =
          0.02 + (projection.gain[part] - 0.02) * lightOf(at(leftPixels_, column, 31)[colour]);
      const double code = 255.0 * std::pow(light, 1.0 / (*projection.gamma)[part]);
      EXPECT_NEAR(at(seen, column, 31)[colour], code, 0.6) << column << ", part " << part;
    }
  }
  // Beside the picture is black, in the projector's code, and all of its light counts.
  for (WarpPoint& point : projection.warp.left.points) point.inWindow.x *= 0.5F;
  const Rgb dark = at(packed(&projection), kSize_px - 1, 5);
  for (int part = 0; part < 3; ++part) {
    EXPECT_NEAR(dark[static_cast<std::size_t>(part)], 255.0 * std::pow(0.02, 1.0 / (*projection.gamma)[part]),
                0.6);
  }
}

TEST_F(ProjectorPixels, EachColourHasItsMesh) {
  Projection projection = straight();
  projection.colourWarps = {straightWarp(), straightWarp(), straightWarp()};
  const std::array<glm::ivec2, 3> moved_px{{{0, 0}, {3, -2}, {-5, 1}}};
  for (std::size_t part = 0; part < 3; ++part) {
    for (WarpPoint& point : (*projection.colourWarps)[part].left.points) {
      point.inWindow += glm::vec2(moved_px[part]) / float(kSize_px);
    }
  }
  expectSame(packed(&projection), [&](int column, int row) {
    Rgb expected{};
    for (std::size_t part = 0; part < 3; ++part) {
      expected[part] = leftOr(column - moved_px[part].x, row - moved_px[part].y, kBlack)[part];
    }
    return expected;
  });
  // What is drawn afterwards has all colours again.
  const Projection plain = straight();
  EXPECT_EQ(packed(&plain), packed(nullptr));
}

TEST_F(ProjectorPixels, BlendRampsOfTwoTilesAddUpToOneLight) {
  const Pixels flat(kSize_px * kSize_px, {255, 180, 90});
  paint(*left_, flat);
  Projection rising = straight(), falling = straight();
  for (BlendPicture* blend : {&rising.blend, &falling.blend}) *blend = {{kSize_px, 1}, {}};
  for (int column = 0; column < kSize_px; ++column) {
    const auto share = static_cast<std::uint16_t>(65535 * column / (kSize_px - 1));
    for (int part = 0; part < 3; ++part) {
      rising.blend.rgb.push_back(share);
      falling.blend.rgb.push_back(static_cast<std::uint16_t>(65535 - share));
    }
  }
  const Pixels up = packed(&rising), down = packed(&falling);
  for (int column = 0; column < kSize_px; ++column) {
    for (std::size_t part = 0; part < 3; ++part) {
      const double sum = lightOf(at(up, column, 9)[part]) + lightOf(at(down, column, 9)[part]);
      // Half a step of the 8-bit code in each tile: at most 1/255 × slope 2.3 / 2 of the brightest.
      EXPECT_NEAR(sum, lightOf(flat[0][part]), 0.0091) << "column " << column << ", part " << part;
    }
    const double share = double(column) / (kSize_px - 1);
    EXPECT_NEAR(lightOf(at(up, column, 9)[0]), share, 0.0046) << "column " << column;
  }
}

TEST_F(ProjectorPixels, TheBlendStaysInTheWindowWhereThePictureMoves) {
  Projection projection = moved(glm::vec2(16.0F, 0.0F) / float(kSize_px), {});
  projection.blend = {{kSize_px, 1}, {}};
  for (int i = 0; i < 3 * kSize_px; ++i) projection.blend.rgb.push_back(i / 3 < 32 ? 65535 : 0);
  expectSame(packed(&projection),
             [&](int column, int row) { return column < 32 ? leftOr(column - 16, row, kBlack) : kBlack; });
}

TEST_F(ProjectorPixels, BesideThePictureAndBesideTheMeshIsTheBlackLevel) {
  Projection projection = straight();
  projection.blackLevel = 0.05;
  for (WarpPoint& point : projection.warp.left.points) {
    point.inWindow.x *= 0.5F;   // the mesh ends in column 32,
    point.inPicture.x *= 2.0F;  // the picture in column 16
  }
  const Pixels seen = packed(&projection);
  const Rgb black{63, 63, 63};  // 1.055 × 0.05^(1/2.4) - 0.055 = 0.2478 of 255
  for (int row = 0; row < kSize_px; ++row) {
    for (int column = 16; column < kSize_px; ++column) ASSERT_EQ(at(seen, column, row), black) << column;
    int lit = 0;
    for (int column = 0; column < 16; ++column) lit += at(seen, column, row) != black;
    ASSERT_GT(lit, 8);
  }
}

TEST_F(ProjectorPixels, BlackBlendAndPictureGoTogetherAsSaid) {
  Projection projection = straight();
  projection.blackLevel = 0.05;
  projection.blend = {{1, 1}, {16384, 32768, 65535}};
  const Pixels seen = packed(&projection);
  for (int column = 0; column < kSize_px; ++column) {
    for (std::size_t part = 0; part < 3; ++part) {
      const double share = std::array{0.25, 0.5, 1.0}[part];
      const double expected = 0.05 + 0.95 * share * lightOf(at(leftPixels_, column, 20)[part]);
      EXPECT_NEAR(lightOf(at(seen, column, 20)[part]), expected, 0.0046) << column << ", part " << part;
    }
  }
}

// A mesh for a spherical mirror has a share of light at each point.
TEST_F(ProjectorPixels, TheMeshDimsThePictureAndNotTheBlack) {
  Projection projection = straight();
  projection.blackLevel = 0.05;
  for (WarpPoint& point : projection.warp.left.points) point.light = 1.0F - point.inWindow.x;
  const Pixels seen = packed(&projection);
  for (int column = 0; column < kSize_px; ++column) {
    const double share = 1.0 - (column + 0.5) / kSize_px;
    for (std::size_t part = 0; part < 3; ++part) {
      const double expected = 0.05 + 0.95 * share * lightOf(at(leftPixels_, column, 20)[part]);
      EXPECT_NEAR(lightOf(at(seen, column, 20)[part]), expected, 0.0046) << column << ", part " << part;
    }
  }
}

TEST_F(ProjectorPixels, FlipMirrorsTheWindowWithMeshAndBlend) {
  Projection projection = moved(glm::vec2(5.0F, 0.0F) / float(kSize_px), {});
  projection.blend = {{2, 1}, {65535, 65535, 65535, 0, 0, 0}};  // fades from the left to the right
  const Pixels upright = packed(&projection);
  for (const Flip flip : {Flip::horizontal, Flip::vertical, Flip::both}) {
    projection.flip = flip;
    expectSame(packed(&projection), [&](int column, int row) {
      const bool across = flip != Flip::vertical, up = flip != Flip::horizontal;
      return at(upright, across ? kSize_px - 1 - column : column, up ? kSize_px - 1 - row : row);
    });
  }
}

TEST(Blend, HasTheRowsFromTheBottomUp) {
  const test::TemporaryFolder folder;
  const auto path = folder / "ramp.png";
  writePng({{2, 2}, {0, 1, 2, 255, 254, 253, 10, 20, 30, 40, 50, 60}}, path);
  const BlendPicture blend = readBlend(path);
  EXPECT_EQ(blend.size_px, glm::ivec2(2, 2));
  EXPECT_EQ(blend.rgb, (std::vector<std::uint16_t>{0, 257, 514, 65535, 254 * 257, 253 * 257, 2570, 5140, 7710,
                                                   10280, 12850, 15420}));
}

/// A deep grey picture in the file's format: 300 × 200, from black on the left to the brightest.
void writeRamp(vtkImageWriter& writer, const std::filesystem::path& path, int type) {
  vtkNew<vtkImageData> picture;
  picture->SetDimensions(300, 200, 1);
  picture->AllocateScalars(type, 1);
  const double most = type == VTK_UNSIGNED_SHORT ? 65535.0 : 255.0;
  for (int row = 0; row < 200; ++row) {
    for (int column = 0; column < 300; ++column) {
      picture->SetScalarComponentFromDouble(column, row, 0, 0, std::floor(most * column / 299.0));
    }
  }
  writer.SetInputData(picture);
  writer.SetFileName(path.c_str());
  writer.Write();
}

TEST(Blend, ReadsEveryKindAndNamesBrokenOnes) {
  const test::TemporaryFolder folder;
  writeRamp(*vtkNew<vtkPNGWriter>(), folder / "ramp.png", VTK_UNSIGNED_SHORT);
  writeRamp(*vtkNew<vtkTIFFWriter>(), folder / "ramp.tif", VTK_UNSIGNED_SHORT);
  writeRamp(*vtkNew<vtkJPEGWriter>(), folder / "ramp.jpg", VTK_UNSIGNED_CHAR);
  for (const std::string ending : {".png", ".tif", ".jpg"}) {
    const auto path = folder / ("ramp" + ending);
    const BlendPicture blend = readBlend(path);
    ASSERT_EQ(blend.size_px, glm::ivec2(300, 200));
    ASSERT_EQ(blend.rgb.size(), 3U * 300U * 200U);
    const double loss = ending == ".jpg" ? 0.02 * 65535.0 : 1.0;
    for (std::size_t i = 0; i < blend.rgb.size(); ++i) {
      ASSERT_NEAR(blend.rgb[i], 65535.0 * double(i / 3 % 300) / 299.0, loss) << ending << ", number " << i;
    }
    std::ifstream whole(path, std::ios::binary);
    const std::string bytes(std::istreambuf_iterator<char>(whole), {});
    for (const std::string& content :
         {std::string(), std::string("no picture"), bytes.substr(0, 20), bytes.substr(0, bytes.size() / 2)}) {
      const auto broken = folder.file("broken" + ending, content);
      try {
        readBlend(broken);
        ADD_FAILURE() << "read " << content.size() << " of " << bytes.size() << " bytes of a " << ending;
      } catch (const std::runtime_error& error) {
        EXPECT_TRUE(std::string(error.what()).starts_with(broken.string() + ":1:1: ")) << error.what();
      }
    }
  }
}

TEST(Blend, IsThatOfAVwfFile) {
  const test::TemporaryFolder folder;
  std::string shares;
  for (int i = 0; i < 2 * 2 * 4; ++i) test::put(shares, i < 8 ? 0.25F : 1.0F);  // the upper row first
  const auto place = [](const glm::dvec2& at) { return glm::dvec3(at, -2.0); };
  const BlendPicture blend = readBlend(folder.file("a.vwf", test::vwfBytes(2, 2, place, 1e3, 0x200, shares)));
  EXPECT_EQ(blend.size_px, glm::ivec2(2, 2));
  EXPECT_EQ(blend.rgb.at(0), 65535);
  EXPECT_EQ(blend.rgb.at(6), 16384);
  EXPECT_THROW(readBlend(folder.file("b.vwf", test::vwfBytes(2, 2, place))), std::runtime_error);
}

TEST(Projection, IsNoneForAPlainWall) {
  Wall wall;
  EXPECT_FALSE(projectionOf(wall));
  Wall mirrored = wall, dimmed = wall, bright = wall, skewed = wall;
  mirrored.flip = Flip::vertical;
  dimmed.gain.y = 0.9;
  bright.gamma = glm::dvec3(2.2);
  skewed.skewed = SkewedScreen{.inPicture = {{{0.1, 0}, {1, 0}, {0, 1}, {0.9, 1}}}};
  for (const Wall& one : {mirrored, dimmed, bright, skewed}) EXPECT_TRUE(projectionOf(one));
}

}  // namespace
}  // namespace carom
