#pragma once
// Aids for the person and the operator during a session, drawn over the pictures of the walls in the room's
// own frame: they keep their place in the room whatever moves on the board.
//
// Warning grid: when the head or the hand comes near a wall, a grid in the wall's plane shows where the
// screen is, since the person otherwise looks through it.
//
// Tracker crosses: one at the hand's sensor, one at the head's sensor, and one before the eyes. A cross that
// does not coincide with the sensor in the hand shows an error in the placement of the tracker or of the
// walls. A person cannot see their own head sensor; instead, the cross 1 m before the eyes must follow the
// nose. When the head sensor is taken off and held to a wall, it must coincide with its cross from every
// viewpoint, since what lies in a wall's plane has no parallax.
//
// Stereo check, shown with the crosses: two bars on the front wall that differ only in their disparity. The
// right bar stands before the wall, the left one behind it.

#include <vector>

#include <glm/vec3.hpp>

#include "cave/gl/gl_objects.h"
#include "cave/gl/line_batch.h"
#include "cave/gl/picture.h"
#include "cave/record/frame_state.h"
#include "cave/room/room_geometry.h"
#include "cave/room/wall.h"

namespace carom {

/// The point of a wall that is nearest to a place in the room.
struct NearestOnWall {
  glm::dvec2 place_m{0.0};  ///< from the wall's lower left, along its lower and its left edge
  double distance_m = 0.0;
};
NearestOnWall nearestOn(const Wall& wall, const glm::dvec3& place_m);

/// Returns how strong the warning of a wall at this distance is: 0 to 1.
double warningAt(double distance_m);

class RoomOverlay {
 public:
  // A person who moves at 1 m/s without noticing, and needs 0.3 s to react and 0.3 m to stop, stops at the
  // wall; within the reach of a bent arm the warning is full.
  static constexpr double kWarnFrom_m = 0.6, kWarnFully_m = 0.3;
  static constexpr double kGrid_m = 0.1, kHalfLine_m = 0.003;  ///< spacing of lines; half a line's width
  static constexpr double kReach_m = 0.7;  ///< extent of the grid around the nearest point
  static constexpr double kAxis_m = 0.1, kHalfAxis_m = 0.004;  ///< of a cross; half its lines' width
  static constexpr double kAhead_m = 1.0;                      ///< distance of the cross before the eyes
  static constexpr double kBarsOff_m = 0.3;  ///< distance of the bars before and behind the wall

  /// Create and destroy it with the drawing context current.
  RoomOverlay();

  /// Draws over the picture of `wall` for an eye in the room; costs nothing if there is nothing to draw.
  /// `isFront`: the wall shows the stereo check.
  void draw(const RoomGeometry& room, const Wall& wall, bool isFront, const glm::dvec3& eyeInRoom_m,
            const SeenFrame& seen, const RenderTarget& picture);

 private:
  void drawGrid(const Wall& wall, const SeenFrame& seen, const RenderTarget& picture) const;
  void drawMarks(const RoomGeometry& room, const Wall& wall, bool isFront, const glm::dvec3& eyeInRoom_m,
                 const SeenFrame& seen, const RenderTarget& picture);
  void addCross(const Pose& roomFromCross);
  void addBars(const Wall& wall, const glm::dvec3& eyes_m);

  GlProgram program_;
  int sizeAt_, warningsAt_;  // places of its uniforms
  GlVertexArray vertexArray_;
  LineBatch ribbons_;
  std::vector<Ribbon> marks_;
};

}  // namespace carom
