#include "cave/display/wall_windows.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "cave/display/wall_window.h"
#include "cave/display/window_layout.h"
#include "cave/projection/stereo.h"
#include "cave/texts/format.h"
#include "cave/texts/texts.h"

namespace carom {

std::vector<Wall> placedIn(const std::optional<WindowPlacement>& oneWindow, std::vector<Wall> walls) {
  for (Wall& wall : walls) {
    if (!oneWindow) break;
    wall.viewport = Viewport{wall.window.position_px, wall.window.size_px};
    wall.window = *oneWindow;
  }
  return walls;
}

WallWindows::WallWindows(Graphics& graphics, const WallPictures& pictures, bool visible, bool inOneWindow)
    : graphics_(graphics), pictures_(pictures) {
  if (!visible || pictures.walls().empty()) return;
  for (const Wall& wall : pictures.walls()) projections_.push_back(projectionOf(wall));
  group(inOneWindow);
  keepDisplayAwake();
  for (WallWindow& window : windows_) {
    std::string title;
    bool quadBuffer = false;
    for (const std::size_t wall : window.walls) {
      title += (title.empty() ? "" : ", ") + pictures.walls()[wall].name;
      quadBuffer = quadBuffer || pictures.walls()[wall].stereo == StereoMode::quadBuffer;
    }
    window.window = std::make_unique<Window>(graphics_, texts::format(texts::title::kWalls, title),
                                             window.placement, quadBuffer);
  }
  // Who wears a headset does not wait for a mirror's display.
  const bool waits = !pictures.walls().front().onHead;
  for (const WallWindow& window : windows_) window.window->setVsync(waits);
  if (windows_.size() > 1) swapTogether();
}

/// Settles which walls share a window.
void WallWindows::group(bool inOneWindow) {
  for (std::size_t wall = 0; wall < pictures_.walls().size(); ++wall) {
    const Wall& shown = pictures_.walls()[wall];
    const bool shared = shown.viewport.has_value();
    const auto found = std::find_if(windows_.begin(), windows_.end(), [&](const WallWindow& window) {
      return shared && window.shared && (inOneWindow || window.node == shown.node) &&
             window.placement == shown.window;
    });
    if (found != windows_.end()) {
      found->walls.push_back(wall);
    } else {
      windows_.push_back({shown.window, shown.node, shared, {wall}, nullptr});
    }
  }
}

/// Gives each window's swap a thread, in which its context is current for that time only: a swap may block
/// until the display's next refresh, and one after the other would take as many refreshes as there are
/// windows.
void WallWindows::swapTogether() {
  std::vector<std::function<void()>> swaps;
  for (const WallWindow& window : windows_) {
    swaps.emplace_back([shown = window.window.get()] {
      shown->makeCurrent();
      shown->swap();
      Window::makeNoneCurrent();
    });
  }
  swaps_ = std::make_unique<ParallelCalls>(std::move(swaps));
}

void WallWindows::show(bool black, const std::function<void()>& over) {
  graphics_.finishDrawing();
  for (const WallWindow& window : windows_) {
    panes_.clear();
    // If black, the windows are as black as the screens can be, without the level that black is lifted to.
    for (std::size_t i = 0; i < window.walls.size() && !black; ++i)
      panes_.push_back(paneOf(window, window.walls[i]));
    window.window->show(panes_, over);
  }
}

void WallWindows::awaitShown() {
  graphics_.awaitDrawing();
  for (const WallWindow& window : windows_) window.window->awaitShown();
}

void WallWindows::swap() {
  if (swaps_) {
    graphics_.makeCurrent();  // so that no window's context is current here
    return swaps_->run();
  }
  for (const WallWindow& window : windows_) window.window->swap();
}

Viewport WallWindows::placeIn(const WallWindow& window, std::size_t wall) const {
  const Wall& shown = pictures_.walls()[wall];
  if (shown.viewport) return *shown.viewport;
  const glm::ivec2 size_px = window.window->size_px();
  // A window on a desk can be made larger and smaller; its picture keeps its proportions.
  return shown.window.border ? fitted(shown.window.size_px, size_px) : Viewport{{0, 0}, size_px};
}

Pane WallWindows::paneOf(const WallWindow& window, std::size_t wall) const {
  const Viewport place = placeIn(window, wall);
  const std::span<const WallPictures::WallEye> eyes = pictures_.eyesOf(wall);
  return {&eyes[0].pictures.shown(),
          eyes.size() > 1 ? &eyes[1].pictures.shown() : nullptr,
          pictures_.walls()[wall].stereo,
          place.position_px,
          place.size_px,
          projections_[wall] ? &*projections_[wall] : nullptr};
}

std::size_t WallWindows::nearestTo(const glm::dvec2& pointer_px, const WallWindow& window) const {
  return *std::min_element(window.walls.begin(), window.walls.end(), [&](std::size_t a, std::size_t b) {
    return outside_px(placeIn(window, a), pointer_px) < outside_px(placeIn(window, b), pointer_px);
  });
}

std::optional<PointedWall> WallWindows::pointedAt(bool eyesSwapped) const {
  for (const WallWindow& window : windows_) {
    const bool held = window.window->isHeld() || window.window->isTurning();
    const auto pointer_px = (isHeld() || isTurning()) && !held ? std::nullopt : window.window->pointer_px();
    if (!pointer_px) continue;
    const std::size_t nearest = nearestTo(*pointer_px, window);
    const Wall& wall = pictures_.walls()[nearest];
    // A pointer that is held continues beyond the edge of the wall, as when a cue is drawn back.
    auto pointed = pointedIn(wall, placeIn(window, nearest), *pointer_px, held);
    if (!pointed) continue;
    pointed->viewer = wall.viewer;
    if (pointed->eye != Eye::middle) {
      const std::span<const WallPictures::WallEye> eyes = pictures_.eyesOf(nearest);
      const ViewerEye& eye = (pointed->eye == Eye::right ? eyes.back() : eyes.front()).eye;
      pointed->eye = eye.eye;
      pointed->viewer = eye.viewer;
    }
    if (eyesSwapped) pointed->eye = otherOf(pointed->eye);
    return pointed;
  }
  return std::nullopt;
}

bool WallWindows::isHeld() const {
  return std::any_of(windows_.begin(), windows_.end(),
                     [](const WallWindow& window) { return window.window->isHeld(); });
}

bool WallWindows::isTurning() const {
  return std::any_of(windows_.begin(), windows_.end(),
                     [](const WallWindow& window) { return window.window->isTurning(); });
}

std::vector<std::string> WallWindows::misplaced() const {
  std::vector<std::string> found;
  for (const WallWindow& window : windows_) {
    const std::string words = window.window->misplaced();
    if (!words.empty())
      found.push_back(
          fmt::format("the window of wall {} is {}", pictures_.walls()[window.walls.front()].name, words));
  }
  return found;
}

std::optional<ScreenPlace> WallWindows::placeOf(const std::string& wall) const {
  for (const WallWindow& window : windows_) {
    const bool isIts = !window.shared && pictures_.walls()[window.walls.front()].name == wall;
    if (isIts && window.placement.border) return window.window->place();
  }
  return std::nullopt;
}

NodeLock WallWindows::lockSwaps(FrameLock asked) {
  if (asked == FrameLock::software) return {};
  std::vector<SwapGroupCalls::Drawable> drawables;
  for (const WallWindow& window : windows_) drawables.push_back(window.window->drawable());
  if (!windows_.empty()) windows_.front().window->makeCurrent();
  return NodeLock(swapGroupOfDriver(), std::move(drawables));
}

}  // namespace carom
