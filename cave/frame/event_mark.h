#pragma once
// How an event of the game is called wherever it is marked: on flags, on beads, in sentences.

#include <cstddef>
#include <span>
#include <string>

#include "engine/game/game_event.h"

namespace carom {

/// Returns the name of a flash where it has at most two letters, as "A"; else the event's number. `flashes`:
/// the names of the game's flashes, in their order.
inline std::string eventMark(const GameEvent& event, std::span<const std::string> flashes) {
  constexpr std::size_t kShortName = 2;
  const bool isNamed = event.kind == EventKind::flash && event.which < flashes.size() &&
                       !flashes[event.which].empty() && flashes[event.which].size() <= kShortName;
  return isNamed ? flashes[event.which] : std::to_string(event.number);
}

}  // namespace carom
