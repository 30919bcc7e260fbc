#include "cave/overlay/latency_overlay.h"

#include <gtest/gtest.h>
#include <vtk_glew.h>

#include <array>
#include <cstdlib>
#include <limits>

#include "cave/cluster/frame_lock.h"
#include "cave/display/window.h"
#include "cave/pictures/image.h"

namespace carom {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

LatencyView someView() {
  LatencyView view;
  view.node = "node 0 (front)";
  view.frame = 4711;
  FrameHistory history(300);
  for (std::uint64_t frame = 0; frame < 300; ++frame) {
    const auto jitter_s = static_cast<float>(frame * 7 % 13) * 1e-4F;
    history.add({frame,
                 {0.004F + jitter_s, 0.0006F, 0.0001F, 0.0021F, 0.0043F + jitter_s, 0.0082F, 0.0004F,
                  frame == 0 ? kNaN : jitter_s - 0.0006F}});
  }
  for (std::size_t part = 0; part < kFrameParts.size(); ++part)
    view.parts[part] = history.statistics(static_cast<FramePart>(part), 300);
  view.nodes = {{"node 0 (front)", view.parts.back(), LockState::joined},
                {"node 1 (left)", view.parts.back(), LockState::lost}};
  view.lock = LockState::joined;
  return view;
}

Image shownIn(const Window& window) {
  Image image{window.size_px(), {}};
  image.rgb.resize(3 * static_cast<std::size_t>(image.size_px.x * image.size_px.y));
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, image.size_px.x, image.size_px.y, GL_RGB, GL_UNSIGNED_BYTE, image.rgb.data());
  return image;
}

TEST(LatencyOverlay, IsOverTheWindowAndNotInThePictures) {
  Graphics graphics;
  const RenderTarget picture({960, 600});
  Window window(graphics, "test", {0, {0, 0}, {960, 600}, false});
  const Pane pane{&picture, nullptr, StereoMode::mono, {0, 0}, {960, 600}};
  const LatencyView view = someView();
  const std::array<WallTime, 2> walls{{{"front", 0.0031F, 254'300}, {"floor", 0.0008F, 9'920}}};
  Image with;
  for (int frame = 0; frame < 2; ++frame) {  // a window of Dear ImGui finds its size with its first frame
    graphics.finishDrawing();
    window.show({&pane, 1}, [&] { drawLatency(view, walls); });
    window.awaitShown();
    with = shownIn(window);
    window.swap();
  }
  if (const char* file = std::getenv("CAROM_OVERLAY_PICTURE")) writePng(with, file);
  window.show({&pane, 1});
  const Image without = shownIn(window);
  graphics.makeCurrent();
  const Image drawn = readBack(picture);
  std::size_t bright = 0, changed = 0;
  for (std::size_t i = 0; i < with.rgb.size(); ++i) {
    bright += with.rgb[i] > 150;
    changed += with.rgb[i] != without.rgb[i];
  }
  EXPECT_GT(changed, 100'000U) << "the panel";
  EXPECT_GT(bright, 10'000U) << "its letters";
  EXPECT_EQ(without.rgb, std::vector<std::uint8_t>(without.rgb.size(), 0));
  EXPECT_EQ(drawn.rgb, std::vector<std::uint8_t>(drawn.rgb.size(), 0));
  const std::size_t corner = 3 * (960 * 3 + 950);  // lower right
  EXPECT_EQ(with.rgb[corner], 0) << "it leaves the rest as it is";
}

// A virtual display's driver is Mesa's; on a workstation with sync cards the lock is pending.
TEST(LatencyOverlay, ADriverWithoutSwapGroupsSaysSo) {
  Graphics graphics;
  Window window(graphics, "test", {0, {0, 0}, {64, 64}, false});
  EXPECT_NE(window.drawable(), 0U);
  const NodeLock lock(swapGroupOfDriver(), {window.drawable()});
  if (graphics.rendererName().find("llvmpipe") == std::string::npos) GTEST_SKIP() << graphics.rendererName();
  window.makeCurrent();
  EXPECT_EQ(lock.state(), LockState::software);
  EXPECT_EQ(lock.whyNot(), "the driver lacks GLX_NV_swap_group");
}

}  // namespace
}  // namespace carom
