#pragma once
// What a pointer over a window points to: the place of a wall whose picture is there.

#include <cstddef>
#include <optional>

#include <glm/vec2.hpp>

#include "cave/room/wall.h"
#include "engine/spacetime/event.h"

namespace carom {

/// The mouse over a wall's picture.
struct PointedWall {
  Vec3 onWall_m{0.0};     ///< the place of the wall that it points to; room frame
  Eye eye = Eye::middle;  ///< from which that place is seen
};

/// How far the pointer is from the pane; 0 inside.
double outside_px(const Viewport& pane, const glm::dvec2& pointer_px);

/// The place of `wall` that is shown at `pointer_px` of its window (right and down, counted from the window's
/// top left corner), where the wall's picture has the part `pane` of it. None: the pointer is outside;
/// `beyond`: the wall's plane goes on there.
///
/// Where the eyes' pictures lie side by side, or one above the other, the half tells the eye; where they lie
/// over each other, it is the middle one. A projector's mirroring is undone, its warp is not: on a bent
/// screen the place is off by as much as the screen bends.
std::optional<PointedWall> pointedIn(const Wall& wall, const Viewport& pane, const glm::dvec2& pointer_px,
                                     bool beyond = false);

}  // namespace carom
