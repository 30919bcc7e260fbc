#pragma once
// The places of a HEVS configuration's displays: a transform moves each, and some are parts of a cylinder or
// domes. The file is left-handed, x right, y up, z forward; here all has z back.

#include <optional>

#include "app/room_checks/room.h"
#include "app/room_parts/part.h"
#include "cave/screen/screen_shape.h"
#include "engine/base/pose.h"

namespace carom {

/// Returns where the axes of a display or tracker are in the room, by its `transform`: an object, or the name
/// of one of the platform's `transforms`. Angles are Unity's: about z, then x, then y. Adds errors for wrong
/// values, and a warning for a scale, which is left out.
Pose hevsPlaceOf(const Part& object, const Part& platform, Room& room);

/// Returns the screen of a display of type curved: from angle_start as far to the right as both angles differ
/// (CurvedDisplay.cs of HEVS), with its foot at ground_offset. Returns nothing, with an error noted, if its
/// values make none.
std::optional<CylinderScreen> hevsCylinder(const Part& display, const Pose& place, Room& room);

/// Returns the screen of a display of type dome: a hemisphere about the direction ahead of the display's own
/// axes, whose upper edge is that of the window (DomeDisplay.cs of HEVS). Returns nothing, with a finding
/// noted, if its values make none, or it takes several projectors or a calibration file to show it.
std::optional<DomeScreen> hevsDome(const Part& display, const Pose& place, Room& room);

}  // namespace carom
