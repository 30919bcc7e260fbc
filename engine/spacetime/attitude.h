#pragma once
// How a room is turned, apart from its motion.
// Theory: app/doc/physics.md, The platform.

#include <glm/gtc/quaternion.hpp>

#include "engine/spacetime/lorentz.h"

namespace carom {

/// Returns the room's orientation, which turns its axes into the board's: boardFromRoom is a boost after it.
glm::dquat attitudeOf(const Lorentz& boardFromRoom);

}  // namespace carom
