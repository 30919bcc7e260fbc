#pragma once
// What can be said of two events by everyone, and what depends on who says it.

#include <optional>

#include "engine/spacetime/event.h"

namespace carom {

/// How two events are separated; the same in every frame.
enum class Separation {
  timelike,   ///< one clock can attend both: their order is the same for everyone
  lightlike,  ///< light can go from one to the other
  spacelike,  ///< for some observers one is first, for some the other, for some both happen at once
};

/// For people: "timelike", "lightlike", "spacelike".
const char* toString(Separation separation);

/// Of two events, from their displacement in any one frame.
struct Relation {
  Separation separation = Separation::lightlike;
  /// Timelike: how long a clock that attends both runs between them, c τ in metres. Spacelike: their distance
  /// where they happen at once. Lightlike: 0.
  double length_m = 0.0;
  /// Spacelike: the slowest observer for whom they happen at once, v/c in the displacement's frame,
  /// β = c Δt Δr/|Δr|². Timelike: the one for whom they happen at one place, β = Δr/(c Δt). Lightlike: none.
  std::optional<Vec3> beta;
};

/// Events nearer to each other's light cone than rounding can tell (1e-12 of c²Δt² + Δr²) count as lightlike.
Relation relationOf(const Displacement& d, double c_m_s);

}  // namespace carom
