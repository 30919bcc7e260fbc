#pragma once
// What a frame's record, its knots and its events can hold: the rules for whatever reads them from outside.

#include <cstdint>

#include "cave/frame/frame_state.h"
#include "engine/billiard/game_event.h"
#include "engine/spacetime/world_line.h"

namespace carom {

/// Each throws std::invalid_argument that names the first impossible field and says what was expected.
/// `gameLightSpeed_m_s`: of the game whose frame it is.
void expectPossible(const FrameRecord& record, double gameLightSpeed_m_s);
void expectPossible(const Knot& knot);
/// `pucks`: how many the game has.
void expectPossible(const GameEvent& event, std::uint64_t pucks);

}  // namespace carom
