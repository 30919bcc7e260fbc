#pragma once
// What helps the person and the operator in a session, drawn over the pictures of the walls in the room's own
// frame: it stays where it stands whatever moves on the board.
//
// Warning grid: where the head or the hand comes near a wall, a grid in the wall's plane says where the
// screen is, for a person who sees through it.
//
// Tracker crosses: at the place of the hand's and of the head's sensor, and before the eyes. A cross that
// does not sit on the sensor in the hand is an error of the tracker's place in the room or of the walls'. The
// person's own head sensor cannot be seen: the cross 1 m before the eyes must go with the nose. Taken off and
// held to a wall, the sensor must lie on its cross, from wherever one looks: what is in a wall's plane has no
// parallax.
//
// Stereo check: with the crosses, on the front wall, two bars that only the eyes' difference tells apart: the
// right one stands before the wall, the left one behind it.

#include <vector>

#include <glm/vec3.hpp>

#include "cave/frame/frame_state.h"
#include "cave/gl/line_batch.h"
#include "cave/gl/picture.h"
#include "cave/room/room_geometry.h"
#include "cave/room/wall.h"

namespace carom {

/// The point of a wall that is nearest to a place in the room.
struct NearestOnWall {
  glm::dvec2 place_m{0.0};  ///< from the wall's lower left, along its lower and its left edge
  double distance_m = 0.0;
};
NearestOnWall nearestOn(const Wall& wall, const glm::dvec3& place_m);

/// How strongly a wall at this distance is warned of: 0 to 1.
double warningAt(double distance_m);

class RoomOverlay {
 public:
  // Who moves unseen at 1 m/s and needs 0.3 s to notice and 0.3 m to stop, stops at the wall; within an arm's bend
  // of it the warning is full.
  static constexpr double kWarnFrom_m = 0.6, kWarnFully_m = 0.3;
  static constexpr double kGrid_m = 0.1, kHalfLine_m = 0.003;  ///< between lines; half a line's width
  static constexpr double kReach_m = 0.7;                      ///< of the grid, around the nearest point
  static constexpr double kAxis_m = 0.1, kHalfAxis_m = 0.004;  ///< of a cross; half its lines' width
  static constexpr double kAhead_m = 1.0;                      ///< of the cross before the eyes
  static constexpr double kBarsOff_m = 0.3;                    ///< before and behind the wall

  /// Made and destroyed with the drawing context current.
  RoomOverlay();
  ~RoomOverlay();
  RoomOverlay(const RoomOverlay&) = delete;
  RoomOverlay& operator=(const RoomOverlay&) = delete;

  /// Over the picture of `wall` for an eye in the room; `isFront`: it has the stereo check. Costs nothing
  /// where there is nothing to draw.
  void draw(const RoomGeometry& room, const Wall& wall, bool isFront, const glm::dvec3& eyeInRoom_m,
            const FrameRecord& record, const RenderTarget& picture);

 private:
  void drawGrid(const Wall& wall, const FrameRecord& record, const RenderTarget& picture) const;
  void drawMarks(const RoomGeometry& room, const Wall& wall, bool isFront, const glm::dvec3& eyeInRoom_m,
                 const FrameRecord& record, const RenderTarget& picture);
  void addCross(const Pose& roomFromCross);
  void addBars(const Wall& wall, const glm::dvec3& eyes_m);

  unsigned program_ = 0, vertexArray_ = 0;
  LineBatch ribbons_;
  std::vector<Ribbon> marks_;
};

}  // namespace carom
