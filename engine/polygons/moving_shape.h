#pragma once
// A disc or a body with corners in straight flight, c = 1, and where it is on the board.

#include <vector>

#include "engine/polygons/outline.h"
#include "engine/spacetime/minkowski.h"

namespace carom {

/// A body in straight flight that turns uniformly.
struct MovingShape {
  Vec21 start;
  Vec21 u{1.0, 0.0, 0.0};
  double radius = 0.0;               ///< of the disc, or of the farthest corner
  const Outline* outline = nullptr;  ///< none: a disc
  double angle = 0.0;                ///< at the start
  double turning = 0.0;              ///< radians in a metre of own time
};

/// Returns the four-velocity of the frame in which both move with equal and opposite speeds.
Vec21 equalSpeedFrame(const Vec21& u1, const Vec21& u2);

/// Returns where the corners are on the board at board time `t`.
std::vector<glm::dvec2> cornersOnBoard(const MovingShape& flight, double t);

/// Returns whether two bodies, at least one with corners, overlap on the board at board time `t` by
/// more than a millionth of a millionth of their radii.
bool overlapOnBoard(const MovingShape& first, const MovingShape& second, double t);

}  // namespace carom
