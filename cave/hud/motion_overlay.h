#pragma once
// Shows which way the platform moves, how fast, and with what effect. It rests in the room, on the floor
// before the person, and is shown while the platform moves on the board or is driven.
//
// A white circle stands for the speed of light. An arrow from its middle shows the platform's velocity on the
// board; its length is β, so it never reaches the circle. The ellipse inside is the shape that a circle at
// rest on the board has in the room: along the motion it is 1/γ as long. A thinner arrow shows the thrust as
// a fraction of the strongest, in red if more was asked for.

#include <vector>

#include <glm/vec3.hpp>

#include "cave/gl/line_batch.h"
#include "cave/gl/picture.h"
#include "cave/record/frame_state.h"
#include "cave/room/room_geometry.h"
#include "cave/room/wall.h"

namespace carom {

/// Returns γβ of the platform on the board, in the room's axes.
glm::dvec3 platformInRoom_u(const SeenFrame& seen);
/// Returns whether the platform moves or is driven.
bool isDriven(const SeenFrame& seen);

class MotionOverlay {
 public:
  static constexpr double kRadius_m = 0.3;  ///< radius of the circle
  static constexpr double kClear_m = 0.2;   ///< gap between the circle and the front wall
  static constexpr double kSmall_m = 0.15;  ///< radius in a room without a floor

  /// Returns the circle's middle: on the floor, before the front wall. In a room without a floor to show it
  /// on, the circle is small and lies behind that wall's lower right corner, where it is seen below the game.
  static glm::dvec3 middle_m(const RoomGeometry& room);
  static double radius_m(const RoomGeometry& room);

  /// Draws over the picture of `wall` for an eye in the room; costs nothing if there is nothing to draw. The
  /// drawing context must be current here, and when this object is created and destroyed.
  void draw(const RoomGeometry& room, const Wall& wall, const glm::dvec3& eyeInRoom_m, const SeenFrame& seen,
            const RenderTarget& picture);

 private:
  void add(const RoomGeometry& room, const SeenFrame& seen);
  void addLine(const glm::dvec3& from_m, const glm::dvec3& to_m, double halfWidth_m, const glm::vec3& colour);
  void addArrow(const RoomGeometry& room, const glm::dvec3& from_m, const glm::dvec3& along_m,
                double halfWidth_m, const glm::vec3& colour);

  LineBatch ribbons_;
  std::vector<Ribbon> lines_;
};

}  // namespace carom
