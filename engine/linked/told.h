#pragma once
// What one room tells the others, as values.

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "engine/base/limits.h"
#include "engine/game/billiard_setup.h"
#include "engine/spacetime/event.h"

namespace carom {

/// The most strokes of a room in one game.
inline constexpr std::uint32_t kMostStrokesTold = 20000;

/// The name of a person to whom no rig gives one.
inline constexpr std::string_view kUnnamed = "viewer";

/// A person at the moment of a present. Board events.
struct PersonTold {
  Event promise;  ///< nothing that this person will do lies outside its future (promise.h)
  Event head;     ///< the point between the eyes
  Event hand;     ///< as it is drawn
  double properTime_s = 0.0;
};

/// A room after one of its frames.
struct Present {
  std::uint64_t number = 0;   ///< from 1 on; a later present has a higher one
  std::uint32_t strokes = 0;  ///< the number of the room's strokes so far
  bool waits = false;         ///< its people did not live on in this frame
  std::array<PersonTold, kMostViewers> persons;
  std::size_t size = 0;  ///< of `persons`
};

/// A stroke by hand. Its hand's place is always given.
struct StrokeTold {
  std::uint32_t number = 0;  ///< counts the room's strokes in a game from 0
  std::uint32_t viewer = 0;
  Stroke stroke;

  /// Returns the event at which the hand strikes.
  Event event() const { return {stroke.at_s, *stroke.from_m}; }
};

}  // namespace carom
