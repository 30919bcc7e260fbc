#include "cave/capture/capture.h"

#include <gtest/gtest.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>
#include <vtk_glew.h>

#include <atomic>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <thread>

#include "app/temporary_folder.h"
#include "cave/display/window.h"
#include "cave/pictures/image.h"

namespace carom {
namespace {

namespace fs = std::filesystem;

TEST(Capture, NamesAreWallEyeFrame) {
  EXPECT_EQ(capturePath("out", "front", Eye::left, 7), fs::path("out/front-left-000007.png"));
  EXPECT_EQ(capturePath("out", "floor", Eye::middle, 1234567), fs::path("out/floor-mono-1234567.png"));
}

TEST(Capture, AWrittenPngReadsBackTheSame) {
  const test::TemporaryFolder folder;
  const fs::path path = folder / "front-right-000000.png";
  Image image{{3, 2}, {}};
  for (int i = 0; i < 18; ++i) image.rgb.push_back(static_cast<std::uint8_t>(i * 14));
  writePng(image, path);
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  const auto* pixels = static_cast<const std::uint8_t*>(reader->GetOutput()->GetScalarPointer());
  for (std::size_t i = 0; i < 18; ++i) EXPECT_EQ(pixels[i], image.rgb[i]) << i;
  EXPECT_EQ(folder.entries(), 1) << "nothing else is left behind";
}

TEST(Capture, SeveralMayWriteTheSameFile) {
  const test::TemporaryFolder folder;
  const fs::path path = folder / "front-left-000000.png", expected = folder / "expected.png";
  const Image image{{200, 100}, std::vector<std::uint8_t>(60000, 77)};
  writePng(image, expected);
  std::atomic<int> failures = 0;
  {
    std::vector<std::jthread> writers;
    for (int writer = 0; writer < 8; ++writer) {
      writers.emplace_back([&] {
        for (int i = 0; i < 20; ++i) {
          try {
            writePng(image, path);
          } catch (const std::runtime_error&) {
            ++failures;
          }
        }
      });
    }
  }
  EXPECT_EQ(failures, 0);
  std::ifstream written(path, std::ios::binary), whole(expected, std::ios::binary);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(written), {}),
            std::string(std::istreambuf_iterator<char>(whole), {}));
  EXPECT_EQ(folder.entries(), 2) << "nothing else is left behind";
}

TEST(Capture, AFolderThatIsNotThereIsNamed) {
  try {
    writePng({{1, 1}, {0, 0, 0}}, "/nowhere/at/all.png");
    FAIL() << "no error";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("/nowhere/at/all.png"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("No such file"), std::string::npos) << error.what();
  }
}

TEST(Capture, ReadsAPictureBack) {
  Graphics graphics;
  const RenderTarget picture({5, 3});
  const Image image = readBack(picture);
  EXPECT_EQ(image.size_px, glm::ivec2(5, 3));
  EXPECT_EQ(image.rgb, std::vector<std::uint8_t>(45, 0));
}

/// Pictures of a frame, each of one colour of its own.
void paint(RenderTarget& picture, std::uint64_t frame, int eye) {
  std::vector<std::uint8_t> rgb(3 * static_cast<std::size_t>(picture.size_px().x * picture.size_px().y));
  for (std::size_t i = 0; i < rgb.size(); ++i) rgb[i] = static_cast<std::uint8_t>(37 * frame + 91U * eye + i);
  picture.fill(rgb);
}

