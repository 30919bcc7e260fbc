#pragma once
// The game as rank 0 plays it: the billiard, ahead of what anyone can see, and what of it is new each frame.

#include <vector>

#include "app/scenario.h"
#include "cave/frame_state.h"
#include "engine/billiard.h"

namespace carom {

/// The histories that every rank starts from: what rests on the board, the pucks, the told bodies. Knots that
/// the game adds arrive with the frames.
std::vector<WorldLine> startingHistories(const Scenario& scenario);

class Game {
 public:
  explicit Game(const Scenario& scenario);

  /// Plays on to board time `t_s` and adds to `state` the knots that no frame has carried yet.
  void advance(double t_s, FrameState& state);

 private:
  Billiard billiard_;
};

}  // namespace carom
