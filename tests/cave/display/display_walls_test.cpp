// Pixels of the windows themselves: whose they are in each stereo mode, which wall's where walls share a
// window, and when, where a wall is held back.
#include "cave/display/display_walls.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <gtest/gtest.h>
#include <vtk_glew.h>

#include <functional>
#include <string>

#include "cave/glowing_puck.h"

namespace carom {
namespace {

constexpr double kC_m_s = 1.42;
constexpr int kSize_px = 64;

/// Who has the shining puck before them; the others stand behind the wall and see nothing.
struct Seeing {
  bool left = false, right = false, mono = false;
};

/// A window's pixels; counts from the upper left, as windows do.
struct Pixels {
  std::vector<std::uint8_t> rgba;
  const std::uint8_t* at(int x, int y) const { return &rgba[4 * ((kSize_px - 1 - y) * kSize_px + x)]; }
  bool isLit(int x, int y) const { return at(x, y)[0] > 0 || at(x, y)[1] > 0 || at(x, y)[2] > 0; }
};

/// 4 × 4 m, 1 m before the origin. The puck fills all of it.
Wall wallOf(StereoMode stereo) {
  Wall wall = test::wallTowards({0, 0, 0}, {0, 1, 0}, {kSize_px, kSize_px});
  wall.name = "wall";
  wall.window = {0, {0, 0}, {kSize_px, kSize_px}, false};
  wall.stereo = stereo;
  return wall;
}

class Shown {
 public:
  explicit Shown(std::vector<Wall> walls, const std::optional<WindowPlacement>& oneWindow = {})
      : walls_(graphics_, test::glowingPuck(5.8), kC_m_s, std::move(walls), oneWindow, true) {}

  /// Of the window that was opened last, after one more frame.
  Pixels frame(const Seeing& seeing) {
    const auto eye = [](bool sees) {
      const glm::dvec3 place(0.0, sees ? 0.0 : 3.0, 0.0);
      EyeView view;
      view.positionInRoom_m = place;
      return view;
    };
    FrameRecord record;
    record.number = number_++;
    record.lightSpeed_m_s = kC_m_s;
    record.viewers[0].observer.headFromBoard = Lorentz(kC_m_s);
    record.viewers[0].observer.left = eye(seeing.left);
    record.viewers[0].observer.right = eye(seeing.right);
    record.viewers[0].observer.middle = eye(seeing.mono);
    walls_.draw(record, world_);
    walls_.show();
    Pixels pixels{std::vector<std::uint8_t>(4 * kSize_px * kSize_px)};
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadBuffer(GL_BACK);
    glReadPixels(0, 0, kSize_px, kSize_px, GL_RGBA, GL_UNSIGNED_BYTE, pixels.rgba.data());
    return pixels;
  }

  /// What is pointed to once the mouse is there; none: windows of this display do not get it.
  std::optional<PointedWall> pointAt(const glm::dvec2& pixel) {
    GLFWwindow* const window = glfwGetCurrentContext();  // of the last that was shown
    glfwFocusWindow(window);
    std::optional<PointedWall> pointed;
    int there = 0;  // a busy display tells of places on the way, or where the mouse was
    for (int i = 0; i < 200 && there < 5; ++i) {
      glfwSetCursorPos(window, pixel.x, pixel.y);
      glfwWaitEventsTimeout(0.01);
      graphics_.poll();
      pointed = walls_.pointedAt();
      glm::dvec2 at{0.0};
      glfwGetCursorPos(window, &at.x, &at.y);
      there = pointed && at == pixel ? there + 1 : 0;
    }
    return pointed;
  }
  DisplayWalls& walls() { return walls_; }

