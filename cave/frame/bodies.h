#pragma once
// The numbers of the bodies in a scene and in a frame: body 0 is everything at rest on the board; then come
// the pucks and the scripted bodies, each in the order of the scenario.

#include <cstddef>

#include "engine/spacetime/world_line.h"

namespace carom {

/// The body that stands for everything at rest on the board.
inline constexpr std::size_t kRestingBody = 0;
inline constexpr std::size_t kFirstPuck = 1;

/// Returns the world line of everything at rest on the board.
inline WorldLine restingWorldLine(double lightSpeed_m_s) { return WorldLine(Knot{}, lightSpeed_m_s); }

}  // namespace carom
