#pragma once
// Reads the projections of an SGCT file that show a picture by direction or a cylinder, not a flat wall.

#include <string_view>

#include "app/room_import/sgct_reading.h"

namespace carom {

/// Returns whether a projection of this type is read here.
bool isSgctSky(std::string_view type);

/// Reads the fisheye, equirectangular, cylindrical or spherical mirror projection of a viewport into a wall
/// that has its pixels already. Returns whether the projection was sound.
bool readSgctSky(const JsonNode& viewport, const JsonNode& projection, RoomWall& wall, SgctReading& in);

}  // namespace carom
