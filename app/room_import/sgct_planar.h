#pragma once
// SGCT's planar projections: a flat screen given by angles from the origin instead of by its corners.

#include "app/room_checks/room.h"
#include "app/room_import/sgct_reading.h"

namespace carom {

/// Reads the opening angles, distance, orientation and offset of a PlanarProjection into the corners of the
/// wall. Returns whether they are sound; otherwise errors are noted.
bool readPlanar(const JsonNode& projection, RoomWall& wall, SgctReading& in);

}  // namespace carom
