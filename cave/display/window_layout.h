#pragma once
// Where the windows with a border lie: none upon another, each whole on one monitor.

#include <optional>
#include <span>
#include <vector>

#include "cave/display/monitors.h"
#include "cave/room/wall.h"

namespace carom {

/// A window that is to be placed.
struct FreeWindow {
  glm::ivec2 wanted_px{0};  ///< its size if there is room
  glm::ivec2 least_px{0};   ///< smaller than this it cannot be used
  /// Where it lay last, or where its rig wants it: it lies there again if that place is free and on a
  /// monitor.
  std::optional<ScreenPlace> at{};
  bool keepsShape = false;  ///< a picture: if there is less room, it is scaled
};

/// What a window manager draws around a window: the title above, edges elsewhere.
inline constexpr int kTitle_px = 34, kEdge_px = 6;

/// Returns the place of each window, without its title and edges, so that no two windows meet and each lies
/// within one of the monitors' areas. `taken` lie where they are. Earlier windows have the first choice; all
/// want less, down to 2/5 of their size, until each has its least size; if that is not enough, the others do
/// not get their own places. Empty for a window for which there is no room even then.
std::vector<std::optional<ScreenPlace>> arranged(std::span<const FreeWindow> windows,
                                                 std::span<const ScreenPlace> taken,
                                                 std::span<const ScreenPlace> areas);

/// Returns the largest part in the middle of a window of size `window_px` that has the proportions of
/// `shape_px`; the whole window if that is a pixel larger at most.
Viewport fitted(const glm::ivec2& shape_px, const glm::ivec2& window_px);

}  // namespace carom
