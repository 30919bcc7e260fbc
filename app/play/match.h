#pragma once
// Carom between the people in one room: each one's score, and whose turn it is.
//
// A stroke passes the turn to the next; one who then sees their own shot become a carom has the turn again,
// unless somebody has struck meanwhile. Striking out of turn is allowed: a stroke is a turn taken, so that a
// visitor who has left the room stops no game.

#include <array>
#include <cstddef>
#include <optional>
#include <span>

#include "app/play/carom_score.h"
#include "cave/record/frame_state.h"

namespace carom {

class Match {
 public:
  Match() = default;
  /// Goes on from what a record holds of each viewer.
  explicit Match(const FrameRecord& before);

  /// Begins a shot of a viewer, of `viewers` in the room: this puck was struck by their hand, and the stroke
  /// arrives at this board time.
  void struck(std::size_t viewer, std::size_t viewers, std::size_t puck, double arrives_s);

  /// Looks at the collisions whose light has reached that viewer's `eye` (CaromScore::look).
  std::optional<std::size_t> look(std::size_t viewer, std::span<const GameEvent> events, const Event& eye,
                                  double c_m_s);

  /// Writes everybody's score and turn.
  void putInto(FrameRecord& record) const;

 private:
  std::array<CaromScore, kMostViewers> scores_;
  std::size_t turn_ = 0;    ///< the viewer whose turn it is
  std::size_t latest_ = 0;  ///< the viewer who struck last
};

}  // namespace carom
