#pragma once
// The blows that a hand feels: the arrival of its own stroke at the puck, and the contacts of that puck, each
// when its light reaches the eyes.

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "cave/record/frame_state.h"
#include "engine/game/game_event.h"

namespace carom {

class SeenBlows {
 public:
  /// Waits for what happens to the puck that the viewer has struck, from its arrival at `arrives_s` on.
  void struck(std::size_t puck, double arrives_s) { shot_ = {puck, arrives_s}; }

  /// Returns the changes of momentum whose light reached the viewer's eyes after the frame before and until
  /// this one, in units of m c, in the room's axes. Nothing while time stands still, runs backwards or jumps.
  std::span<const Vec3> look(std::span<const GameEvent> events, const FrameRecord& record,
                             std::size_t viewer);

 private:
  struct Shot {
    std::size_t puck = 0;
    double arrives_s = 0.0;
  };
  std::optional<Shot> shot_;
  std::optional<Event> before_;
  std::vector<Vec3> seen_;
};

/// Returns the change of a puck's momentum in an event, in units of its m c; on the board. Soft pucks turn
/// only later: theirs is that of an elastic blow of equal masses at the speed at which they touch. None if
/// the puck takes no part.
std::optional<Vec3> changeOf(const GameEvent& event, std::size_t puck);

}  // namespace carom
