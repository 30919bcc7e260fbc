#pragma once
// The two walls of a headset: each is the rectangle, 1 m before an eye, that the eye's display fills.

#include <array>

#include <glm/vec2.hpp>

#include "cave/room/wall.h"
#include "engine/base/pose.h"

namespace carom {

/// What an eye's display fills, as the tangents of angles from the eye's forward axis (-z): to the left and
/// down they are negative, and no two need be equal.
struct EyeFrustum {
  double left = -1.0, right = 1.0, down = -1.0, up = 1.0;
};

/// Where an eye is, and how its display is turned (canted displays are turned outwards). Room frame; eye axes
/// x right, y up, z backwards.
struct HeadsetEye {
  Pose roomFromEye;
  EyeFrustum frustum;
};

/// The walls' names, left and right.
inline constexpr std::array<const char*, 2> kEyeWalls{"left-eye", "right-eye"};

/// Returns the wall that the eye sees exactly through its display, with the pixels of its pictures.
Wall wallBefore(const HeadsetEye& eye, const char* name, glm::ivec2 pixels);

/// Hangs a wall there.
void hang(Wall& wall, const HeadsetEye& eye);

/// Returns the head of a pair of eyes: the point between them, turned as the mean of the eyes, x from the
/// left to the right eye. Both eyes are simultaneous for the head.
Pose headBetween(const std::array<HeadsetEye, 2>& eyes);

}  // namespace carom
