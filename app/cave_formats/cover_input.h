#pragma once
// The tracking devices, bodies and persons of an OpenCOVER configuration as the people and trackers of a
// room.

#include "app/room_checks/room.h"
#include "app/room_parts/part.h"

namespace carom {

/// Returns the pose of <Offset x y z> (mm) and <Orientation h p r> (degrees): R = Rz(h)·Rx(p)·Ry(r), then the
/// offset (OpenCOVER's inputdevice.cpp and trackingbody.cpp).
Pose coverPose(const Part& whole, Room& room);

/// Adds the person whom <Input> in `cover` has for its default, with the trackers of head and hand.
void readCoverInput(const Part& cover, Room& room);

}  // namespace carom
