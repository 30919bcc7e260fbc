#pragma once
// Where a moment of an observer cuts the world tube of a puck: the events of its top rim on the observer's
// past light cone, which are the rim as it is seen; on the plane of the observer's present; or on that of the
// board's.

#include <vector>

#include "engine/light/light_cone.h"
#include "engine/spacetime/world_line.h"

namespace carom {

/// Points of a body's rim, from its centre in its rest frame.
using Rim = std::vector<Vec3>;

/// Sets `events` to those of the rim's points, in the board's frame; none if the body does not exist yet at
/// one of them. `view` is memory that is used again. All effects are on, whatever the walls show.
void cutRim(const Rim& rim, const WorldLine& line, const Event& observation, const Lorentz& headFromBoard,
            ViewTime moment, BodyView& view, std::vector<Event>& events);

}  // namespace carom
