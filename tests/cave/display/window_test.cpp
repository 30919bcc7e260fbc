#include "cave/display/window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <X11/Xutil.h>
#include <X11/extensions/scrnsaver.h>
#include <gtest/gtest.h>
#include <vtk_glew.h>

#include <array>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <string>
#include <thread>

#include "cave/capture/capture.h"
#include "cave/display/wall_window.h"

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
  EXPECT_NE(unset.find("expected a screen to which this user is logged in"), std::string::npos) << unset;
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

/// What another program sees of the display.
class Onlooker {
 public:
  /// A white desk, and a screen saver after a second.
  Onlooker() {
    XSetWindowBackground(display_, root_, ~0UL);
    XClearWindow(display_, root_);
    XSetScreenSaver(display_, 1, 1, PreferBlanking, AllowExposures);
    XSync(display_, False);
  }
  ~Onlooker() {
    XSetWindowBackground(display_, root_, 0);
    XSetScreenSaver(display_, 0, 0, PreferBlanking, AllowExposures);
    XCloseDisplay(display_);
  }
  Onlooker(const Onlooker&) = delete;
  Onlooker& operator=(const Onlooker&) = delete;

  unsigned long colourAt(int x, int y) {
    XImage* const image = XGetImage(display_, root_, x, y, 1, 1, AllPlanes, ZPixmap);
    const unsigned long colour = XGetPixel(image, 0, 0) & 0xffffffUL;
    XDestroyImage(image);
    return colour;
  }
  /// Whether the screen saver is on once nobody has touched anything for three times its second.
  bool isSavedAfterAWhile() {
    XScreenSaverInfo info{};
    XResetScreenSaver(display_);
    do {
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
      XScreenSaverQueryInfo(display_, root_, &info);
    } while (info.idle < 3000);
    return info.state == ScreenSaverOn;
  }

 private:
  Display* display_ = XOpenDisplay(nullptr);
  ::Window root_ = DefaultRootWindow(display_);
};

TEST(Window, OfAWallIsBlackFromTheStartWithoutACursor) {
  Graphics graphics;
  Onlooker onlooker;
  const Window window(graphics, "wall", {0, {10, 20}, {64, 32}, false});
  EXPECT_EQ(window.misplaced(), "");
  EXPECT_EQ(onlooker.colourAt(10, 20), 0u);
  EXPECT_EQ(onlooker.colourAt(73, 51), 0u);
  EXPECT_EQ(onlooker.colourAt(9, 20), 0xffffffu) << "beside it";
  EXPECT_EQ(onlooker.colourAt(74, 51), 0xffffffu) << "beside it";
  EXPECT_EQ(glfwGetInputMode(glfwGetCurrentContext(), GLFW_CURSOR), GLFW_CURSOR_HIDDEN);
  graphics.makeCurrent();
}

TEST(Window, ThatIsMovedSaysWhereItIs) {
  Graphics graphics;
  const Window window(graphics, "wall", {0, {10, 20}, {64, 32}, false});
  glfwSetWindowPos(glfwGetCurrentContext(), 10, 47);
  EXPECT_EQ(window.misplaced(), "64 × 32 pixels from (10, 47), expected 64 × 32 pixels from (10, 20)");
  graphics.makeCurrent();
}

TEST(Window, TheScreenSaverWaitsUntilTheProgramEnds) {
  Onlooker onlooker;
  {
    Graphics graphics;
    keepDisplayAwake();
    EXPECT_FALSE(onlooker.isSavedAfterAWhile());
  }
  EXPECT_TRUE(onlooker.isSavedAfterAWhile());
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
