#pragma once
// Finds the events of a game that become visible from one frame to the next, so that they can be heard at the
// moment they are seen: sound itself is so much slower than light that it would always be late.

#include <vector>

#include "engine/game/game_event.h"
#include "engine/light/switches.h"
#include "engine/spacetime/event.h"
#include "engine/spacetime/observer.h"

namespace carom {

/// An event that is heard now.
struct Heard {
  EventKind kind = EventKind::puckPuck;
  Vec3 seen_m{0.0};       ///< where it is seen, relative to the point between the eyes, in the room's axes
  double loudness = 0.0;  ///< 0 to 1: by the change of the pucks' γβ, and by the distance at which it is seen
  double doppler = 1.0;  ///< ν_heard/ν_emitted for a source at rest on the board
};

/// Fills `heard` with those of `events` whose light reaches the point between the eyes after the frame
/// `before` and until `now`: they are in the past cone of the second observation event but not in that of the
/// first. The past cones of a person's events lie within each other, so each event is heard once, even if it
/// is taken back and comes again unchanged; an event that is new is heard when its light arrives. Without
/// retardation, events are heard when they happen. Flashes make no sound, nor do soft pucks
/// when they part or their far sides hear of it, and there is no sound while the
/// person's time stands still, runs backwards or jumps.
void heardBetween(const ObserverView& before, const ObserverView& now, const Switches& switches,
                  const std::vector<GameEvent>& events, std::vector<Heard>& heard);
inline constexpr double kLeap_s = 0.9;  ///< a jump: this much board time from frame to frame

}  // namespace carom
