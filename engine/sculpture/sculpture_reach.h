#pragma once
// How much of a game's past the sculpture of its spacetime can show.

#include <algorithm>
#include <cmath>

#include "engine/sculpture/sculpture_place.h"

namespace carom {

/// Returns how far from the present board times matter for every frame in which it can be shown: in a frame
/// of β an event at the foot is γ (past + β x/c) before the present on the board.
inline double sculptureReach_s(const SculpturePlace& place, double c_m_s) {
  constexpr double kAside_m = 2.0;
  return (place.past_s + kAside_m / c_m_s) /
         std::sqrt((1.0 - kMostSculptureBeta) * (1.0 + kMostSculptureBeta));
}

/// Returns the same for what stays within `away_m` of the present event on the board: c Δt = −h/γ + β·Δr for
/// an event at the depth h below the present, so that no frame needs more than past + |Δr|/c.
inline double reachWithin_s(const SculpturePlace& place, double c_m_s, double away_m) {
  return std::min(sculptureReach_s(place, c_m_s), place.past_s + away_m / c_m_s);
}

}  // namespace carom
