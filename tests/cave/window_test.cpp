#include "cave/display/window.h"

#include <gtest/gtest.h>
#include <vtk_glew.h>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <string>

#include "cave/capture/capture.h"

namespace carom {
namespace {

std::string failureOf(const std::function<void()>& action) {
  try {
    action();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return {};
}

TEST(Window, WithoutADisplayTheErrorSaysHowToGetOne) {
  const std::string before = std::getenv("DISPLAY") ? std::getenv("DISPLAY") : "";
  unsetenv("DISPLAY");
  const std::string unset = failureOf([] { Graphics graphics; });
  const std::string wrong = failureOf([] { Graphics graphics(":4711"); });
  setenv("DISPLAY", before.c_str(), 1);
  EXPECT_NE(unset.find("no X display"), std::string::npos) << unset;
  EXPECT_NE(unset.find("xvfb-run"), std::string::npos) << unset;
  EXPECT_NE(wrong.find(":4711"), std::string::npos) << wrong;
}

TEST(Window, ShowsPicturesOfTheDrawingContext) {
  Graphics graphics;
  const RenderTarget picture({32, 32});
  glBindFramebuffer(GL_FRAMEBUFFER, picture.framebuffer());
  glClearColor(1.0F, 0.5F, 0.0F, 1.0F);
  glClear(GL_COLOR_BUFFER_BIT);
  Window window(graphics, "test", {0, {10, 10}, {64, 32}, false});
  EXPECT_EQ(window.size_px(), glm::ivec2(64, 32));
  graphics.finishDrawing();
  const Pane pane{&picture, nullptr, StereoMode::mono, {32, 0}, {32, 32}};
  window.show({&pane, 1});
  std::array<std::uint8_t, 8> pixels{};
  glReadPixels(31, 16, 2, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  EXPECT_EQ(pixels[0], 0) << "beside the pane";
  EXPECT_EQ(pixels[4], 255);
  EXPECT_NEAR(pixels[5], 128, 1);
  window.swap();
  EXPECT_FALSE(graphics.poll().closeRequested);
  EXPECT_TRUE(graphics.poll().keys.empty());
  EXPECT_FALSE(window.isDown('W'));
  graphics.makeCurrent();
}

TEST(Window, AMonitorThatIsNotThereIsNamed) {
  Graphics graphics;
  const std::string message = failureOf([&] { Window(graphics, "test", {7, {0, 0}, {64, 64}, false}); });
  EXPECT_NE(message.find("no monitor 7"), std::string::npos) << message;
}

// A virtual display has no shutter glasses; on a display that has them this window opens.
TEST(Window, QuadBufferStereoIsRefusedWhereTheDisplayHasNone) {
  Graphics graphics;
  try {
    const Window window(graphics, "front", {0, {0, 0}, {64, 64}, false}, true);
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("\"front\": this display offers no quad-buffer stereo"),
              std::string::npos)
        << error.what();
  }
}

TEST(Window, APictureOfNoSizeIsRefused) {
  Graphics graphics;
  EXPECT_THROW(RenderTarget({0, 32}), std::runtime_error);
  EXPECT_THROW(RenderTarget({1 << 24, 32}), std::runtime_error);
}

}  // namespace
}  // namespace carom