 private:
  Graphics graphics_;
  const World world_{
      {WorldLine(Knot{}, kC_m_s), WorldLine({{0.0, {0.0, 6.0, 0.0}}, {}, 0.0, {}, 0.0}, kC_m_s)}, {}};
  DisplayWalls walls_;
  std::uint64_t number_ = 0;
};

using Belongs = std::function<bool(int x, int y)>;

void expectLit(const Pixels& pixels, const Belongs& belongs) {
  int wrong = 0;
  for (int y = 0; y < kSize_px; ++y) {
    for (int x = 0; x < kSize_px; ++x) {
      if (pixels.isLit(x, y) != belongs(x, y) && ++wrong < 4) {
        ADD_FAILURE() << "pixel " << x << ", " << y << " is " << (belongs(x, y) ? "black" : "lit");
      }
    }
  }
  EXPECT_EQ(wrong, 0);
}

const Belongs kAll = [](int, int) { return true; };
const Belongs kNone = [](int, int) { return false; };
const Belongs kLeftHalf = [](int x, int) { return x < kSize_px / 2; };
const Belongs kRightHalf = [](int x, int) { return x >= kSize_px / 2; };

TEST(DisplayWallsWindows, ALeftOnlyThingIsInTheLeftEyesPixelsOnly) {
  struct Case {
    const char* name;
    StereoMode mode;
    Belongs left, right;  // pixels
  };
  const Case cases[] = {
      {"left", StereoMode::left, kAll, kNone},
      {"right", StereoMode::right, kNone, kAll},
      {"side-by-side", StereoMode::sideBySide, kLeftHalf, kRightHalf},
      {"top-bottom", StereoMode::topBottom, [](int, int y) { return y < kSize_px / 2; },
       [](int, int y) { return y >= kSize_px / 2; }},
      {"interlaced", StereoMode::interlaced, [](int, int y) { return y % 2 == 0; },
       [](int, int y) { return y % 2 == 1; }},
      {"checkerboard", StereoMode::checkerboard, [](int x, int y) { return (x + y) % 2 == 0; },
       [](int x, int y) { return (x + y) % 2 == 1; }},
  };
  for (const Case& tested : cases) {
    SCOPED_TRACE(tested.name);
    Shown shown({wallOf(tested.mode)});
    expectLit(shown.frame({.left = true}), tested.left);
    expectLit(shown.frame({.right = true}), tested.right);
    expectLit(shown.frame({.left = true, .right = true}),
              [&](int x, int y) { return tested.left(x, y) || tested.right(x, y); });
    expectLit(shown.frame({.mono = true}), kNone);
  }
}

TEST(DisplayWallsWindows, OfAnAnaglyphTheLeftEyeHasRedAndTheRightEyeTheRest) {
  Shown shown({wallOf(StereoMode::anaglyph)});
  const Pixels left = shown.frame({.left = true}), right = shown.frame({.right = true});
  for (int y = 0; y < kSize_px; ++y) {
    for (int x = 0; x < kSize_px; ++x) {
      const std::uint8_t *l = left.at(x, y), *r = right.at(x, y);
      ASSERT_TRUE(l[0] > 0 && l[1] == 0 && l[2] == 0) << x << ", " << y;
      ASSERT_TRUE(r[0] == 0 && r[1] > 0 && r[2] > 0) << x << ", " << y;
    }
  }
}

TEST(DisplayWallsWindows, WithoutGlassesTheMiddleEyesPictureIsShown) {
  Shown shown({wallOf(StereoMode::mono)});
  expectLit(shown.frame({.mono = true}), kAll);
  expectLit(shown.frame({.left = true, .right = true}), kNone);
}

/// A projector an eye: two walls on one place, beside each other in one window of the node.
std::vector<Wall> eyesInOneWindow() {
  std::vector<Wall> walls{wallOf(StereoMode::left), wallOf(StereoMode::right)};
  walls[0].viewport = Viewport{{0, 0}, {kSize_px / 2, kSize_px}};
  walls[1].viewport = Viewport{{kSize_px / 2, 0}, {kSize_px / 2, kSize_px}};
  return walls;
}

TEST(DisplayWallsWindows, WallsShareAWindowByViewports) {
  Shown shown(eyesInOneWindow());
  expectLit(shown.frame({.left = true}), kLeftHalf);
  expectLit(shown.frame({.right = true}), kRightHalf);
  expectLit(shown.frame({.left = true, .right = true}), kAll);
}

TEST(DisplayWallsWindows, NodesThatOneRankDrawsForHaveWindowsOfTheirOwn) {
  std::vector<Wall> walls = eyesInOneWindow();
  walls[1].node = 1;
  Shown byViewports(walls);  // the last window is node 1's
  expectLit(byViewports.frame({.left = true, .right = true}), kRightHalf);
  for (Wall& wall : walls) {
    wall.window = {0, wall.viewport->position_px, wall.viewport->size_px, false};
    wall.viewport.reset();
  }
  // A rig with one window shows those of all nodes in it.
  Shown together(walls, WindowPlacement{0, {0, 0}, {kSize_px, kSize_px}, false});
  expectLit(together.frame({.left = true, .right = true}), kAll);
}

TEST(DisplayWallsWindows, AFastWallWaitsForTheSlow) {
  std::vector<Wall> walls = eyesInOneWindow();
  for (Wall& wall : walls) wall.stereo = StereoMode::mono;
  walls[0].heldFrames = 2;
  Shown shown(walls);
  const bool seen[] = {true, false, false, true, true, false, true};
  const std::size_t count = std::size(seen);
  for (std::size_t frame = 0; frame < count; ++frame) {
    SCOPED_TRACE(testing::Message() << "frame " << frame);
    const bool now = seen[frame], before = frame >= 2 && seen[frame - 2];
    expectLit(shown.frame({.mono = now}), [&](int x, int) { return x < kSize_px / 2 ? before : now; });
  }
}

TEST(DisplayWallsWindows, ThePointerIsOnTheWallAndOfTheEyeWhosePictureItIsOver) {
  Shown shown({wallOf(StereoMode::sideBySide)});
  shown.frame({.left = true, .right = true});
  const auto pointed = shown.pointAt({40.0, 16.0});  // a quarter of the way through the right eye's half
  if (!pointed) GTEST_SKIP() << "no pointer reaches the windows of this display";
  EXPECT_EQ(pointed->eye, Eye::right);
  EXPECT_NEAR(pointed->onWall_m.x, -1.0, 1e-9);  // the wall is 4 × 4 m around the origin, 1 m away
  EXPECT_NEAR(pointed->onWall_m.y, 1.0, 1e-9);
  EXPECT_NEAR(pointed->onWall_m.z, 1.0, 1e-9);
  EXPECT_FALSE(shown.walls().isHeld());
}

TEST(DisplayWallsWindows, QuadBufferIsRefusedInWordsWhereTheDisplayHasNone) {
  Graphics graphics;
  try {
    Wall wall = wallOf(StereoMode::quadBuffer);
    DisplayWalls walls(graphics, Scene{}, kC_m_s, {wall}, {}, true);
    GTEST_SKIP() << "this display offers quad-buffer stereo";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("this display offers no quad-buffer stereo"), std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace carom
