#pragma once
// Which of two events is first, in a frame that moves on the board.

#include <algorithm>
#include <cstddef>
#include <span>

#include "engine/game/game_event.h"
#include "engine/spacetime/event.h"

namespace carom {

/// Returns which of two events is first in a frame that moves with `beta` on the board: −1 the first, 1 the
/// second, 0 neither. t_b' − t_a' = γ (Δt − β·Δr/c).
inline int firstOf(const Event& a, const Event& b, const Vec3& beta, double c_m_s) {
  const Displacement way = b - a;
  const double later_s = way.dt_s - glm::dot(beta, way.dr_m) / c_m_s;
  return later_s > 0.0 ? -1 : later_s < 0.0 ? 1 : 0;
}

/// Returns the place of an event among some, in the order of such a frame: 1 is first. Simultaneous ones have
/// the same place.
inline std::size_t placeAmong(const Event& event, std::span<const GameEvent> events, const Vec3& beta,
                              double c_m_s) {
  const auto earlier = [&](const GameEvent& other) { return firstOf(other.at, event, beta, c_m_s) < 0; };
  return 1 + static_cast<std::size_t>(std::count_if(events.begin(), events.end(), earlier));
}

}  // namespace carom
