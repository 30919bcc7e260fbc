#pragma once
// When each person in the room sees one hit: the first touch of the puck that was struck last. Its light has
// a way of its own to each of them, so that they see it at different moments of the room.

#include <array>
#include <cstddef>
#include <optional>
#include <span>

#include "cave/record/frame_state.h"
#include "engine/game/game_event.h"

namespace carom {

class HitSeen {
 public:
  /// When a viewer saw the hit.
  struct Seen {
    std::size_t viewer = 0;
    double room_s = 0.0;  ///< on the room's clock, by which all presents in the room are simultaneous
  };

  /// Waits for the first touch of this puck at board time `arrives_s` or later.
  void struck(std::size_t puck, double arrives_s);

  /// Looks at a frame in which time passes. Once everybody has seen the hit, returns all viewers in the order
  /// in which they saw it, once.
  std::optional<std::span<const Seen>> look(std::span<const GameEvent> events, const FrameRecord& record);

 private:
  struct Shot {
    std::size_t puck = 0;
    double arrives_s = 0.0;
    std::optional<Event> hit{};
  };
  std::optional<Shot> shot_;
  std::array<Seen, kMostViewers> seen_{};  ///< the first `count_` have seen it
  std::size_t count_ = 0;
  std::array<double, kMostViewers> before_s_{};  ///< how long its light still had to go, in the frame before
  double roomBefore_s_ = 0.0;
};

}  // namespace carom
