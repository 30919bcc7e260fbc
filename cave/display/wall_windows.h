#pragma once
// The visible windows of a node, which show the pictures of its walls, and the mouse over them.

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cave/cluster/frame_lock.h"
#include "cave/display/parallel_calls.h"
#include "cave/display/wall_pictures.h"
#include "cave/display/window.h"
#include "cave/projection/projector.h"
#include "cave/screen/wall_pointer.h"

namespace carom {

/// Returns the walls, each with its part of one window as its viewport.
std::vector<Wall> placedIn(const std::optional<WindowPlacement>& oneWindow, std::vector<Wall> walls);

class WallWindows {
 public:
  /// Opens the windows of the walls of `pictures`, which must outlive this object: walls with a viewport in
  /// the same place of one node's display share one; with `inOneWindow`, all walls do. If not `visible`, none
  /// opens.
  WallWindows(Graphics& graphics, const WallPictures& pictures, bool visible, bool inOneWindow);

  /// Puts the pictures into the windows, or black; `swap` makes them visible. `over`: draws over them.
  void show(bool black, const std::function<void()>& over);
  void awaitShown();
  void swap();

  /// Returns the point of a wall that the mouse points to; `eyesSwapped` as the pictures are. While the mouse
  /// button is held, the pointer stays with the window in which it was pressed.
  std::optional<PointedWall> pointedAt(bool eyesSwapped) const;
  bool isHeld() const;
  bool isTurning() const;

  /// Returns which of the windows a window manager has moved, and where to.
  std::vector<std::string> misplaced() const;
  /// Returns where the window of a wall lies that has one of its own, with a border.
  std::optional<ScreenPlace> placeOf(const std::string& wall) const;

  /// Creates the lock of the windows' swaps, as the rig asks for it.
  NodeLock lockSwaps(FrameLock asked);

 private:
  /// A window and the walls in it.
  struct WallWindow {
    WindowPlacement placement;
    int node = 0;
    bool shared = false;
    std::vector<std::size_t> walls;
    std::unique_ptr<Window> window;
  };
  void group(bool inOneWindow);
  void swapTogether();
  Viewport placeIn(const WallWindow& window, std::size_t wall) const;
  std::size_t nearestTo(const glm::dvec2& pointer_px, const WallWindow& window) const;
  Pane paneOf(const WallWindow& window, std::size_t wall) const;

  Graphics& graphics_;
  const WallPictures& pictures_;
  std::vector<std::optional<Projection>> projections_;  ///< of each wall
  std::vector<WallWindow> windows_;
  std::unique_ptr<ParallelCalls> swaps_;  ///< of several windows
  std::vector<Pane> panes_;
};

}  // namespace carom
