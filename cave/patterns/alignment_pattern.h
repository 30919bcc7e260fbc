#pragma once
// A pattern that moves through all walls as one: planes across each axis of the room, drawn where they cut
// the walls. A line that ends at the shared edge of two walls goes on from the same point of the other wall
// at the same moment; a step there is an error of the corners, of the projectors or of the frame lock.

#include <cstddef>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "cave/gl/gl_objects.h"
#include "cave/gl/picture.h"
#include "cave/room/wall.h"

namespace carom {

/// A corner of a screen's triangles: its place in the window, 0 to 1 from the lower left, and in the room.
struct SeamCorner {
  glm::vec2 inWindow;
  glm::vec3 inRoom_m;
};

class AlignmentPattern {
 public:
  static constexpr double kPeriod_m = 0.5;     ///< distance from plane to plane
  static constexpr double kSpeed_m_s = 0.1;    ///< speed along each axis
  static constexpr double kHalfLine_m = 0.01;  ///< half the width of a line on the wall

  /// Made and destroyed with the drawing context current.
  AlignmentPattern();

  /// Draws the planes x = k·kPeriod_m + kSpeed_m_s·time_s in red, those of y in green and those of z in blue.
  /// A curved screen has them at each pixel's own point. Leaves the drawing context's state as it was.
  void draw(const Wall& wall, double time_s, RenderTarget& picture);

 private:
  GlProgram program_;
  VertexStream<SeamCorner> corners_;
};

}  // namespace carom
