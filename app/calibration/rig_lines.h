#pragma once
// Poses as lines of a rig.

#include <string>
#include <string_view>

#include <glm/vec3.hpp>

#include "engine/base/pose.h"

namespace carom {

/// Returns the turns about the fixed x, then y, then z axis, in degrees, that make this rotation: what a
/// rig's rotation_deg means. Each is from -180 to 180, the second from -90 to 90.
glm::dvec3 rotation_deg(const glm::dquat& rotation);

/// Returns "key = { translation = [x, y, z], rotation_deg = [a, b, c] }", in the rig's unit, to a hundredth
/// of a millimetre and 0.001 degrees.
std::string poseLine(std::string_view key, const Pose& pose, double unit_m);

/// Returns a length in the rig's unit, to a hundredth of a millimetre.
std::string lengthText(double length_m, double unit_m);

/// Says where each axis of the tracker points in the room: "x to the right (0.3 degrees off), …".
std::string directionWords(const glm::dquat& roomFromTracker, const RoomAxes& axes);

}  // namespace carom
