#pragma once
// A game's event as the frames of a session file keep it: numbers alone, so that any bytes can be read.

#include <array>
#include <cstdint>
#include <optional>

#include "engine/billiard/game_event.h"

namespace carom {

struct StoredEvent {
  struct StoredTurn {
    std::uint64_t puck = 0;
    Event event;
    Vec2 betaBefore{0.0};
    Vec2 betaAfter{0.0};
    double properTime_s = 0.0;
  };
  std::uint64_t number = 0;
  std::uint32_t which = 0;
  std::uint8_t kind = 0;
  std::uint8_t cushion = 0;  ///< 0: none, otherwise one more than its number
  std::uint8_t turnCount = 0;
  std::uint8_t withoutDelay = 0;  ///< 0 in files from before events said so
  Event at;
  double heat_j = 0.0;
  std::array<StoredTurn, 2> turns;
};

StoredEvent stored(const GameEvent& event);

/// None if no game of so many pucks can have made it.
std::optional<GameEvent> restored(const StoredEvent& event, std::uint64_t pucks);

}  // namespace carom
