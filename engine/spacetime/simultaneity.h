#pragma once
// The relation of two events: what all observers agree on, and what depends on the observer.

#include <optional>

#include "engine/spacetime/event.h"

namespace carom {

/// How two events are separated; the same in every frame.
enum class Separation {
  timelike,   ///< one clock can attend both: all observers agree on their order
  lightlike,  ///< light can go from one to the other
  spacelike,  ///< for some observers one is first, for some the other, for some both happen at once
};

/// Returns the name for people: "timelike", "lightlike" or "spacelike".
const char* toString(Separation separation);

/// The relation of two events, computed from their displacement in any one frame.
struct Relation {
  Separation separation = Separation::lightlike;
  /// Timelike: the time that a clock which attends both counts between them, as c τ in metres. Spacelike:
  /// their distance in a frame in which they are simultaneous. Lightlike: 0.
  double length_m = 0.0;
  /// Spacelike: the velocity of the slowest observer for whom they are simultaneous, as v/c in the
  /// displacement's frame, β = c Δt Δr/|Δr|². Timelike: that of the observer for whom they happen at one
  /// place, β = Δr/(c Δt). Lightlike: none.
  std::optional<Vec3> beta;
};

/// Computes the relation. Two events also count as lightlike when rounding cannot tell (an interval below
/// 1e-12 of c²Δt² + Δr²).
Relation relationOf(const Displacement& d, double c_m_s);

}  // namespace carom
