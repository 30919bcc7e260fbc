#pragma once
// Whose eyes the pictures of a wall are for.

#include <vector>

#include "cave/room/wall.h"

namespace carom {

/// Returns the pictures that a wall with this stereo mode needs: {mono}, {left}, {right} or {left, right}.
std::vector<Eye> eyesOf(StereoMode mode);

/// Returns the eye of each picture that the wall needs.
std::vector<ViewerEye> eyesOf(const Wall& wall);

/// Returns the eye's name in files and messages: "left", "right" or "mono".
const char* nameOf(Eye eye);

}  // namespace carom
