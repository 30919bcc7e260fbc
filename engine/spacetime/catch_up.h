#pragma once
// How long the points of a body take to catch up with a leg (kCatchUpSpeed).
// Theory: app/doc/physics.md, Bounce and catching up.

#include "engine/spacetime/knot.h"

namespace carom {

/// Returns an upper bound of how long a point takes, in the rest frame of the turn, to catch up with the leg
/// of `knot` from at most `gap_m` away, in a body of that radius.
double catchUpAtMost_s(const Knot& knot, double gap_m, double radius_m, double c_m_s);

}  // namespace carom
