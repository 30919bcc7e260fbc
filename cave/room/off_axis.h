#pragma once
// The projection of one wall for one eye: the generalised perspective from three corners of the wall
// (R. Kooima, "Generalized Perspective Projection", 2009), in double.

#include <optional>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "cave/room/wall.h"

namespace carom {

/// Places nearer to or farther from the eye than this, in metres along the wall's normal, are clipped. The
/// near value decides the precision of the depth buffer. The range is wide because a fast observer sees
/// things behind them much nearer and things ahead much farther away.
struct ClipRange {
  double near_m = 0.03;
  double far_m = 5000.0;
};

/// Returns a wall's width and height in metres.
glm::dvec2 sizeOf_m(const Wall& wall);

/// An eye closer to a wall's plane than this has no picture on the wall (metres).
inline constexpr double kNearestToWall_m = 1e-3;

/// Returns clipFromEye, which takes a place given from the eye (room axes, metres, as column (x, y, z, 1)) to
/// OpenGL's clip coordinates on that wall: (−1,−1) is its lower left corner, (1,1) its upper right. Returns
/// none if the eye lies on the wall's plane or behind it, or if the corners span no wall.
std::optional<glm::dmat4> clipFromEye(const Wall& wall, const glm::dvec3& eyeInRoom_m,
                                      const ClipRange& range = {});

/// Returns the same for places given in the room: clipFromRoom = clipFromEye · translation(−eye).
std::optional<glm::dmat4> clipFromRoom(const Wall& wall, const glm::dvec3& eyeInRoom_m,
                                       const ClipRange& range = {});

}  // namespace carom
