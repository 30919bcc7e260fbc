#include "cave/capture.h"

#include <gtest/gtest.h>
#include <unistd.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>

#include <fstream>
#include <stdexcept>

#include "cave/window.h"

namespace carom {
namespace {

namespace fs = std::filesystem;

/// A folder of its own, gone with the test.
struct Folder {
  fs::path path = fs::temp_directory_path() / ("carom_capture_test_" + std::to_string(getpid()));
  Folder() { fs::create_directories(path); }
  ~Folder() { fs::remove_all(path); }
};

TEST(Capture, NamesAreWallEyeFrame) {
  EXPECT_EQ(capturePath("out", "front", Eye::left, 7), fs::path("out/front-left-000007.png"));
  EXPECT_EQ(capturePath("out", "floor", Eye::mono, 1234567), fs::path("out/floor-mono-1234567.png"));
}

TEST(Capture, AWrittenPngReadsBackTheSame) {
  const Folder folder;
  const fs::path path = folder.path / "front-right-000000.png";
  Image image{{3, 2}, {}};
  for (int i = 0; i < 18; ++i) image.rgb.push_back(static_cast<std::uint8_t>(i * 14));
  writePng(image, path);
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  const auto* pixels = static_cast<const std::uint8_t*>(reader->GetOutput()->GetScalarPointer());
  for (std::size_t i = 0; i < 18; ++i) EXPECT_EQ(pixels[i], image.rgb[i]) << i;
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path), {}), 1) << "nothing else is left behind";
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
  const WallPicture picture({5, 3});
  const Image image = readBack(picture);
  EXPECT_EQ(image.size_px, glm::ivec2(5, 3));
  EXPECT_EQ(image.rgb, std::vector<std::uint8_t>(45, 0));
}

}  // namespace
}  // namespace carom