std::string bytesOf(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(Capture, AViewThatIsResizedKeepsNoBuffersOfItsOldSizes) {
  Graphics graphics;
  const auto buffers = [] {
    int there = 0;
    for (GLuint name = 1; name < 2000; ++name) there += glIsBuffer(name) == GL_TRUE;
    return there;
  };
  const RenderTarget wall({20, 10});
  const int before = buffers();
  PictureReader reader;
  for (int width = 1; width <= 50; ++width) {
    RenderTarget window({width, 10});
    paint(window, static_cast<std::uint64_t>(width), 0);
    reader.ask(wall, 0);
    reader.ask(window, 1);
    std::vector<std::vector<std::uint8_t>> fetched;
    reader.fetch(0, [&](const glm::ivec2&, std::span<const std::uint8_t> rgba) {
      fetched.emplace_back(rgba.begin(), rgba.end());
    });
    ASSERT_EQ(fetched.size(), 2U);
    EXPECT_EQ(fetched[0].size(), 4U * 20 * 10);
    const Image expected = readBack(window);
    ASSERT_EQ(fetched[1].size(), expected.rgb.size() / 3 * 4) << width;
    for (std::size_t i = 0; i < expected.rgb.size(); ++i)
      ASSERT_EQ(fetched[1][i / 3 * 4 + i % 3], expected.rgb[i]) << width;
  }
  EXPECT_EQ(buffers(), before + 2);
}

TEST(Capture, WhatIsCapturedOnTheWayIsWhatWasDrawnThen) {
  const test::TemporaryFolder folder;
  Graphics graphics;
  RenderTarget left({61, 33}), right({40, 40});
  const std::string wall = "front";
  Capture capture(folder / "", WhenFull::wait);
  constexpr std::uint64_t kFrames = 60;  // more than the queue holds
  for (std::uint64_t frame = 0; frame < kFrames; ++frame) {
    paint(left, frame, 0);
    paint(right, frame, 1);
    const std::vector<Capture::Taken> taken{{&left, &wall, Eye::left}, {&right, &wall, Eye::right}};
    capture.take(frame, taken);
  }
  capture.finish();
  EXPECT_EQ(capture.dropped(), 0U);
  EXPECT_EQ(folder.entries(), 2 * static_cast<std::ptrdiff_t>(kFrames));
  const fs::path expected = folder / "expected";
  for (std::uint64_t frame = 0; frame < kFrames; ++frame) {
    paint(left, frame, 0);
    paint(right, frame, 1);
    writePng(readBack(left), expected);
    EXPECT_EQ(bytesOf(capturePath(folder / "", wall, Eye::left, frame)), bytesOf(expected)) << frame;
    writePng(readBack(right), expected);
    EXPECT_EQ(bytesOf(capturePath(folder / "", wall, Eye::right, frame)), bytesOf(expected)) << frame;
  }
}

TEST(Capture, InRealTimeWhatComesTooFastIsLeftOutByFramesAndCounted) {
  const test::TemporaryFolder folder;
  Graphics graphics;
  RenderTarget large({1500, 1500});
  const std::string wall = "front", outside = "outside";
  Capture capture(folder / "", WhenFull::drop);
  constexpr std::uint64_t kFrames = 60;
  for (std::uint64_t frame = 0; frame < kFrames; ++frame) {  // each takes milliseconds to encode
    const std::vector<Capture::Taken> taken{{&large, &wall, Eye::left}, {&large, &wall, Eye::right}};
    capture.include({&large, &outside, Eye::middle});
    capture.take(frame, taken);
  }
  capture.finish();
  EXPECT_GT(capture.dropped(), 0U);
  std::uint64_t whole = 0;
  for (std::uint64_t frame = 0; frame < kFrames; ++frame) {
    const bool there = fs::exists(capturePath(folder / "", wall, Eye::left, frame));
    EXPECT_EQ(there, fs::exists(capturePath(folder / "", wall, Eye::right, frame)))
        << "half of frame " << frame;
    EXPECT_EQ(there, fs::exists(capturePath(folder / "", outside, Eye::middle, frame)))
        << "half of frame " << frame;
    whole += there;
  }
  EXPECT_EQ(whole, kFrames - capture.dropped());
  EXPECT_GT(whole, 0U);
}

TEST(Capture, WhatCannotBeWrittenIsSaid) {
  Graphics graphics;
  RenderTarget picture({8, 8});
  const std::string wall = "front";
  Capture capture("/nowhere/at/all", WhenFull::wait);
  const auto takeAll = [&] {
    const std::vector<Capture::Taken> taken{{&picture, &wall, Eye::middle}};
    for (std::uint64_t frame = 0; frame < 100; ++frame) capture.take(frame, taken);
    capture.finish();
  };
  try {
    takeAll();
    FAIL() << "no error";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("/nowhere/at/all/front-mono-000000.png"), std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace carom
