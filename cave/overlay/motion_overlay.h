#pragma once
// Which way the platform goes, how fast, and what that does: at rest in the room, on the floor before the
// person, while the platform moves on the board or is driven.
//
// A white circle: light's speed. An arrow from its middle: the platform's way on the board, as long as its β,
// so that it never reaches the circle. Within the circle, the ellipse as which a circle at rest on the board
// is in the room, 1/γ as long along the motion. A thinner arrow: the thrust, as a share of the strongest, red
// where more was asked for.

#include <vector>

#include <glm/vec3.hpp>

#include "cave/frame/frame_state.h"
#include "cave/gl/line_batch.h"
#include "cave/gl/picture.h"
#include "cave/room/room_geometry.h"
#include "cave/room/wall.h"

namespace carom {

/// γβ of the platform on the board, in the room's axes.
glm::dvec3 platformInRoom_u(const FrameRecord& record);
/// Whether the platform moves, or is driven.
bool isDriven(const FrameRecord& record);

class MotionOverlay {
 public:
  static constexpr double kRadius_m = 0.3;  ///< of the circle
  static constexpr double kClear_m = 0.2;   ///< between it and the front wall
  static constexpr double kSmall_m = 0.15;  ///< radius in a room without a floor

  /// Where its middle is: on the floor, before the front wall. In a room that has no floor to see it on:
  /// small, behind that wall's lower right corner, where it is seen below the game.
  static glm::dvec3 middle_m(const RoomGeometry& room);
  static double radius_m(const RoomGeometry& room);

  /// Over the picture of `wall` for an eye in the room. Costs nothing where there is nothing to draw. Within
  /// the drawing context, which has to be current when this is made and destroyed, too.
  void draw(const RoomGeometry& room, const Wall& wall, const glm::dvec3& eyeInRoom_m,
            const FrameRecord& record, const RenderTarget& picture);

 private:
  void add(const RoomGeometry& room, const FrameRecord& record);
  void addLine(const glm::dvec3& from_m, const glm::dvec3& to_m, double halfWidth_m, const glm::vec3& colour);
  void addArrow(const RoomGeometry& room, const glm::dvec3& from_m, const glm::dvec3& along_m,
                double halfWidth_m, const glm::vec3& colour);

  LineBatch ribbons_;
  std::vector<Ribbon> lines_;
};

}  // namespace carom
