#pragma once
// Carom as a game: the puck that a person has struck is to touch two others. The point is counted when the
// second touch is seen, not when it happens.

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "cave/record/frame_state.h"
#include "engine/game/game_event.h"

namespace carom {

class CaromScore {
 public:
  /// `before`: the score of this game before it was continued.
  explicit CaromScore(const Score& before = {}) : score_(before) {}

  /// Begins a shot: this puck was struck by hand, and the stroke arrives at this board time.
  void struck(std::size_t puck, double arrives_s);

  /// Looks at the collisions whose light has reached `eye`. If the shot has just been seen to be a carom,
  /// returns off how many cushions the struck puck was seen to bounce before its second touch; each shot is
  /// one at most once.
  std::optional<std::size_t> look(std::span<const GameEvent> events, const Event& eye, double c_m_s);

  const Score& score() const { return score_; }

 private:
  struct Shot {
    std::size_t puck = 0;
    double arrives_s = 0.0;
    std::optional<std::size_t> touched;  ///< the first other puck that was seen to be touched
  };
  std::optional<Shot> shot_;
  Score score_;
};

}  // namespace carom
