#pragma once
// How the bodies of a scene and of a frame are numbered: 0 is everything that rests on the board, then come
// the pucks, then the scripted bodies, each in the order of the scenario.

#include <cstddef>

#include "engine/spacetime/world_line.h"

namespace carom {

/// The body of all that rests on the board.
inline constexpr std::size_t kRestingBody = 0;
inline constexpr std::size_t kFirstPuck = 1;

/// Returns the world line of what rests on the board.
inline WorldLine restingWorldLine(double lightSpeed_m_s) { return WorldLine(Knot{}, lightSpeed_m_s); }

}  // namespace carom
