#pragma once
// What every rank knows of the game before its first frame.

#include <vector>

#include "app/files/scenario.h"
#include "engine/spacetime/world_line.h"

namespace carom {

/// The histories that every rank starts from: what rests on the board, the pucks, the scripted bodies. Knots that
/// the game adds arrive with the frames.
std::vector<WorldLine> startingHistories(const Scenario& scenario);

}  // namespace carom
