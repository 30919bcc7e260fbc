#pragma once
// A pattern that moves through all walls as one: planes across each axis of the room, drawn where they cut
// the walls. A line that ends at the shared edge of two walls goes on from the same point of the other wall
// at the same moment; a step there is an error of the corners, of the projectors or of the frame lock.

#include <glm/vec3.hpp>

#include "cave/gl/gl_objects.h"
#include "cave/gl/picture.h"
#include "cave/room/wall.h"

namespace carom {

class AlignmentPattern {
 public:
  static constexpr double kPeriod_m = 0.5;     ///< distance from plane to plane
  static constexpr double kSpeed_m_s = 0.1;    ///< speed along each axis
  static constexpr double kHalfLine_m = 0.01;  ///< half the width of a line on the wall

  /// Made and destroyed with the drawing context current.
  AlignmentPattern();

  /// Draws the planes x = k·kPeriod_m + kSpeed_m_s·time_s in red, those of y in green and those of z in blue.
  /// Leaves the drawing context's state as it was.
  void draw(const Wall& wall, double time_s, RenderTarget& picture) const;

 private:
  GlProgram program_;
  GlVertexArray vertexArray_;
};

}  // namespace carom
