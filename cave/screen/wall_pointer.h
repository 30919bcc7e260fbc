#pragma once
// Finds the place of a wall to which a pointer over a window points.

#include <cstddef>
#include <optional>

#include <glm/vec2.hpp>

#include "cave/room/wall.h"
#include "engine/spacetime/event.h"

namespace carom {

/// The mouse over a wall's picture.
struct PointedWall {
  Vec3 onWall_m{0.0};      ///< the place on the wall that it points to; room frame
  Eye eye = Eye::middle;   ///< the eye from which that place is seen
  std::size_t viewer = 0;  ///< whose eye it is, an index of the rig's viewers
  /// Of a picture by direction, the place in the room from which it is seen; none: that eye's.
  std::optional<Vec3> from_m{};
};

/// Returns how far the pointer is outside the pane, in pixels; 0 inside.
double outside_px(const Viewport& pane, const glm::dvec2& pointer_px);

/// Returns the place of `wall` that is shown at `pointer_px` of its window (right and down, counted from the
/// window's top left corner), if `pane` is the part of the window with the wall's picture. Returns none if
/// the pointer is outside the pane; with `beyond`, the wall's plane continues there.
///
/// If the eyes' pictures lie side by side, or one above the other, the half tells which eye it is; if they
/// overlap, it is the middle eye. A projector's mirroring is undone, and the homography of a skewed screen,
/// but not its warp mesh: on a bent screen the place is wrong by as much as the screen bends.
std::optional<PointedWall> pointedIn(const Wall& wall, const Viewport& pane, const glm::dvec2& pointer_px,
                                     bool beyond = false);

}  // namespace carom
