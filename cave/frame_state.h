#pragma once
// One drawn frame's record: all that a node needs to draw its walls. Rank 0 decides it, every rank holds the
// same bytes.

#include <cstdint>
#include <limits>
#include <span>
#include <type_traits>
#include <vector>

#include "cave/wall_controls.h"
#include "engine/observer.h"
#include "engine/switches.h"
#include "engine/world_line.h"

namespace carom {

/// A knot that a body's history has gained. Bodies are numbered as in the scene.
struct BodyKnot {
  std::uint64_t body = 0;
  Knot knot;
};

struct FrameRecord {
  std::uint64_t number = 0;
  double display_s = 0.0;  ///< session clock: when the light of this frame leaves the walls
  ObserverView observer{Lorentz(1.0), {}, 0.0};
  /// The pucks, bodies 1 to `pucks`, forget the knots whose turn is at or after this board time, before the
  /// new ones are added.
  double truncateFrom_s = std::numeric_limits<double>::infinity();
  std::uint64_t pucks = 0;
  /// Then the pucks forget the legs that ended before this board time: no eye will see them any more.
  double forgetBefore_s = -std::numeric_limits<double>::infinity();
  std::uint64_t last = 0;  ///< 1: the session ends after this frame
  Switches switches;       ///< which effects are drawn
  WallControls controls;   ///< what else the operator has chosen
};
static_assert(std::is_trivially_copyable_v<FrameRecord> && std::is_trivially_copyable_v<BodyKnot>);

/// The record and the knots that came with it.
struct FrameState {
  FrameRecord record;
  std::vector<BodyKnot> knots;
};

/// Brings the histories up to the frame: truncates, appends, forgets.
void applyFrame(const FrameState& state, std::span<WorldLine> histories);

}  // namespace carom
