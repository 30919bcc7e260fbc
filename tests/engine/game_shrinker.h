#pragma once
// The smallest game that still shows what is wrong with a larger one.

#include <functional>

#include "engine/random_game.h"

namespace carom::test {

/// Leaves out strokes, then pucks, then the board, friction and time, as long as `isWrong` stays true of what
/// is left. Tries at most `tries` games.
RandomGame shrunk(const RandomGame& game, const std::function<bool(const RandomGame&)>& isWrong,
                  int tries = 400);

}  // namespace carom::test
