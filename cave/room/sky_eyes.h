#pragma once
// Whose eyes see a wall's picture by direction: such a picture, of no screen, is for one place, and its two
// eyes face its front wherever a head may look.

#include <optional>

#include <glm/vec3.hpp>

#include "engine/spacetime/observer.h"

namespace carom {

struct SkyEyes {
  std::optional<glm::dvec3> from_m;  ///< a place that rests in the room; none: the tracked head
  glm::dvec3 right{1.0, 0.0, 0.0};   ///< unit vector of the room, from the left eye to the right
};

/// Returns what these eyes see, at the moment of a viewer's own view. They are as far apart as the viewer's.
ObserverView viewOf(const SkyEyes& sky, const ObserverView& viewer, const Lorentz& boardFromRoom,
                    double room_s);

}  // namespace carom
