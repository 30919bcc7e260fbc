#pragma once
// Where the flat pictures of an MPCDI room are: by the angles of a frustum, or as parts of a whole.

#include <optional>

#include <glm/vec2.hpp>

#include "app/room_parts/part.h"
#include "app/room_parts/room_parts.h"

namespace carom {

inline constexpr double kMpcdiAway_m = 3.0;    ///< of the walls that stand for pictures
inline constexpr double kMpcdiHeight_m = 2.0;  ///< of the whole picture of the profile 2d

/// Returns the pixels of a region or buffer, by either of the names that they go by; none, with an error
/// noted, if they are missing.
std::optional<glm::ivec2> mpcdiPixels(const Part& region, Room& room);

/// Returns the corners of a wall that a region's frustum passes through, kMpcdiAway_m from its point, where
/// the first viewer's eyes are. None, with an error noted, if the frustum or its frame is not whole.
std::optional<ReadCorners> cornersByAngles(const Part& region, Room& room);

/// Returns the corners of a region's part of a buffer's picture, which the file puts nowhere: it is ahead at
/// the height of the eyes. None, with an error noted, if the part or the buffer has no size.
std::optional<ReadCorners> cornersByShare(const Part& region, const Part& buffer, Room& room);

}  // namespace carom
