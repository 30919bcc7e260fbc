#pragma once
// The picture of spacetime: a frame's x, y and c t as three lengths, so that light in the plane of the board
// rises at 45 degrees. The board's height is left out.

#include "engine/spacetime/event.h"
#include "engine/spacetime/lorentz.h"

namespace carom {

/// Board times between which something is shown.
struct Span {
  double from_s = 0.0, until_s = 0.0;
};

/// A frame whose origin is the event `about`.
struct SpacetimeFrame {
  Lorentz frameFromBoard;
  Event about;

  /// Returns where an event of the board's frame lies: (x, y, c t) in this frame, metres.
  Vec3 at(const Event& onBoard) const {
    const Displacement d = frameFromBoard * (onBoard - about);
    return {d.dr_m.x, d.dr_m.y, frameFromBoard.lightSpeed_m_s() * d.dt_s};
  }
};

}  // namespace carom
