#pragma once
// Checks of the values in a frame's record, its knots and its events, for all code that reads them from
// outside.

#include <cstdint>

#include "cave/record/frame_state.h"
#include "engine/game/game_event.h"
#include "engine/linked/told_path.h"
#include "engine/spacetime/world_line.h"

namespace carom {

/// Each function throws std::invalid_argument that names the first impossible field and the expectation.
/// `gameLightSpeed_m_s`: speed of light in the game that the frame belongs to.
void expectPossible(const FrameRecord& record, double gameLightSpeed_m_s);
void expectPossible(const Knot& knot);
void expectPossible(const ToldMoment& moment);
/// `pucks`: number of pucks in the game.
void expectPossible(const GameEvent& event, std::uint64_t pucks);

}  // namespace carom
