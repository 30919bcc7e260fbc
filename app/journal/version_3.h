#pragma once
// Session files of version 3: frames, knots and events lie there byte by byte, as the program of then held
// them on x86-64.

#include <cstddef>
#include <span>
#include <vector>

#include "cave/frame/frame_state.h"
#include "engine/billiard/game_event.h"
#include "engine/spacetime/world_line.h"

namespace carom::version3 {

/// Each throws std::runtime_error if there are not as many bytes as expected, or not such as can be read;
/// whether the values are possible is not checked.
FrameRecord frameOf(std::span<const std::byte> bytes);
Knot knotOf(std::span<const std::byte> bytes);
std::vector<GameEvent> eventsOf(std::span<const std::byte> bytes);

}  // namespace carom::version3
