#pragma once
// Which events of a game become perceptible from one frame to the next, so that they can be heard just when
// they are seen: sound itself, so much slower than light, would never be in time.

#include <vector>

#include "engine/billiard/game_event.h"
#include "engine/light/switches.h"
#include "engine/spacetime/event.h"
#include "engine/spacetime/observer.h"

namespace carom {

/// An event that is heard now.
struct Heard {
  EventKind kind = EventKind::puckPuck;
  Vec3 seen_m{0.0};       ///< where it is seen from between the eyes, in the room's axes
  double loudness = 0.0;  ///< 0 to 1: by the change of the pucks' γβ, and how far away it is seen
  double doppler = 1.0;   ///< ν_heard/ν_emitted of what rests on the board
};

/// Those of `events` whose light reaches the point between the eyes after the frame `before` and until `now`:
/// that are in the past cone of the one observation event and not of the other's. Past cones of a person's
/// events lie within each other, so each event is heard once, even if it is taken back and comes again as it
/// was; one that comes anew is heard when its light comes. Without retardation, when it happens. Flashes make
/// no sound, and there is none where the person's time stands still, runs back or leaps.
void heardBetween(const ObserverView& before, const ObserverView& now, const Switches& switches,
                  const std::vector<GameEvent>& events, std::vector<Heard>& heard);
inline constexpr double kLeap_s = 0.9;  ///< of board time from frame to frame

}  // namespace carom
