#pragma once
// Reads session files of version 3, which stored frames, knots and events as raw bytes in that program's
// memory layout on x86-64.

#include <cstddef>
#include <span>
#include <vector>

#include "cave/record/frame_state.h"
#include "engine/billiard/game_event.h"
#include "engine/spacetime/world_line.h"

namespace carom::version3 {

/// Each function throws std::runtime_error if the number of bytes is wrong or they cannot be decoded. Whether
/// the values are possible is not checked.
FrameRecord frameOf(std::span<const std::byte> bytes);
Knot knotOf(std::span<const std::byte> bytes);
std::vector<GameEvent> eventsOf(std::span<const std::byte> bytes);

}  // namespace carom::version3
