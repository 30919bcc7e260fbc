#pragma once
// The state of the game that every rank knows before the first frame.

#include <vector>

#include "app/scenario/scenario.h"
#include "engine/spacetime/world_line.h"

namespace carom {

/// Returns the initial histories on every rank: the resting body (board and hall), the pucks, the scripted
/// bodies. Knots that the game adds arrive with the frames.
std::vector<WorldLine> startingHistories(const Scenario& scenario);

}  // namespace carom
